import pytest

from reibench.bench.worlds import (
    RoomSimulator,
    course,
    memory_of_worlds,
    share_that_works,
    time_side_by_side,
)
from reibench.worlds.rules import STRICT
from reibench.worlds.thor import ThorWorld


@pytest.mark.parametrize("objects", [25, 50])
def test_every_step_of_the_working_course_works_each_time(objects):
    run = course(objects)
    world = ThorWorld(RoomSimulator(run.room), STRICT)
    for _ in range(2):
        world.reset(run.task)
        assert all(world.step(skill).success for skill in run.plan)
        assert len(run.plan) > 3
    assert 0.2 < share_that_works(run) < 0.8


def test_all_ways_to_the_same_world_are_timed_side_by_side():
    rates = time_side_by_side(course(25), steps=40)
    assert list(rates) == ["embedded", "fifo", "fifo, frames", "wsgi", "wsgi, frames"]
    assert all(each.visits > 1 and each.working > 1 for each in rates.values())
    # Over a wire an action takes a millisecond; in this process a tenth of that.
    assert rates["embedded"].working > rates["fifo"].working > rates["fifo, frames"].working


def test_the_memory_of_worlds_is_not_that_of_who_asks():
    held = bytearray(200_000_000)
    held[::4096] = b"." * len(held[::4096])
    assert 10 < memory_of_worlds(2) < 100
