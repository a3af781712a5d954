"""Tasks for realised dialogues."""

from collections import Counter
from itertools import islice

import pytest

from reibench.dataset.realise.tasks import tasks
from reibench.dataset.seeds import PROPORTIONS
from reibench.errors import ReibenchError
from reibench.household import load_room, room_names


@pytest.fixture(scope="module")
def rooms():
    return [load_room(name) for name in room_names()]


def test_types_come_in_the_papers_proportions(rooms):
    counts = Counter(s.task.goal.task_type for s in islice(tasks(rooms, 1, lambda t: True), 2000))
    for task_type, share in PROPORTIONS.items():
        assert abs(counts[task_type] / 2 - share) < 30, task_type


def test_more_tasks_begin_with_the_same_ones(rooms):
    few = list(islice(tasks(rooms, 3, lambda t: True), 5))
    assert list(islice(tasks(rooms, 3, lambda t: True), 9))[:5] == few


def test_what_cannot_be_solved_is_left_out_and_asked_once_only(rooms):
    asked = Counter()

    def no_stacking(task):
        asked[task.goal, task.setup.room] += 1
        return not task.goal.movable_receptacle

    made = list(islice(tasks(rooms, 3, no_stacking), 300))
    assert not any(seed.task.goal.movable_receptacle for seed in made)
    assert set(asked.values()) == {1}


def test_rooms_without_tasks_are_refused(rooms):
    with pytest.raises(ReibenchError, match="Nothing can be asked for in these rooms: none"):
        next(tasks([], 1, lambda t: True))
    with pytest.raises(ReibenchError, match="None of these rooms' tasks can be solved"):
        next(tasks(rooms, 1, lambda t: False))
