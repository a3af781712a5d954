"""Habits: how real rooms are, as numbers to draw from.

The table beside this module holds statistics of AI2-THOR's real rooms and no room itself;
`python -m reibench compare-rooms --real DIR --save` makes it.
"""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from random import Random
from typing import TypeVar

from reibench.household.objects import object_type, object_types
from reibench.household.statistics import KindStatistics, from_json, to_json
from reibench.scene import Vector

Number = TypeVar("Number", int, float)

TABLE = Path(__file__).with_name("real_rooms.json")
WITH_AREA = {"kitchen": 0.3, "living room": 0.27, "bedroom": 0.25, "bathroom": 0.2}
"""How much larger rooms of a kind have more furniture, from 0 to 1."""
COMPANIONS = {
    ("living room", "Chair"): "DiningTable",
    ("living room", "DeskLamp"): "SideTable",
    ("bedroom", "Blinds"): "Window",
    ("bathroom", "SinkBasin"): "Sink",
    ("kitchen", "Vase"): "Shelf",
    ("living room", "Vase"): "Shelf",
    ("living room", "Statue"): "Shelf",
    ("bedroom", "Vase"): "Shelf",
}
"""Types of which a room has more where it has more of another one."""
WITH_COMPANION = 0.7


@lru_cache(maxsize=1)
def real_rooms() -> Mapping[str, KindStatistics]:
    """Return the statistics of the real rooms by kind."""
    return read_statistics(TABLE)


def read_statistics(path: Path) -> Mapping[str, KindStatistics]:
    """Read a file that `format_statistics` made the text of."""
    content = json.loads(path.read_text(encoding="utf-8"))
    return {kind: from_json(entry) for kind, entry in content.items()}


def format_statistics(statistics: Mapping[str, KindStatistics]) -> str:
    """Return the text of a file of statistics, one object type a line."""
    kinds = []
    for kind, measured in statistics.items():
        entry = to_json(measured)
        types = entry.pop("types")
        lines = [f'  "{key}": {_dump(value)},' for key, value in entry.items()]
        listed = ",\n".join(f'   "{name}": {_dump(each)}' for name, each in types.items())
        kinds.append("\n".join([f' "{kind}": {{', *lines, '  "types": {', listed, "  }\n }"]))
    return "{\n" + ",\n".join(kinds) + "\n}\n"


@dataclass(frozen=True)
class Stratum:
    """One of several rooms that together are to be like the real ones: number `index` of `of`.

    Each quantity's values are spread evenly over the rooms, every quantity in another order (a
    Latin hypercube sample); without that, thirty rooms differ from thirty others by chance.
    """

    index: int
    of: int

    def level(self, kind: str, name: str) -> float:
        """Return where in the distribution of a quantity this room lies, from 0 to 1."""
        return (_order(kind, name, self.of)[self.index] + 0.5) / self.of


@dataclass(frozen=True)
class Inventory:
    """What a room is going to have: where it lies in the distribution of each quantity."""

    levels: Mapping[str, float]
    """From 0 to 1, for each type, for the area and the aspect, and for the states of types."""
    habits: KindStatistics

    def count(self, name: str) -> int:
        """Return how many of a type the room has."""
        each = self.habits.types.get(name)
        return at(each.counts, self.levels[name]) if each else 0

    @property
    def sides(self) -> tuple[float, float]:
        """The longer and the shorter side of the room in metres."""
        area = at(self.habits.area, self.levels["area"])
        long = (area * at(self.habits.aspect, self.levels["aspect"])) ** 0.5
        return long, area / long


def draw_inventory(kind: str, random: Random, stratum: Stratum | None) -> Inventory:
    """Draw how large a room is and how many of each type it has."""
    habits = real_rooms()[kind]

    def level(name: str) -> float:
        return stratum.level(kind, name) if stratum else random.random()

    names = ["area", "aspect", *habits.types]
    names += [f"{name} {state}" for name, each in habits.types.items() for state in each.states]
    return Inventory({name: level(name) for name in names}, habits)


def at(values: Sequence[Number], level: float) -> Number:
    """Return the value of a sorted sequence at a level from 0 to 1."""
    return values[min(len(values) - 1, int(level * len(values)))]


def extent_of(kind: str, name: str, random: Random) -> Vector:
    """Draw how long, high and deep something is, within the quartiles of the real ones."""
    each = real_rooms()[kind].types.get(name)
    if each is None:
        size = object_type(name).size
        return Vector(max(size.x, size.z), size.y, min(size.x, size.z))
    level = random.random()

    def between(quartiles: tuple[float, float, float]) -> float:
        return quartiles[0] + level * (quartiles[2] - quartiles[0])

    return Vector(between(each.long), between(each.height), between(each.short))


@lru_cache(maxsize=4096)
def _order(kind: str, name: str, of: int) -> tuple[int, ...]:
    """Return the rank each of `of` rooms has in a quantity; furniture goes with the area."""
    random = Random(f"{kind} {name} {of}")
    companion = COMPANIONS.get((kind, name), "area")
    of_things = name in object_types() and "pickupable" not in object_type(name).traits
    free = name == "area" or not of_things
    if free and companion == "area":
        return tuple(random.sample(range(of), of))
    share = WITH_AREA[kind] if companion == "area" else WITH_COMPANION
    leading = _order(kind, companion, of)
    score = [share * rank / of + (1 - share) * random.random() for rank in leading]
    by_score = sorted(range(of), key=lambda index: score[index])
    ranks = [0] * of
    for rank, index in enumerate(by_score):
        ranks[index] = rank
    return tuple(ranks)


def _dump(value: object) -> str:
    return json.dumps(value, separators=(",", ":"))
