"""Code versions change with what can change a run, and with nothing else."""

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
