"""A visitor whose Unity dies loses nothing: the next click finds the room as it was."""

import os
import signal

import pytest

from reibench.errors import WorldBroken
from reibench.run import RunSpec
from reibench.sittings import Sittings


@pytest.fixture
def sittings(episodes, store, mark, monkeypatch):
    monkeypatch.setenv("REIBENCH_UNITY_ARGUMENTS", mark)
    spec = RunSpec(world="ai2thor:stand-in")
    made = Sittings(list(episodes.values()), store, lambda name: None, spec=spec)
    yield made
    made.close()


def test_after_a_crash_the_visitor_goes_on_from_the_last_committed_step(
    sittings, running, solution
):
    sitting = sittings.open("ann", "heat_potato.mixed-noised")
    assert sitting.cameras == ("robot", "above")
    sitting = sittings.step(sitting.id, "ann", solution[0], 1)
    [process] = running()
    os.kill(process, signal.SIGKILL)
    with pytest.raises(WorldBroken, match="Unity ended by itself during PickupObject"):
        sittings.step(sitting.id, "ann", solution[1], 2)
    assert running() == []
    assert sittings.current("ann") == sitting
    for number, skill in enumerate(solution[1:], start=2):
        sitting = sittings.step(sitting.id, "ann", skill, number)
    assert sitting.event.solved
    assert len(running()) == 1
    sittings.done(sitting.id, "ann", len(solution) + 1)
    assert running() == []


def test_a_planner_whose_unity_dies_leaves_an_error_record(sittings, running, episode):
    watch = sittings.watch("ann", episode.id, "none", "", planner="expert")
    for sitting in watch:
        if len(sitting.steps) == 2 and sitting.status is None:
            os.kill(running()[0], signal.SIGKILL)
    assert (sitting.status, len(sitting.steps)) == ("error", 2)
    assert "Unity ended by itself" in sitting.error
    assert running() == []


def test_few_processes_are_kept_and_visitors_find_their_rooms_again(
    sittings, running, episodes, monkeypatch
):
    monkeypatch.setattr("reibench.pool.JUST_LENT", 0.0)
    names = list(episodes)[:6]
    made = [sittings.open(f"visitor {n}", name) for n, name in enumerate(names)]
    assert len(running()) == 4
    for number, sitting in enumerate(made):
        skill = "find a cabinet" if "potato" in sitting.episode.id else "find a pencil"
        after = sittings.step(sitting.id, f"visitor {number}", skill, 1)
        assert len(after.steps) == 1
        assert len(running()) == 4


def test_an_episode_begun_in_another_world_is_not_gone_on_with_in_this_one(
    sittings, store, episodes, running
):
    embedded = Sittings(list(episodes.values()), store, lambda name: None)
    before = embedded.open("ann", "heat_potato.mixed-noised")
    here = sittings.open("ann", "heat_potato.mixed-noised")
    assert (before.world, here.world) == ("embedded", "ai2thor:stand-in")
    assert here.id != before.id
    assert sittings.step(before.id, "ann", "find a potato", 1).cameras == ()
    assert len(running()) == 1
