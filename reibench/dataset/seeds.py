"""Seed tasks: which goal in which room, so that types, things, places and rooms are spread.

The proportions are those of the paper's evaluation subset (appendix A.2); what may be asked is what
ALFRED asks and a person would: nobody keeps a vase in the fridge.
"""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from random import Random

from reibench.episode import Goal, SceneSetup, Task, TaskType
from reibench.household import Room
from reibench.household.objects import object_type

PROPORTIONS = {
    TaskType.PICK: 185,
    TaskType.STACK: 184,
    TaskType.CLEAN: 162,
    TaskType.HEAT: 168,
    TaskType.COOL: 168,
    TaskType.EXAMINE: 133,
}
"""Of a thousand tasks (table of the sampled subset)."""
ROOM_KINDS = {
    TaskType.PICK: ("kitchen", "living room", "bedroom", "bathroom"),
    TaskType.STACK: ("kitchen", "living room", "bedroom"),
    TaskType.CLEAN: ("kitchen", "bathroom"),
    TaskType.HEAT: ("kitchen",),
    TaskType.COOL: ("kitchen",),
    TaskType.EXAMINE: ("living room", "bedroom"),
}
"""Where ALFRED asks for each type."""
_CARE = {
    TaskType.HEAT: "Apple Bread Cup Egg Mug Plate Potato Tomato",
    TaskType.COOL: "Apple Bowl Bread Cup Egg Lettuce Mug Pan Plate Pot Potato Tomato WineBottle",
    TaskType.CLEAN: "Apple Bowl ButterKnife Cloth Cup DishSponge Egg Fork Kettle Knife Ladle"
    " Lettuce Mug Pan Plate Pot Potato SoapBar Spatula Spoon Tomato",
}
CARE = {task_type: tuple(names.split()) for task_type, names in _CARE.items()}
"""What ALFRED heats, cools and cleans."""
_KINDS = {
    "food": "Apple Bread Egg Lettuce Potato Tomato",
    "dish": "Bowl Cup Mug Plate",
    "cookware": "Kettle Pan Pot",
    "cutlery": "ButterKnife Fork Knife Ladle Spatula Spoon",
    "bottle": "Bottle WineBottle",
    "shaker": "PepperShaker SaltShaker",
    "cleaning": "Cloth DishSponge SoapBar SoapBottle SprayBottle",
    "bath": "Candle HandTowel Plunger TissueBox ToiletPaper",
    "desk": "AlarmClock Book CD CellPhone CreditCard KeyChain Laptop Newspaper Pen Pencil"
    " RemoteControl Watch",
    "leisure": "BaseballBat BasketBall Box Pillow Statue TennisRacket Vase WateringCan",
}
_PLACES = {
    "food": "CounterTop DiningTable Fridge SideTable Sink",
    "dish": "CounterTop DiningTable Cabinet Shelf Sink SideTable CoffeeTable Desk CoffeeMachine",
    "cookware": "StoveBurner CounterTop Cabinet Sink DiningTable Shelf",
    "cutlery": "Drawer CounterTop DiningTable Sink SideTable",
    "bottle": "Fridge CounterTop Cabinet DiningTable Shelf",
    "shaker": "CounterTop DiningTable Cabinet Drawer Shelf SideTable",
    "cleaning": "CounterTop Cabinet Drawer Sink Bathtub GarbageCan Shelf Toilet",
    "bath": "CounterTop Shelf Cabinet Drawer Toilet ToiletPaperHanger GarbageCan SideTable Dresser",
    "desk": "Desk Drawer Shelf CoffeeTable SideTable Dresser Sofa ArmChair Bed Safe GarbageCan"
    " Ottoman DiningTable",
    "leisure": "Bed Sofa ArmChair Shelf Dresser SideTable CoffeeTable Desk Ottoman Cabinet",
}
"""Where people put things of a kind away, of the places the skills know."""
_HOLDERS = {
    "food": "Bowl Plate Pan Pot",
    "cutlery": "Bowl Cup Mug Pan Plate Pot",
    "dish": "Plate Bowl",
    "cleaning": "Bowl Box Pan Pot Plate",
    "bath": "Box Bowl Plate",
    "desk": "Bowl Box Mug Plate",
    "leisure": "Box",
}
"""What things of a kind are put into to be carried."""
_HOLDER_PLACES = {
    "Bowl": "CounterTop DiningTable Fridge Shelf SideTable CoffeeTable Desk Dresser Sink",
    "Box": "Bed Sofa ArmChair Shelf SideTable CoffeeTable Desk Dresser Cabinet Ottoman",
    "Cup": "CounterTop DiningTable Cabinet Fridge Sink SideTable Shelf",
    "Mug": "CounterTop DiningTable Shelf Desk SideTable Cabinet Dresser CoffeeTable",
    "Pan": "StoveBurner CounterTop DiningTable Fridge Sink",
    "Plate": "CounterTop DiningTable Fridge SideTable CoffeeTable Sink Desk",
    "Pot": "StoveBurner CounterTop DiningTable Fridge Sink",
}
_KIND_OF = {name: kind for kind, names in _KINDS.items() for name in names.split()}
_WORN = {"object": 3.0, "pair": 8.0, "destination": 0.5, "room": 2.0, "holder": 1.5}
"""How much it costs to use something again."""

Solvable = Callable[[Task], bool]


@dataclass(frozen=True)
class Seed:
    """A task that waits for its dialogue."""

    task: Task
    present: tuple[str, ...]
    """The object types of the room: what may be spoken of as being there."""


