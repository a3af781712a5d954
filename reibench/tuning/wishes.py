"""What lessons ask for: every thing, and every place the skills know, as often as it takes.

The shipped tasks ask for what is usual; a person may also want the cold apple in the microwave and
the washed fork in the bath. What never occurs in lessons is not learnt.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from random import Random

from reibench.dataset.seeds import CARE, PROPORTIONS, Seed
from reibench.episode import Goal, SceneSetup, Task, TaskType
from reibench.household import Room
from reibench.household.objects import object_type
from reibench.skill import PICKABLE, RECEPTACLES

STARTS = 1000
"""How many places the robot may start from."""
MORE = {TaskType.STACK: 1.6}
"""How much more often than in the paper's proportions: things in things are hardest."""
BY_PLACE = 0.5
"""How often the place is chosen first, so that none is rare; otherwise the thing is."""
BASIN_OF = {"Sink": "SinkBasin", "Bathtub": "BathtubBasin"}
_SOURCE = {TaskType.HEAT: "Microwave", TaskType.COOL: "Fridge", TaskType.CLEAN: "Sink"}
"""Where a thing is after its treatment anyway."""
_LAMPS = ("DeskLamp", "FloorLamp")

Wishes = dict[TaskType, list[tuple[Goal, Room]]]


def wishes(rooms: Sequence[Room], seed: int) -> Iterator[Seed]:
    """Yield tasks without end; the n-th is the same whatever came of those before."""
    there = {task_type: _wishes(rooms, task_type) for task_type in PROPORTIONS}
    there = {task_type: found for task_type, found in there.items() if found}
    present = {room.name: tuple(sorted({thing.type for thing in room.objects})) for room in rooms}
    weights = [PROPORTIONS[task_type] * MORE.get(task_type, 1) for task_type in there]
    by_object = {task_type: _by(found, "object") for task_type, found in there.items()}
    by_place = {task_type: _by(found, "destination") for task_type, found in there.items()}
    number = 0
    while True:
        choose = Random(f"wish/{seed}/{number}")
        [task_type] = choose.choices(list(there), weights)
        among = (by_place if choose.random() < BY_PLACE else by_object)[task_type]
        goal, room = choose.choice(among[choose.choice(list(among))])
        setup = SceneSetup(room.name, choose.randrange(STARTS))
        yield Seed(Task(f"wish_{seed}_{number}", setup, goal), present[room.name])
        number += 1


def _by(found: list[tuple[Goal, Room]], part: str) -> dict[str, list[tuple[Goal, Room]]]:
    parts: dict[str, list[tuple[Goal, Room]]] = defaultdict(list)
    for goal, room in found:
        parts[getattr(goal, part)].append((goal, room))
    return dict(parts)


def _wishes(rooms: Sequence[Room], task_type: TaskType) -> list[tuple[Goal, Room]]:
    return [(goal, room) for room in rooms for goal in _goals(room, task_type)]


def _goals(room: Room, task_type: TaskType) -> Iterator[Goal]:
    present = {thing.type for thing in room.objects}
    source = _SOURCE.get(task_type, "")
    if source and BASIN_OF.get(source, source) not in present:
        return
    for name in sorted(present & set(CARE.get(task_type, PICKABLE))):
        if task_type is TaskType.EXAMINE:
            yield from (Goal(task_type, name, lamp) for lamp in _LAMPS if lamp in present)
        elif task_type is TaskType.STACK:
            yield from _stacks(room, name, present)
        else:
            for place in _places(room, name):
                if place not in (name, source):
                    yield Goal(task_type, name, place)


def _stacks(room: Room, name: str, present: set[str]) -> Iterator[Goal]:
    for holder in sorted(present & set(PICKABLE) & set(RECEPTACLES) - {name}):
        if object_type(name).belongs(holder):
            for place in _places(room, holder):
                if place != name and place not in PICKABLE:
                    yield Goal(TaskType.STACK, name, place, holder)


def _places(room: Room, name: str) -> Iterator[str]:
    """Yield the places of the room where such a thing may go, but none lies now."""
    now = {parent.split("|")[0] for o in room.objects if o.type == name for parent in o.parents}
    present = {thing.type for thing in room.objects if thing.receptacle}
    for place in RECEPTACLES:
        real = BASIN_OF.get(place, place)
        belongs = object_type(name).belongs(real) or object_type(name).belongs(place)
        if real in present and place not in now and real not in now and belongs:
            yield place
