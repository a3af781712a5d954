"""Where a thing at some pose rests: which receptacle that pose lies in or on."""

from collections.abc import Iterable
from dataclasses import replace
from typing import NamedTuple

from reibench.household.geometry import bottom, footprint, top, volume
from reibench.household.objects import SURFACES, object_type
from reibench.scene import CONTAINERS, Box, SceneObject, Vector

AT_REST = 0.12
"""Metres from a receptacle within which a thing still counts as lying in or on it."""
SAME = 0.04
"""Metres that decide nothing between two receptacles; then the smaller one holds the thing."""
RIM = 0.03
"""Metres at the top of a drawer that belong to what is above it."""
STRANGE = 0.5
"""Metres that a receptacle counts as farther where things of that type are never put."""
PASSED_OVER = frozenset(("Chair", "Stool", "Footstool"))
"""What is pushed under tables, whose tops then lie within its box."""


class Rest(NamedTuple):
    """A receptacle, and how far the thing is from lying in or on it, in metres."""

    receptacle: SceneObject
    gap: float


def resting_place(thing: SceneObject, receptacles: Iterable[SceneObject]) -> Rest | None:
    """Return the receptacle `thing` is nearest to being in or on; None if there are none."""
    rests = [Rest(each, gap(thing, each)) for each in receptacles]
    if not rests:
        return None
    return min(rests, key=lambda rest: (_rank(thing, rest), volume(rest.receptacle.box)))


def gap(thing: SceneObject, receptacle: SceneObject) -> float:
    """Return how many metres `thing` is from lying in or on `receptacle`."""
    x, _, z = thing.box.center
    area = footprint(receptacle.box)
    if receptacle.pickupable:
        # What stands beside a bowl reaches into its box's corners.
        area = area.grown(-min(receptacle.box.size.x, receptacle.box.size.z) / 4)
    return area.distance(x, z) + _above(bottom(thing.box), receptacle)


def posed(thing: SceneObject, position: Vector, yaw: float) -> SceneObject:
    """Return `thing` somewhere else, with its box turned by the nearest quarter turn."""
    (x, y, z), (width, height, depth) = thing.box
    x, y, z = (m - p for m, p in zip((x, y, z), thing.position, strict=True))
    for _ in range(round((yaw - thing.yaw) / 90) % 4):
        x, z, width, depth = z, -x, depth, width
    middle = Vector(position.x + x, position.y + y, position.z + z)
    box = Box(middle, Vector(width, height, depth))
    return replace(thing, position=position, yaw=yaw, box=box)


def _rank(thing: SceneObject, rest: Rest) -> int:
    kind, place = object_type(thing.type), rest.receptacle.type
    strange = not kind.belongs(place) and place != "Floor"
    far = rest.gap + STRANGE * (strange or place in PASSED_OVER) + _under(thing, rest.receptacle)
    return int(far / SAME + 0.5)


def _above(low: float, receptacle: SceneObject) -> float:
    """Return how far a thing whose underside is at `low` is from the heights that count."""
    floor, high = bottom(receptacle.box), top(receptacle.box)
    if receptacle.type == "Floor":
        return abs(low - high)
    if receptacle.type in CONTAINERS:
        high -= RIM
    return max(floor - low, 0.0, low - high)


def _under(thing: SceneObject, receptacle: SceneObject) -> float:
    """Prefer, within a table's or dresser's box, its top, and anything else to the floor."""
    if receptacle.type == "Floor":
        return SAME
    if receptacle.type not in SURFACES or receptacle.type == "Shelf":
        return 0.0
    return min(0.1, max(0.0, 0.2 * (top(receptacle.box) - bottom(thing.box))))
