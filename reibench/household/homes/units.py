"""Kitchen units: the doors and drawers under a counter, and the cabinets that hang above it."""

from typing import TypeVar

from reibench.household.furnishing.common import add_drawers
from reibench.household.homes.counters import DEPTH, Counters, Slot
from reibench.household.homes.site import Site
from reibench.household.homes.storage import add_cupboards
from reibench.scene import Vector

Place = TypeVar("Place")

HUNG = 1.45
"""Height of the lower side of wall cabinets."""
HANGING = (HUNG, HUNG + 0.68)
RANGES = {"range": (1.82, 2.2), "fridge": (2.0, 2.4)}
"""From what height to what height cabinets hang above something."""
FRONTS = 0.42
"""How deep cabinets and drawers reach in from the front."""


def fill_units(site: Site, counters: Counters) -> None:
    """Put the drawers and cabinets into the units, and hang cabinets above them."""
    units = site.shuffled([slot for slot in counters.slots if slot.module in ("unit", "island")])
    doors = _drawers(site, units, site.count("Drawer"))
    doors += [(slot, 0.7) for slot in counters.slots if slot.module == "sink"]
    above = [slot for slot in counters.slots if slot.module != "island" and _free(site, slot)]
    wanted = site.count("Cabinet")
    # About as many hang as stand; whole units first, then double doors; then cupboards.
    hung = min(2 * len(above), wanted // 2)
    standing = min(wanted - hung, 2 * len(doors))
    hung = min(2 * len(above), wanted - standing)
    for (slot, high), count in _dealt(site, doors, standing):
        _doors(site, slot, count, high)
    for slot, count in _dealt(site, above, hung):
        _hang(site, slot, count)
    add_cupboards(site, wanted - standing - hung)


def _dealt(site: Site, places: list[Place], wanted: int) -> list[tuple[Place, int]]:
    """Deal a number of doors to places, two to a place at most."""
    order = site.shuffled(places)
    number = min(wanted, 2 * len(order))
    counts = [number // len(order) + (each < number % len(order)) for each in range(len(order))]
    return [(place, count) for place, count in zip(order, counts, strict=True) if count]


def _drawers(site: Site, units: list[Slot], wanted: int) -> list[tuple[Slot, float]]:
    """Fill units with drawers; return where doors may go, and how high they may be."""
    left = list(units)
    doors: list[tuple[Slot, float]] = []
    while wanted > 0 and left:
        slot = left.pop()
        if wanted <= len(left) + 1 and site.random.random() < 0.7:
            # A single drawer over a door.
            _drawers_in(site, slot, 1, 1, 0.7)
            doors.append((slot, 0.68))
            wanted -= 1
            continue
        most = 4 if wanted <= 4 * (len(left) + 1) else 10
        count = min(wanted, most)
        across = 2 if count > 5 else 1
        rows = -(-count // across)
        _drawers_in(site, slot, rows, across, 0.1)
        wanted -= rows * across
    if wanted > 0:
        site.miss("Drawer")
    return doors + [(slot, 0.86) for slot in left]


def _drawers_in(site: Site, slot: Slot, rows: int, across: int, low: float) -> None:
    extent = Vector(slot.width, 0.76, FRONTS)
    body = slot.wall.box(slot.along, extent, low=0.1, gap=DEPTH - FRONTS - 0.02)
    add_drawers(site, body, slot.wall.yaw, rows, low=low, high=0.86, across=across)


def _doors(site: Site, slot: Slot, count: int, high: float) -> None:
    """Close a unit with doors, from the floor up to that height."""
    for number in range(count):
        off = ((number + 0.5) / count - 0.5) * slot.width
        extent = Vector(slot.width / count - 0.02, high - 0.1, FRONTS)
        box = slot.wall.box(slot.along + off, extent, low=0.1, gap=DEPTH - FRONTS - 0.02)
        site.add("Cabinet", box, slot.wall.yaw)


def _free(site: Site, slot: Slot) -> bool:
    """Whether nothing hangs above a unit yet."""
    low, high = RANGES.get(slot.module, HANGING)
    return site.free_wall(slot.wall, slot.along, Vector(slot.width - 0.04, high - low, 0.34), low)


def _hang(site: Site, slot: Slot, count: int) -> None:
    low, high = RANGES.get(slot.module, HANGING)
    for number in range(count):
        off = ((number + 0.5) / count - 0.5) * slot.width
        extent = Vector(slot.width / count - 0.02, high - low, 0.34)
        site.add("Cabinet", slot.wall.box(slot.along + off, extent, low=low), slot.wall.yaw)
