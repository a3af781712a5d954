"""Code versions change with what can change a run, and with nothing else."""

import subprocess
import sys
from pathlib import Path

from reibench.household import load_room
from reibench.household.rooms import save_room
from reibench.run import RunSpec
from reibench.version import code_version

ROOT = Path(__file__).parents[1]


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


def elsewhere(program):
    """Return what a process of its own prints: within one, a version is worked out once."""
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, timeout=60,
        check=True,
    )  # fmt: skip
    return done.stdout


def test_importing_a_room_changes_the_version(tmp_path, monkeypatch):
    monkeypatch.setenv("REIBENCH_ROOMS", str(tmp_path))
    asking = "from reibench.version import code_version; print(code_version('reibench.rollout'))"
    before = elsewhere(asking)
    save_room(load_room("kitchen-1"), tmp_path / "kitchen-9.json")
    assert elsewhere(asking) != before


def test_many_may_ask_for_versions_at_once():
    """As people do who arrive together at a server that has just started."""
    said = elsewhere("""
import gc, sys
from concurrent.futures import ThreadPoolExecutor
from reibench.version import code_version

class Cycle:  # whose end runs Python, and so lets another thread go on
    def __init__(self):
        self.me = self
    def __del__(self):
        sum(range(50))

def ask(number):
    for _ in range(50):
        Cycle()
    return code_version("reibench.rollout", f"reibench.view.none{number}")

sys.setswitchinterval(1e-6)
gc.set_threshold(50)
with ThreadPoolExecutor(8) as pool:
    print(len(set(pool.map(ask, range(24)))))
""")
    assert said == "1\n"
