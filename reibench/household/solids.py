"""Solids: what the robot walks around in real rooms, where boxes alone say too much.

AI2-THOR reports an axis-aligned box of each object. That of a counter around a corner covers the
floor in the corner, that of a bath the room around it, and that of a turned table the floor at
its corners. What stands on and under counters, basins and oriented boxes tell where they end.
"""

from collections.abc import Iterator, Mapping
from functools import partial
from math import hypot
from typing import NamedTuple

from reibench.household.floor import HEADROOM, LOWEST, Solid
from reibench.household.geometry import Footprint, bottom, footprint, top
from reibench.household.particulars import Particulars
from reibench.scene import Box, SceneObject

CLEARANCE = 0.12
"""Metres from a box at which AI2-THOR's robot stands: colliders are smaller than boxes."""
DEPTH = 0.65
"""Metres of counter before a wall."""
DEEP = 0.85
"""Metres; a counter wider than this both ways goes around a corner."""
AT_WALL = 0.25
"""Metres from the wall within which a counter stands against it."""
SPREAD = 0.3
"""Share of its length over which what is on a strip of counter must be spread."""
PATCH = 0.25
"""Metres; how far around its middle a thing shows that there is counter."""
OVERHANG = 0.02
"""Metres by which things may stick out over an edge."""
RIM = 0.12
"""Metres around a bath's basin."""
STEADY = 8.0
"""Degrees a thing may be tilted and still stand on its base."""
FLAT_ON_WALLS = frozenset(
    "Blinds Curtains Faucet HandTowelHolder LightSwitch Mirror Painting Poster ShowerHead"
    " ToiletPaperHanger TowelHolder Window".split()
)
PASSABLE = frozenset(("BathtubBasin", "Floor", "ShowerDoor"))
"""What has a box the robot can stand in; shower doors are taken to be open."""
COUNTERS = frozenset(("CounterTop", "Desk"))
BUILT_IN = frozenset(
    "Cabinet CoffeeMachine Drawer Faucet Microwave Sink SinkBasin StoveBurner StoveKnob"
    " Toaster".split()
)
"""What is found only where there is counter."""


class Rectangle(NamedTuple):
    """A rectangle on the floor plan, turned any way."""

    x: float
    z: float
    half_width: float
    half_depth: float
    along_x: float = 1.0
    """The unit vector along its width."""
    along_z: float = 0.0

    @classmethod
    def between(cls, left: float, right: float, near: float, far: float) -> "Rectangle":
        """Return the one with sides along the axes there."""
        return cls((left + right) / 2, (near + far) / 2, (right - left) / 2, (far - near) / 2)

    def distance(self, x: float, z: float) -> float:
        """Return how far the point is from its edge, 0 inside."""
        dx, dz = x - self.x, z - self.z
        across = abs(dx * self.along_x + dz * self.along_z) - self.half_width
        deep = abs(dz * self.along_x - dx * self.along_z) - self.half_depth
        return hypot(max(across, 0.0), max(deep, 0.0))

    def around(self, margin: float) -> Solid:
        """Return where a round robot of that radius cannot be."""
        wide = self.half_width * abs(self.along_x) + self.half_depth * abs(self.along_z) + margin
        deep = self.half_width * abs(self.along_z) + self.half_depth * abs(self.along_x) + margin
        extent = Footprint(self.x - wide, self.x + wide, self.z - deep, self.z + deep, *self[:2])
        return Solid(extent, lambda x, z: self.distance(x, z) < margin)


def solids(
    objects: tuple[SceneObject, ...], particulars: Mapping[str, Particulars], bounds: Box
) -> list[tuple[str, Solid]]:
    """Return, by object id, where objects keep the robot from standing."""
    return [
        (thing.id, shape.around(CLEARANCE))
        for thing in objects
        if _stands_in_the_way(thing)
        for shape in shapes(thing, objects, particulars, bounds)
    ]


def shapes(
    thing: SceneObject,
    objects: tuple[SceneObject, ...],
    particulars: Mapping[str, Particulars],
    bounds: Box,
) -> list[Rectangle]:
    """Return what an object covers, which can be less than its box."""
    if thing.type in COUNTERS:
        return list(_counter(thing, objects, footprint(bounds)))
    if thing.type == "Bathtub":
        return [_bath(thing, objects)]
    return [_base(thing, particulars.get(thing.id))]


def holds(surface: list[Rectangle], box: Box) -> bool:
    """Whether all corners of a box lie over the surface."""
    area = footprint(box).grown(-OVERHANG)
    corners = ((x, z) for x in (area.left, area.right) for z in (area.near, area.far))
    return all(any(part.distance(x, z) <= 0 for part in surface) for x, z in corners)


