"""Where things find room: free spots in and on receptacles."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import NamedTuple

from reibench.household.geometry import Footprint, bottom, footprint, top
from reibench.household.objects import SINGLE, SURFACES, object_type
from reibench.scene import Box, SceneObject, Vector

STEP, FINEST = 0.1, 0.02
"""Metres between the spots tried: as wide as a thing is, within these; more on large surfaces."""
CLOSE_STEP = 0.03
"""The same where nothing is found at first."""
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
UTENSILS = frozenset("ButterKnife Fork Knife Ladle Pen Pencil Spatula Spoon".split())
"""Long thin things; lying askew, their boxes are mostly air, and the robot lays them straight."""
BREADTH = {"Ladle": 0.09, "Spatula": 0.07}
"""Metres across, of utensils that are wider than `THIN`."""
FOOT = {"DeskLamp": 0.5, "HousePlant": 0.6, "Television": 0.4}
"""What part of its box's width a thing takes up where it stands."""
BUILT_IN = frozenset(
    "Blinds CounterTop Curtains Drawer Faucet Mirror Painting Poster Window".split()
)
"""What real rooms list in basins and on tables because boxes overlap, and is not in the way."""


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
    closely: bool = False,
    holds: Surface | None = None,
) -> Spot | None:
    """Return the free spot for `thing` in or on `receptacle` whose middle ranks lowest.

    The size of `thing` is how it naturally lies; `area` narrows the search to a part of the
    receptacle, `holds` to where it really is; `closely` looks beyond boxes, which are larger than
    what is in them: utensils are laid straight, and lamps have narrow feet. None means there is no
    room left.
    """
    if receptacle.type in SINGLE and receptacle.contents:
        return None
    if not _fits(thing, receptacle):
        return None
    area = area or footprint(receptacle.box)
    if closely:
        thing = _laid_straight(thing)
    for step in (STEP, CLOSE_STEP) if closely else (STEP,):
        for size in _postures(thing, receptacle):
            occupied = list(_occupied(objects, thing, receptacle, size.y, closely))
            for box in _boxes(receptacle, area, size, rank, step):
                if holds is not None and not holds(box):
                    continue
                if not any(_overlap(box, other) for other in occupied):
                    return Spot(box.center, size)
    return None


def _boxes(
    receptacle: SceneObject, area: Footprint, size: Vector, rank: Rank, step: float
) -> Iterator[Box]:
    """Yield the boxes a thing of that size could take up, best first on each level."""
    for level in _levels(receptacle, size.y):
        for x, z in _grid(area, size, rank, step):
            yield Box(Vector(x, level + size.y / 2, z), size)


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
    width, height, depth = size = thing.box.size
    turned = Vector(depth, height, width)
    thickness, breadth, length = sorted(size)
    if receptacle.type in ("Mug", "Cup") and breadth <= THIN:
        return [Vector(thickness, length, breadth)]
    if receptacle.type in HANGERS:
        rail = receptacle.box.size
        return [turned if (width > depth) != (rail.x > rail.z) else size]
    return [size] if width == depth else [size, turned]


def _laid_straight(thing: SceneObject) -> SceneObject:
    """Return a thing, or a utensil that lies askew with the size it has along an axis."""
    width, height, depth = thing.box.size
    breadth = BREADTH.get(thing.type, THIN)
    if thing.type not in UTENSILS or min(width, depth) <= breadth or height > breadth:
        return thing
    length = (width**2 + depth**2) ** 0.5
    along_x = Vector(length, height, breadth)
    size = along_x if width >= depth else Vector(breadth, height, length)
    return replace(thing, box=Box(thing.box.center, size))


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


def _grid(area: Footprint, size: Vector, rank: Rank, step: float) -> list[tuple[float, float]]:
    """Return the middles to try, best first."""
    columns = _along(area.left, area.right, size.x, step)
    rows = _along(area.near, area.far, size.z, step)
    spots = [(rank(x, z), x, z) for x in columns for z in rows]
    return [(x, z) for _, x, z in sorted(spots)]


def _along(low: float, high: float, extent: float, step: float) -> list[float]:
    edge = EDGE if step == STEP else 0.0
    inset = min(extent + 2 * edge, high - low) / 2
    span = high - low - 2 * inset
    step = min(step, max(extent, FINEST))
    count = min(MOST, int(span / step) + 1)
    if count <= 1:
        return [(low + high) / 2]
    return [low + inset + span * number / (count - 1) for number in range(count)]


def _occupied(
    objects: Mapping[str, SceneObject],
    thing: SceneObject,
    receptacle: SceneObject,
    height: float,
    closely: bool,
) -> Iterable[Box]:
    """Yield the boxes a thing on `receptacle` must keep clear of."""
    for name in receptacle.contents or ():
        if name != thing.id and not (closely and objects[name].type in BUILT_IN):
            yield _standing(objects[name], closely)
    if receptacle.type not in BUILT_ON:
        return
    (x, _, z), (width, _, depth) = receptacle.box
    above = Box(Vector(x, surface(receptacle) + height / 2, z), Vector(width, height, depth))
    own = (receptacle.id, thing.id, *receptacle.parents)
    for other in objects.values():
        if other.pickupable or other.type in MOVED_ASIDE or other.id in own:
            continue
        if closely and other.type in BUILT_IN:
            continue
        if _overlap(above, other.box):
            yield _standing(other, closely)


def _standing(thing: SceneObject, closely: bool) -> Box:
    """Return the part of a thing's box that keeps others away from where it stands."""
    if not closely or thing.type not in FOOT:
        return thing.box
    part = FOOT[thing.type]
    width, height, depth = thing.box.size
    return Box(thing.box.center, Vector(width * part, height, depth * part))


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
