"""Code versions change with what can change a run, and with nothing else."""

from reibench.household import load_room
from reibench.household.rooms import save_room
from reibench.run import RunSpec
from reibench.version import code_version


def test_methods_and_planners_have_versions_of_their_own():
    specs = [RunSpec(model="scripted:x", method=method) for method in ("none", "tocc")]
    assert len({spec.versioned().code for spec in [*specs, RunSpec(planner="expert")]}) == 3


def test_what_a_run_never_imports_does_not_change_its_version():
    rollout = code_version("reibench.rollout")
    assert rollout == code_version("reibench.rollout", "reibench.worlds")
    assert rollout != code_version("reibench.rollout", "reibench.planners.saycan")


def test_the_version_is_the_same_each_time():
    spec = RunSpec(model="scripted:x")
    assert spec.versioned() == spec.versioned()
    assert spec.versioned().id != spec.id


def test_importing_a_room_changes_the_version(tmp_path, monkeypatch):
    monkeypatch.setenv("REIBENCH_ROOMS", str(tmp_path))
    # Undecorated: within one process a version is worked out once.
    before = code_version.__wrapped__("reibench.rollout")
    save_room(load_room("kitchen-1"), tmp_path / "kitchen-9.json")
    assert code_version.__wrapped__("reibench.rollout") != before