def _base(thing: SceneObject, own: Particulars | None) -> Rectangle:
    """Return what an object covers: of its oriented box where it has one and is upright."""
    if own and own.corners and max(min(abs(turn), 360 - abs(turn)) for turn in own.tilt) < STEADY:
        first, second, _, fourth = own.corners[:4]
        wide_x, wide_z = second.x - first.x, second.z - first.z
        deep_x, deep_z = fourth.x - first.x, fourth.z - first.z
        width, depth = hypot(wide_x, wide_z), hypot(deep_x, deep_z)
        if width > 0 and abs(wide_x * deep_x + wide_z * deep_z) < 0.05 * width * depth:
            x, z = first.x + (wide_x + deep_x) / 2, first.z + (wide_z + deep_z) / 2
            return Rectangle(x, z, width / 2, depth / 2, wide_x / width, wide_z / width)
    return _whole(footprint(thing.box))


def _stands_in_the_way(thing: SceneObject) -> bool:
    if thing.pickupable or thing.type in FLAT_ON_WALLS or thing.type in PASSABLE:
        return False
    return bottom(thing.box) < HEADROOM and top(thing.box) > LOWEST


def _whole(area: Footprint) -> Rectangle:
    return Rectangle.between(area.left, area.right, area.near, area.far)


def _bath(bath: SceneObject, objects: tuple[SceneObject, ...]) -> Rectangle:
    left, right, near, far, *_ = footprint(bath.box)
    for basin in objects:
        if basin.id.startswith(f"{bath.id}|"):
            inner = footprint(basin.box).grown(RIM)
            left, right = max(left, inner.left), min(right, inner.right)
            near, far = max(near, inner.near), min(far, inner.far)
    return Rectangle.between(left, right, near, far)


def _counter(
    counter: SceneObject, objects: tuple[SceneObject, ...], walls: Footprint
) -> Iterator[Rectangle]:
    """Yield the parts of a counter: all of it, or the strips along the sides that hold things.

    As few strips as hold everything, those before a wall first; what none holds covers itself.
    """
    area = footprint(counter.box)
    left, right, near, far, *_ = area
    strips = {
        Rectangle.between(left, left + DEPTH, near, far): left - walls.left < AT_WALL,
        Rectangle.between(right - DEPTH, right, near, far): walls.right - right < AT_WALL,
        Rectangle.between(left, right, near, near + DEPTH): near - walls.near < AT_WALL,
        Rectangle.between(left, right, far - DEPTH, far): walls.far - far < AT_WALL,
    }
    unexplained = _on_or_under(counter, area, objects)
    if min(right - left, far - near) < DEEP or not unexplained or not any(strips.values()):
        yield _whole(area)
        return
    while unexplained:
        held = {
            strip: [one for one in unexplained if _holds(strip, one)]
            for strip, at_wall in strips.items()
            if at_wall or _spans(strip, unexplained)
        }
        best = max(held, key=partial(_merit, strips, held), default=None)
        if best is None or not held[best]:
            break
        yield best
        del strips[best]
        unexplained = [one for one in unexplained if one not in held[best]]
    for one in unexplained:
        yield Rectangle(
            one.x,
            one.z,
            min(one.right - one.x, PATCH),
            min(one.far - one.z, PATCH),
        )


def _merit(
    strips: Mapping[Rectangle, bool], held: Mapping[Rectangle, list[Footprint]], strip: Rectangle
) -> tuple[bool, int]:
    return bool(held[strip]) and strips[strip], len(held[strip])


def _spans(strip: Rectangle, things: list[Footprint]) -> bool:
    """Whether the things on a strip away from the wall are spread along much of it."""
    on_it = [one for one in things if _holds(strip, one)]
    if strip.half_width > strip.half_depth:
        places, length = [one.x for one in on_it], 2 * strip.half_width
    else:
        places, length = [one.z for one in on_it], 2 * strip.half_depth
    return bool(places) and max(places) - min(places) > SPREAD * length


def _holds(strip: Rectangle, one: Footprint) -> bool:
    return strip.distance(one.x, one.z) <= 0.05


def _on_or_under(
    counter: SceneObject, area: Footprint, objects: tuple[SceneObject, ...]
) -> list[Footprint]:
    """Return what shows where there is counter: things on it, and what is built in under it."""
    near = area.grown(0.05)
    found = []
    for thing in objects:
        built_in = thing.type in BUILT_IN and bottom(thing.box) < HEADROOM + 0.3
        hangs = thing.type == "Cabinet" and bottom(thing.box) > HEADROOM - 0.1
        if thing.id in (counter.contents or ()) or (built_in and not hangs):
            covered = footprint(thing.box)
            if thing.id != counter.id and near.covers(covered.x, covered.z):
                found.append(covered)
    return found
