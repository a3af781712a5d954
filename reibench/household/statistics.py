"""Statistics of rooms: what they hold, how much of it, where it lies and how large it is."""

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from statistics import quantiles
from typing import Any

from reibench.household.floor import blocks
from reibench.household.geometry import footprint
from reibench.scene import CONTAINERS, SceneObject

STATES = ("open", "on", "dirty", "filled")
FLAT_ON_WALLS = frozenset(("Blinds", "Curtains", "Floor", "Mirror", "Painting", "Window"))
"""What hangs in or outside of the walls, or lies under them, and says nothing of a room's size."""
SEATS = frozenset(("Chair", "Stool"))
CELL = 0.1
"""Metres; free floor is counted in squares of this size."""


@dataclass(frozen=True)
class TypeStatistics:
    """One object type in the rooms of one kind."""

    counts: tuple[int, ...]
    """How many a room has: one number a room, sorted, so that no room can be recognised."""
    found_on: Mapping[str, int]
    """Types of receptacles the instances lie on, with how often; the empty name for none."""
    contents: float | None
    """How many things to carry lie in or on one, on average; None for what is no receptacle."""
    states: Mapping[str, float]
    """Shares of instances that are open, on, dirty or filled, where there are any."""
    long: tuple[float, float, float]
    """Quartiles of the longer horizontal side, in metres."""
    short: tuple[float, float, float]
    height: tuple[float, float, float]

    @property
    def share(self) -> float:
        """The share of rooms that have any."""
        return sum(count > 0 for count in self.counts) / len(self.counts)

    @property
    def mean(self) -> float:
        """How many a room has on average."""
        return sum(self.counts) / len(self.counts)


@dataclass(frozen=True)
class KindStatistics:
    """The rooms of one kind; tuples have one number a room, sorted."""

    rooms: int
    objects: tuple[int, ...]
    portable: tuple[int, ...]
    """Things that can be picked up."""
    enclosed: tuple[int, ...]
    """Things inside something that can be closed."""
    area: tuple[float, ...]
    """Square metres within the outermost things."""
    aspect: tuple[float, ...]
    """Longer by shorter side."""
    free: tuple[float, ...]
    """Share of the area that nothing stands on."""
    types: Mapping[str, TypeStatistics]


def measure(rooms: Sequence[Sequence[SceneObject]]) -> KindStatistics:
    """Return the statistics of some rooms, each given as its objects."""
    hulls = [_hull(objects) for objects in rooms]
    sides = [sorted((right - left, far - near)) for left, right, near, far in hulls]
    kinds = sorted({thing.type for objects in rooms for thing in objects})
    return KindStatistics(
        rooms=len(rooms),
        objects=_sorted(len, rooms),
        portable=_sorted(lambda objects: sum(thing.pickupable for thing in objects), rooms),
        enclosed=_sorted(_enclosed, rooms),
        area=tuple(sorted(round(short * long, 2) for short, long in sides)),
        aspect=tuple(sorted(round(long / short, 2) for short, long in sides)),
        free=tuple(sorted(round(_free(objects), 3) for objects in rooms)),
        types={kind: _type_statistics(kind, rooms) for kind in kinds},
    )


def to_json(statistics: KindStatistics) -> dict[str, Any]:
    """Return the statistics as what JSON can hold."""
    return asdict(statistics)


def from_json(content: Mapping[str, Any]) -> KindStatistics:
    """Read what `to_json` made."""
    return KindStatistics(
        rooms=int(content["rooms"]),
        types={name: _read_type(entry) for name, entry in content["types"].items()},
        **{
            name: tuple(content[name])
            for name in ("objects", "portable", "enclosed", "area", "aspect", "free")
        },
    )


def _read_type(entry: Mapping[str, Any]) -> TypeStatistics:
    return TypeStatistics(
        counts=tuple(entry["counts"]),
        found_on=dict(entry["found_on"]),
        contents=entry["contents"],
        states=dict(entry["states"]),
        **{side: tuple(entry[side]) for side in ("long", "short", "height")},
    )


def place_of(thing: SceneObject, by_id: Mapping[str, SceneObject]) -> str:
    """Return the type of receptacle a thing lies on: what a chair is pushed under, not the chair.

    A sink and its basin, and a tub and its, are one place: which of the two AI2-THOR names
    depends on the model.
    """
    kinds = [by_id[parent].type for parent in thing.parents if parent in by_id]
    kinds = [kind for kind in kinds if kind not in SEATS] or kinds
    return kinds[0].removesuffix("Basin") if kinds else ""


def _type_statistics(kind: str, rooms: Sequence[Sequence[SceneObject]]) -> TypeStatistics:
    places: Counter[str] = Counter()
    held = 0
    instances: list[SceneObject] = []
    for objects in rooms:
        by_id = {thing.id: thing for thing in objects}
        ours = [thing for thing in objects if thing.type == kind]
        instances += ours
        places.update(place_of(thing, by_id) for thing in ours)
        held += sum(thing.pickupable and place_of(thing, by_id) == kind for thing in objects)
    sides = [sorted((thing.box.size.x, thing.box.size.z)) for thing in instances]
    shares = {
        state: round(sum(getattr(thing, state) for thing in instances) / len(instances), 3)
        for state in STATES
    }
    holds = held or any(thing.contents is not None for thing in instances)
    return TypeStatistics(
        counts=_sorted(lambda objects: sum(thing.type == kind for thing in objects), rooms),
        found_on=dict(sorted(places.items(), key=lambda pair: (-pair[1], pair[0]))),
        contents=round(held / len(instances), 3) if holds and "Basin" not in kind else None,
        states={state: share for state, share in shares.items() if share},
        long=_quartiles([long for _, long in sides]),
        short=_quartiles([short for short, _ in sides]),
        height=_quartiles([thing.box.size.y for thing in instances]),
    )


def _enclosed(objects: Iterable[SceneObject]) -> int:
    by_id = {thing.id: thing for thing in objects}
    return sum(
        any(by_id[parent].type in CONTAINERS for parent in thing.parents if parent in by_id)
        for thing in by_id.values()
        if thing.pickupable
    )


def _hull(objects: Iterable[SceneObject]) -> tuple[float, float, float, float]:
    areas = [footprint(thing.box) for thing in objects if thing.type not in FLAT_ON_WALLS]
    return (
        min(area.left for area in areas),
        max(area.right for area in areas),
        min(area.near for area in areas),
        max(area.far for area in areas),
    )


def _free(objects: Sequence[SceneObject]) -> float:
    left, right, near, far = _hull(objects)
    standing = [footprint(thing.box) for thing in objects if blocks(thing)]
    columns, rows = int((right - left) / CELL), int((far - near) / CELL)
    taken: set[tuple[int, int]] = set()
    for area in standing:
        across = range(max(0, round((area.left - left) / CELL)), round((area.right - left) / CELL))
        along = range(max(0, round((area.near - near) / CELL)), round((area.far - near) / CELL))
        taken |= {(x, z) for x in across for z in along if x < columns and z < rows}
    return 1 - len(taken) / (columns * rows)


def _sorted(
    count: Callable[[Sequence[SceneObject]], int], rooms: Sequence[Sequence[SceneObject]]
) -> tuple[int, ...]:
    return tuple(sorted(count(objects) for objects in rooms))


def _quartiles(values: Sequence[float]) -> tuple[float, float, float]:
    if len(values) == 1:
        return (round(values[0], 2),) * 3
    low, middle, high = quantiles(values, n=4, method="inclusive")
    return round(low, 2), round(middle, 2), round(high, 2)
