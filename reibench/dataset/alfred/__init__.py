"""ALFRED's trials: `traj_data.json` files as tasks, plans and episodes."""

from reibench.dataset.alfred.trial import Ask, PlanAction, Trial, find_trials, read_trial

__all__ = ["Ask", "PlanAction", "Trial", "find_trials", "read_trial"]
