"""Shared pieces: shipped episodes, real worlds, a temporary store, a script instead of a model."""

import os
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from reibench.__main__ import main
from reibench.backends import Backend
from reibench.backends.opening import open_backend
from reibench.backends.scripted import ScriptedBackend
from reibench.dataset.files import shipped_episodes
from reibench.dataset.sample import select
from reibench.episode import Episode
from reibench.household import room_names
from reibench.methods import Instruction
from reibench.planners import Decision
from reibench.planners.expert import Expert
from reibench.rollout import Rollout, drive
from reibench.skill import parse_skill
from reibench.store import Store
from reibench.worlds import World, worlds

# Rooms that happen to have been imported on this machine are none of the tests' business.
os.environ["REIBENCH_ROOMS"] = str(Path(__file__).parent / "no-imported-rooms")
# Nor are prefixes that models have evaluated here before.
# Two test processes that each compute on every core mostly wait for each other.
if "PYTEST_XDIST_WORKER" in os.environ:
    os.environ.setdefault("OMP_NUM_THREADS", "1")
CACHE = tempfile.TemporaryDirectory(prefix="reibench-cache-")
os.environ["REIBENCH_CACHE"] = CACHE.name
SHARED = Path(os.environ.get("REIBENCH_SHARED", Path(__file__).parents[1] / ".." / "shared"))


HOT_POTATO = f"scripted:{Path(__file__).with_name('hot_potato.toml')}"
"""A model that does one task, heating a potato, with any planner and method."""


@pytest.fixture(scope="session")
def episodes() -> dict[str, Episode]:
    """Return the 54 that set the standard: small enough to play all of them."""
    return {episode.id: episode for episode in select(shipped_episodes(), "gold")}


@pytest.fixture(scope="session")
def shipped() -> list[Episode]:
    """Return all 2,700."""
    return shipped_episodes()


@pytest.fixture
def episode(episodes) -> Episode:
    return episodes["heat_potato.mixed-noised"]


@pytest.fixture
def world() -> Iterator[World]:
    made = worlds.create("embedded")
    yield made
    made.close()


@pytest.fixture
def store(tmp_path) -> Store:
    return Store(tmp_path / "records.db")


@pytest.fixture
def script() -> Callable[..., ScriptedBackend]:
    """Make a backend that gives the answers in turn."""
    return lambda *answers: ScriptedBackend(answers)


@pytest.fixture
def click(world) -> Callable[..., Rollout]:
    """Play an episode by hand: skills in words, one after another."""

    def play(episode: Episode, *skills: str, max_steps: int = 30) -> Rollout:
        rollout = Rollout(episode, world, max_steps=max_steps)
        rollout.start()
        for text in skills:
            rollout.step(Decision(parse_skill(text)))
        return rollout

    return play


@pytest.fixture(scope="session")
def solution(episodes) -> tuple[str, ...]:
    """Return the skills, in words, that solve `episode`."""
    task = episodes["heat_potato.mixed-noised"].task
    rollout = Rollout(episodes["heat_potato.mixed-noised"], worlds.create("embedded"))
    rollout.start()
    told = Instruction(text="", original="")
    return tuple(s.decision.skill.text for s in drive(rollout, Expert(task.goal), told))


@pytest.fixture(scope="session")
def gemma() -> Iterator[Backend]:
    """Open one small real model for all tests that need one."""
    opened = open_backend("llama-cpp:gemma-3-270m")
    yield opened
    opened.close()


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Return the folder of real AI2-THOR files, which is not part of this repository."""
    folder = SHARED / "data"
    if not folder.exists():
        if os.environ.get("CI"):
            pytest.fail(f"CI needs {folder}; set REIBENCH_SHARED to where the real files are")
        pytest.skip(f"no real AI2-THOR files at {folder}; REIBENCH_SHARED says where they are")
    return folder


@pytest.fixture(scope="session")
def imported(shared_data, tmp_path_factory) -> Path:
    """Import every real room into a folder of its own, by the command."""
    folder = tmp_path_factory.mktemp("rooms")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("REIBENCH_ROOMS", str(folder))
        assert main(["import", "ithor", str(shared_data / "ithor")]) == 0
    return folder


@pytest.fixture
def real_rooms(imported, monkeypatch) -> tuple[str, ...]:
    """Make the real rooms known by name, and return their names."""
    monkeypatch.setenv("REIBENCH_ROOMS", str(imported))
    return tuple(name for name in room_names() if name.startswith("FloorPlan"))
