"""Where things find room: free spots in and on receptacles."""

from collections.abc import Callable, Iterable, Mapping
from typing import NamedTuple

from reibench.household.geometry import Footprint, bottom, footprint, top
from reibench.household.objects import SINGLE, SURFACES, object_type
from reibench.scene import Box, SceneObject, Vector

STEP, FINEST = 0.1, 0.02
"""Metres between the spots tried: as wide as a thing is, within these; more on large surfaces."""
MOST = 20
"""Spots tried along a side."""
EDGE = 0.03
"""Metres things keep from the edge where they can."""
LAYER = 0.3
"""Height of a level inside a fridge or cabinet."""
SEATS = {"ArmChair": 0.45, "Bed": 0.55, "Chair": 0.47, "Sofa": 0.45, "Stool": 0.7}
"""Height of what one sits or lies on, where the box goes on above it."""
HANGERS = frozenset(("HandTowelHolder", "TowelHolder", "ToiletPaperHanger"))
LAYERED = frozenset(("Cabinet", "Fridge", "LaundryHamper"))
BUILT_ON = frozenset(("CounterTop", "Floor", "Desk", "DiningTable", "CoffeeTable", "SideTable"))
"""Receptacles that fixed things stand on or are let into without being listed as contents."""
MOVED_ASIDE = frozenset(("Chair", "Stool", "Floor"))
"""What reaches over a table's edge without being in the way there."""
SLACK = 0.01
"""Metres two things may overlap sideways: boxes are larger than what is in them."""
FLAT = 0.02
"""Metres of height that even the flattest thing takes up."""
THIN = 0.04
"""Metres; longer things this thin stand upright in mugs and cups."""


Rank = Callable[[float, float], float]
"""Says how good a place (x, z) is; lower is better."""
Surface = Callable[[Box], bool]
"""Says whether something of that box would be held, not in the gap of a counter's box."""


class Spot(NamedTuple):
    """A place for a thing, and how it lies there."""

    middle: Vector
    size: Vector


def free_spot(
    objects: Mapping[str, SceneObject],
    thing: SceneObject,
    receptacle: SceneObject,
    rank: Rank,
    area: Footprint | None = None,
    *,
    holds: Surface | None = None,
) -> Spot | None:
    """Return the free spot for `thing` in or on `receptacle` whose middle ranks lowest.

    The size of `thing` is how it naturally lies; `area` narrows the search to a part of the
    receptacle, `holds` to where it really is. None means there is no room left.
    """
    if receptacle.type in SINGLE and receptacle.contents:
        return None
    if not _fits(thing, receptacle):
        return None
    area = area or footprint(receptacle.box)
    for size in _postures(thing, receptacle):
        occupied = list(_occupied(objects, thing, receptacle, size.y))
        for level in _levels(receptacle, size.y):
            for x, z in _grid(area, size, rank):
                box = Box(Vector(x, level + size.y / 2, z), size)
                if holds is not None and not holds(box):
                    continue
                if not any(_overlap(box, other) for other in occupied):
                    return Spot(box.center, size)
    return None


def surface(receptacle: SceneObject) -> float:
    """Return the height things rest at in or on `receptacle`."""
    kind, low, high = receptacle.type, bottom(receptacle.box), top(receptacle.box)
    if kind in SEATS:
        return min(low + SEATS[kind], high)
    if kind in ("Shelf", "Plate") or kind not in SURFACES:
        return low + 0.01
    return high


def _fits(thing: SceneObject, receptacle: SceneObject) -> bool:
    """Whether the receptacle is wide enough, standing the thing on end if need be.

    What AI2-THOR or ALFRED puts there fits, even where it juts out (a pan on a burner).
    """
    if object_type(thing.type).belongs(receptacle.type):
        return True
    small, middling, _ = sorted(thing.box.size)
    width, _, depth = receptacle.box.size
    return small <= min(width, depth) and middling <= max(width, depth)


def _postures(thing: SceneObject, receptacle: SceneObject) -> list[Vector]:
    width, height, depth = thing.box.size
    turned = Vector(depth, height, width)
    thickness, breadth, length = sorted(thing.box.size)
    if receptacle.type in ("Mug", "Cup") and breadth <= THIN:
        return [Vector(thickness, length, breadth)]
    if receptacle.type in HANGERS:
        rail = receptacle.box.size
        return [turned if (width > depth) != (rail.x > rail.z) else thing.box.size]
    return [thing.box.size] if width == depth else [thing.box.size, turned]


def _levels(receptacle: SceneObject, height: float) -> list[float]:
    """Return the heights a thing of that height can rest at."""
    low = surface(receptacle)
    if receptacle.type in HANGERS:
        return [receptacle.box.center.y - height]
    if receptacle.type not in LAYERED:
        return [low]
    count = max(1, min(4, int(receptacle.box.size.y / LAYER)))
    return [low + level * LAYER for level in range(count)]


def nearest_to(a: float, b: float) -> Rank:
    """Rank spots by how near they are to the point (a, b) on the floor plan."""
    return lambda x, z: (x - a) ** 2 + (z - b) ** 2


def _grid(area: Footprint, size: Vector, rank: Rank) -> list[tuple[float, float]]:
    """Return the middles to try, best first."""
    columns = _along(area.left, area.right, size.x)
    rows = _along(area.near, area.far, size.z)
    spots = [(rank(x, z), x, z) for x in columns for z in rows]
    return [(x, z) for _, x, z in sorted(spots)]


def _along(low: float, high: float, extent: float) -> list[float]:
    inset = min(extent + 2 * EDGE, high - low) / 2
    span = high - low - 2 * inset
    step = min(STEP, max(extent, FINEST))
    count = min(MOST, int(span / step) + 1)
    if count <= 1:
        return [(low + high) / 2]
    return [low + inset + span * number / (count - 1) for number in range(count)]


def _occupied(
    objects: Mapping[str, SceneObject],
    thing: SceneObject,
    receptacle: SceneObject,
    height: float,
) -> Iterable[Box]:
    """Yield the boxes a thing on `receptacle` must keep clear of."""
    for name in receptacle.contents or ():
        if name != thing.id:
            yield objects[name].box
    if receptacle.type not in BUILT_ON:
        return
    (x, _, z), (width, _, depth) = receptacle.box
    above = Box(Vector(x, surface(receptacle) + height / 2, z), Vector(width, height, depth))
    own = (receptacle.id, thing.id, *receptacle.parents)
    for other in objects.values():
        if other.pickupable or other.type in MOVED_ASIDE or other.id in own:
            continue
        if _overlap(above, other.box):
            yield other.box


def _overlap(one: Box, other: Box) -> bool:
    (x, y, z), (width, height, depth) = one
    (a, b, c), (w, h, d) = other
    return (
        abs(x - a) * 2 + SLACK < width + w
        and abs(z - c) * 2 + SLACK < depth + d
        # Cards and papers have no height to speak of, and yet nothing goes on top of them.
        and y - height / 2 < max(b + h / 2, b - h / 2 + FLAT)
        and b - h / 2 < max(y + height / 2, y - height / 2 + FLAT)
    )