def choose_seeds(
    rooms: Sequence[Room], number: int, seed: int, solvable: Solvable, taken: Sequence[Task] = ()
) -> list[Seed]:
    """Choose `number` tasks, those `taken` counted in; the same arguments give the same tasks.

    Args:
        rooms: where they may be.
        number: how many there are to be in all.
        seed: decides among equals.
        solvable: whether a task works out in its room, as the expert finds.
        taken: tasks that are there already; things they use count as used.
    """
    choose = Random(seed)
    used = _Used(choose)
    for task in taken:
        used.note(task.goal, task.setup.room)
    counts = Counter(task.goal.task_type for task in taken)
    chosen: list[Seed] = []
    for task_type, share in shares(number).items():
        left = list(options(rooms, task_type))
        while counts[task_type] < share and left:
            goal, room = min(left, key=used.cost)
            left.remove((goal, room))
            task = Task(used.name(goal), SceneSetup(room.name, choose.randrange(1000)), goal)
            if solvable(task):
                used.note(goal, room.name)
                counts[task_type] += 1
                chosen.append(Seed(task, tuple(sorted({thing.type for thing in room.objects}))))
    return chosen


def shares(number: int) -> dict[TaskType, int]:
    """Return how many tasks of each type make the paper's proportions, by largest remainders."""
    total = sum(PROPORTIONS.values())
    exact = {kind: number * part / total for kind, part in PROPORTIONS.items()}
    shares = {kind: int(value) for kind, value in exact.items()}
    by_remainder = sorted(exact, key=lambda kind: shares[kind] - exact[kind])
    for kind in by_remainder[: number - sum(shares.values())]:
        shares[kind] += 1
    return shares


class _Used:
    """What has been used how often, so that the next is something else."""

    def __init__(self, choose: Random) -> None:
        self._choose = choose
        self._times: Counter[tuple[str, ...]] = Counter()
        self._ties: dict[tuple[Goal, str], float] = {}

    def note(self, goal: Goal, room: str) -> None:
        """Count what a task uses."""
        for _, key in self._keys(goal, room):
            self._times[key] += 1

    def cost(self, option: tuple[Goal, Room]) -> float:
        """Return how worn a task would be; ties fall by chance, but always the same."""
        goal, room = option
        tie = self._ties.setdefault((goal, room.name), self._choose.random())
        keys = self._keys(goal, room.name)
        return tie + sum(_WORN[kind] * self._times[key] for kind, key in keys)

    def name(self, goal: Goal) -> str:
        """Return an id for a task, e.g. `heat_potato_3`."""
        via = f"_{goal.movable_receptacle}" if goal.movable_receptacle else ""
        stem = f"{goal.task_type.short}_{goal.object}{via}".lower()
        self._times[("name", stem)] += 1
        return f"{stem}_{self._times[('name', stem)]}"

    @staticmethod
    def _keys(goal: Goal, room: str) -> Iterator[tuple[str, tuple[str, ...]]]:
        yield "object", ("object", goal.object)
        pair = (goal.object, goal.destination, goal.movable_receptacle)
        yield "pair", ("pair", str(goal.task_type), *pair)
        yield "destination", ("destination", str(goal.task_type), goal.destination)
        yield "room", ("room", room)
        if goal.movable_receptacle:
            yield "holder", ("holder", goal.movable_receptacle)


def kind_of(object_type: str) -> str:
    """Return the kind of thing a task object is, e.g. `cutlery`; raises KeyError for others."""
    return _KIND_OF[object_type]


def options(rooms: Sequence[Room], task_type: TaskType) -> Iterator[tuple[Goal, Room]]:
    """Yield every goal of a type with the room it could be asked for in."""
    for room in rooms:
        if room.kind in ROOM_KINDS[task_type]:
            for goal in _goals(room, task_type):
                yield goal, room


def _goals(room: Room, task_type: TaskType) -> Iterator[Goal]:
    """Yield what could be asked for in a room."""
    present = {thing.type for thing in room.objects}
    for name in sorted(present & set(CARE.get(task_type, _KIND_OF))):
        if task_type is TaskType.EXAMINE:
            yield from _lights(name, present)
        elif task_type is TaskType.STACK:
            yield from _stacks(room, name, present)
        else:
            for place in _free(room, name, _PLACES[_KIND_OF[name]]):
                if place != _SOURCE.get(task_type):
                    yield Goal(task_type, name, place)


def _lights(name: str, present: set[str]) -> Iterator[Goal]:
    if _KIND_OF[name] in ("desk", "leisure", "bath"):
        for lamp in sorted({"DeskLamp", "FloorLamp"} & present):
            yield Goal(TaskType.EXAMINE, name, lamp)


def _stacks(room: Room, name: str, present: set[str]) -> Iterator[Goal]:
    for holder in _HOLDERS.get(_KIND_OF[name], "").split():
        if holder in present and holder != name and object_type(name).belongs(holder):
            for place in _free(room, holder, _HOLDER_PLACES[holder]):
                if place != name:
                    yield Goal(TaskType.STACK, name, place, holder)


_SOURCE = {TaskType.HEAT: "Microwave", TaskType.COOL: "Fridge", TaskType.CLEAN: "Sink"}
"""Where a thing is after its treatment anyway."""


def _free(room: Room, name: str, places: str) -> Iterator[str]:
    """Yield the places of the room where such a thing may go, but none lies now."""
    now = {parent.split("|")[0] for o in room.objects if o.type == name for parent in o.parents}
    present = {thing.type for thing in room.objects if thing.receptacle}
    for place in places.split():
        if place in present and place not in now and object_type(name).belongs(place):
            yield place
