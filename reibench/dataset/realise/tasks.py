"""Tasks for realised dialogues: any goal of any room, in the paper's proportions of types."""

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from random import Random

from reibench.dataset.forms import names, says
from reibench.dataset.seeds import PROPORTIONS, Seed, options
from reibench.episode import Goal, SceneSetup, Task, TaskType
from reibench.errors import ReibenchError
from reibench.household import Room

STARTS = 1000
"""How many places the robot may start from."""
Solvable = Callable[[Task], bool]


def tasks(rooms: Sequence[Room], seed: int, solvable: Solvable) -> Iterator[Seed]:
    """Yield tasks without end; the n-th is the same whatever came of those before.

    Args:
        rooms: where they may be.
        seed: decides.
        solvable: whether a task works out in its room; asked once for each goal and room.

    Raises:
        ReibenchError: when nothing can be asked for in these rooms.
    """
    there = _by_object(rooms)
    if not there:
        known = ", ".join(room.name for room in rooms) or "none"
        raise ReibenchError(f"Nothing can be asked for in these rooms: {known}.")
    present = {room.name: tuple(sorted({o.type for o in room.objects})) for room in rooms}
    weights = [PROPORTIONS[task_type] for task_type in there]
    works: dict[tuple[Goal, str], bool] = {}
    number = 0
    while True:
        choose = Random(f"{seed}/{number}")
        for _ in range(STARTS):
            [task_type] = choose.choices(list(there), weights)
            name = choose.choice(list(there[task_type]))
            goal, room = choose.choice(there[task_type][name])
            setup = SceneSetup(room.name, choose.randrange(STARTS))
            task = Task(f"realised_{seed}_{number}", setup, goal)
            if (goal, room.name) not in works:
                works[goal, room.name] = solvable(task)
            if works[goal, room.name]:
                yield Seed(task, present[room.name])
                break
        else:
            raise ReibenchError("None of these rooms' tasks can be solved.")
        number += 1


def _alike(goal: Goal) -> bool:
    """Whether the names of the two task objects cannot be told apart: a tissue box in a box."""
    pair = (goal.object, goal.movable_receptacle)
    if not goal.movable_receptacle:
        return False
    one, other = (names()[name].words for name in pair)
    return any(says(a, b) or says(b, a) for a in one for b in other)


Options = dict[TaskType, dict[str, list[tuple[Goal, Room]]]]


def _by_object(rooms: Sequence[Room]) -> Options:
    """Return what could be asked for, by task type and object, so that no object is rare."""
    found: Options = {}
    for task_type in PROPORTIONS:
        mine: dict[str, list[tuple[Goal, Room]]] = defaultdict(list)
        for goal, room in options(rooms, task_type):
            if not _alike(goal):
                mine[goal.object].append((goal, room))
        if mine:
            found[task_type] = dict(mine)
    return found
