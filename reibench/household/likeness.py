"""Likeness: how near the statistics of some rooms come to those of others, kind by kind."""

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from statistics import correlation, mean, median

from reibench.household.objects import object_type
from reibench.household.statistics import KindStatistics, TypeStatistics

Numbers = Sequence[int] | Sequence[float]
Both = tuple[KindStatistics, KindStatistics]
ROOM_QUANTITIES: tuple[tuple[str, Callable[[KindStatistics], Numbers]], ...] = (
    ("objects", lambda rooms: rooms.objects),
    ("things to carry", lambda rooms: rooms.portable),
    ("things put away", lambda rooms: rooms.enclosed),
    ("area in m²", lambda rooms: rooms.area),
    ("longer by shorter side", lambda rooms: rooms.aspect),
    ("free floor", lambda rooms: rooms.free),
)


@dataclass(frozen=True)
class Row:
    """One quantity in the first rooms and in the second."""

    name: str
    first: str
    second: str


@dataclass(frozen=True)
class Likeness:
    """How alike the rooms of one kind are, in numbers."""

    objects: tuple[float, float]
    """Mean number of objects, of the first rooms and of the second."""
    area: tuple[float, float]
    """Mean area in square metres."""
    free: tuple[float, float]
    """Median share of free floor."""
    shares: float
    """Correlation, over types, of the shares of rooms that have any."""
    counts: float
    """Correlation, over types, of the mean numbers in a room."""
    places: float
    """How much of what lies somewhere lies on the same types of receptacles; 1 for all."""
    contents: float
    """Correlation, over types of receptacles, of how much they hold."""


def likeness(pair: Both) -> Likeness:
    """Return how alike two sets of rooms of one kind are."""
    one, other = pair
    types = sorted({*one.types, *other.types})
    shares = [[_of(rooms, name, "share") for name in types] for rooms in pair]
    counts = [[_of(rooms, name, "mean") for name in types] for rooms in pair]
    holders = [name for name in _shared(pair) if _held(one, name) or _held(other, name)]
    contents = [[_held(rooms, name) for name in holders] for rooms in pair]
    return Likeness(
        objects=(round(mean(one.objects), 1), round(mean(other.objects), 1)),
        area=(round(mean(one.area), 1), round(mean(other.area), 1)),
        free=(round(median(one.free), 2), round(median(other.free), 2)),
        shares=round(correlation(*shares), 3),
        counts=round(correlation(*counts), 3),
        places=round(_same_places(pair), 3),
        contents=round(correlation(*contents), 3),
    )


def room_rows(pair: Both) -> Iterator[Row]:
    """Yield the quantities of whole rooms: least, middle, mean and most."""
    for name, values in ROOM_QUANTITIES:
        yield Row(name, *(_spread(values(rooms)) for rooms in pair))


def type_rows(pair: Both) -> Iterator[Row]:
    """Yield how many rooms of a hundred hold each type, and how many of it a room has."""
    for name in sorted({*pair[0].types, *pair[1].types}):
        cells = []
        for rooms in pair:
            each = rooms.types.get(name)
            cells.append(f"{each.share:.0%}, {each.mean:.1f}" if each else "–")
        yield Row(name, cells[0], cells[1])


def content_rows(pair: Both) -> Iterator[Row]:
    """Yield how many things lie in or on each type of receptacle, and which most."""
    for name in _shared(pair):
        if any(_held(rooms, name) for rooms in pair):
            cells = [f"{_held(rooms, name):.1f}: {_usual(rooms, name)}" for rooms in pair]
            yield Row(name, *(cell.removesuffix(": ") for cell in cells))


def size_rows(pair: Both) -> Iterator[Row]:
    """Yield the middle length, depth and height of what cannot be carried, in centimetres."""
    for name in sorted({*pair[0].types} & {*pair[1].types}):
        each = [rooms.types[name] for rooms in pair]
        if sum(each[1].counts) >= 5 and name not in ("Floor",):
            yield Row(name, *(_size(one) for one in each))


def state_rows(pair: Both) -> Iterator[Row]:
    """Yield which shares of the instances of a type are open, on, dirty or filled."""
    for name in sorted({*pair[0].types} & {*pair[1].types}):
        states = sorted({state for rooms in pair for state in rooms.types[name].states})
        for state in states:
            cells = [f"{rooms.types[name].states.get(state, 0):.0%}" for rooms in pair]
            yield Row(f"{name} {state}", *cells)


def _of(rooms: KindStatistics, name: str, quantity: str) -> float:
    each = rooms.types.get(name)
    return float(getattr(each, quantity)) if each else 0.0


def _held(rooms: KindStatistics, name: str) -> float:
    return (rooms.types[name].contents or 0.0) if name in rooms.types else 0.0


def _shared(pair: Both) -> list[str]:
    return [name for name in sorted(pair[0].types) if name in pair[1].types]


def _usual(rooms: KindStatistics, receptacle: str) -> str:
    """Return the three types that lie there most."""
    found: Counter[str] = Counter()
    for name, each in rooms.types.items():
        if "pickupable" in object_type(name).traits:
            found[name] = each.found_on.get(receptacle, 0)
    most = sorted((name for name in found if found[name]), key=lambda name: (-found[name], name))
    return ", ".join(most[:3])


def _same_places(pair: Both) -> float:
    """Return the overlap of where the instances of each type lie, over all types."""
    overlap = total = 0.0
    for name in _shared(pair):
        places = [_normal(rooms.types[name]) for rooms in pair]
        weight = float(sum(pair[1].types[name].counts))
        overlap += weight * sum(min(places[0].get(each, 0), places[1][each]) for each in places[1])
        total += weight
    return overlap / total


def _normal(statistics: TypeStatistics) -> Mapping[str, float]:
    total = sum(statistics.found_on.values())
    return {name: count / total for name, count in statistics.found_on.items()}


def _spread(values: Numbers) -> str:
    whole = all(isinstance(value, int) for value in values)
    low, middle, high = (values[0], median(values), values[-1])
    form = "{:.0f}" if whole else "{:.2f}" if high < 5 else "{:.1f}"
    ends = " / ".join(form.format(value) for value in (low, middle, high))
    average = f"{mean(values):.1f}" if whole or high >= 5 else f"{mean(values):.2f}"
    return f"{ends}, mean {average}"


def _size(statistics: TypeStatistics) -> str:
    sides = (statistics.long, statistics.short, statistics.height)
    return " × ".join(f"{100 * side[1]:.0f}" for side in sides)
