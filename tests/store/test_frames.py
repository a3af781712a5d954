"""Frames lie beside the database, by record and step, and go with the attempt that made them."""

from dataclasses import replace

import pytest

from reibench.errors import StoreUnavailable
from reibench.planners import Decision
from reibench.rollout import Rollout
from reibench.run import RunSpec
from reibench.skill import parse_skill
from reibench.store import Store
from reibench.worlds import Frame

SPEC = RunSpec(planner="expert", world="ai2thor:stand-in")


class Picturing:
    """The embedded world, with pictures in its events as a world that renders has them."""

    def __init__(self, world):
        self.skills = world.skills
        self.reset = lambda task: self.seen(world.reset(task))
        self.step = lambda skill: self.seen(world.step(skill))
        self.count = 0

    def seen(self, event):
        self.count += 1
        pair = (Frame("robot", b"eye %d" % self.count), Frame("above", b"map %d" % self.count))
        return replace(event, frames=pair)


@pytest.fixture
def begun(world, store, episode):
    rollout = Rollout(episode, Picturing(world))
    record = store.begin(SPEC, episode)
    store.started(record, rollout.start())
    store.add_step(record, rollout, rollout.step(Decision(parse_skill("find a potato"))))
    return record


def test_frames_of_the_start_and_of_each_step_are_found_again(store, begun, tmp_path):
    again = Store(store.path).frames
    assert again.find(begun, 0, "robot").read_bytes() == b"eye 1"
    assert again.find(begun, 1, "above").read_bytes() == b"map 2"
    assert again.find(begun, 1, "above") == tmp_path / "records.db-frames" / begun / "1-above.png"
    assert again.find(begun, 2, "above") is None
    assert again.cameras(begun, 1) == ("robot", "above")
    assert again.cameras(begun, 2) == ()


def test_an_attempt_that_was_cut_short_takes_its_frames_along(store, begun, episode):
    assert store.begin(SPEC, episode) == begun
    assert store.frames.cameras(begun, 0) == ()


def test_a_disk_that_takes_no_frames_is_said_and_the_step_is_not_there(
    store, begun, world, episode
):
    (store.path.parent / "records.db-frames" / "blocked").write_text("")
    rollout = Rollout(episode, Picturing(world))
    event = rollout.start()
    with pytest.raises(StoreUnavailable, match="Cannot write to the database"):
        store.started("blocked", event)


def test_records_say_which_world_they_were_made_in(store, begun):
    [entry] = store.entries()
    assert entry.world == "ai2thor:stand-in"
