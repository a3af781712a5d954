"""ALFRED's trials: `traj_data.json` files as tasks, plans and episodes."""

from reibench.dataset.alfred.episodes import episodes_of, task_of
from reibench.dataset.alfred.furniture import in_names_of
from reibench.dataset.alfred.plan import PlanInSkills
from reibench.dataset.alfred.trial import Ask, PlanAction, Trial, find_trials, read_trial

__all__ = [
    "Ask",
    "PlanAction",
    "PlanInSkills",
    "Trial",
    "episodes_of",
    "find_trials",
    "in_names_of",
    "read_trial",
    "task_of",
]
