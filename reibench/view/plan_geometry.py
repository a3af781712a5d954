"""From metres to the pixels of a floor plan: x to the right, z up the page."""

import math
from dataclasses import dataclass
from typing import NamedTuple

from reibench.household.solids import counter_parts
from reibench.scene import Box, Scene, SceneObject
from reibench.view.icons import appearance


class Size(NamedTuple):
    """How large a drawing may get, and what its smallest details are, in pixels."""

    width: float
    height: float
    icon: float
    """Diameter of the smallest icon disc."""
    wall: float
    name: str = ""
    """Class of the drawing, for the style sheet."""


WIDE = Size(596, 532, 25, 11, "wide")
PHONE = Size(364, 330, 23, 8, "phone")
ASIDE = Size(312, 250, 21, 6, "aside")
"""Beside a list of steps, where two runs are compared."""


class Rect(NamedTuple):
    """A rectangle in pixels."""

    x: float
    y: float
    width: float
    height: float

    @property
    def right(self) -> float:
        """The far edge in x."""
        return self.x + self.width

    @property
    def bottom(self) -> float:
        """The far edge in y."""
        return self.y + self.height

    @property
    def cx(self) -> float:
        """The centre in x."""
        return self.x + self.width / 2

    @property
    def cy(self) -> float:
        """The centre in y."""
        return self.y + self.height / 2

    def grown(self, by: float) -> "Rect":
        """Return it larger (or, below zero, smaller) on every side, never inside out."""
        by = max(by, -self.width / 2, -self.height / 2)
        return Rect(self.x - by, self.y - by, self.width + 2 * by, self.height + 2 * by)

    def within(self, outer: "Rect") -> "Rect":
        """Return the part of it that is inside `outer`."""
        x, y = min(max(self.x, outer.x), outer.right), min(max(self.y, outer.y), outer.bottom)
        right, bottom = min(self.right, outer.right), min(self.bottom, outer.bottom)
        return Rect(x, y, max(right - x, 0), max(bottom - y, 0))

    def overlap(self, other: "Rect") -> float:
        """Return the area both share."""
        shared = self.within(other)
        return shared.width * shared.height

    def lies_in(self, outer: "Rect") -> bool:
        """Whether all of it is inside `outer`."""
        across = outer.x <= self.x and self.right <= outer.right
        return across and outer.y <= self.y and self.bottom <= outer.bottom

    def contains(self, x: float, y: float) -> bool:
        """Whether the point lies inside."""
        return self.x <= x <= self.right and self.y <= y <= self.bottom


@dataclass(frozen=True)
class Canvas:
    """A drawing of a room: where its corner is and how many pixels a metre has."""

    left: float
    top: float
    scale: float
    width: float
    height: float
    size: Size

    @classmethod
    def fit(cls, scene: Scene, size: Size) -> "Canvas":
        """Return the largest drawing of the room that `size` allows."""
        left, right, low, high = _extent(scene)
        wall = 2 * size.wall
        scale = min((size.width - wall) / (right - left), (size.height - wall) / (high - low))
        width, height = (right - left) * scale + wall, (high - low) * scale + wall
        return cls(left, high, scale, width, height, size)

    @property
    def floor(self) -> Rect:
        """The inside of the walls."""
        wall = self.size.wall
        return Rect(wall, wall, self.width - 2 * wall, self.height - 2 * wall)

    def point(self, x: float, z: float) -> tuple[float, float]:
        """Return the pixel of a place in the room."""
        wall = self.size.wall
        return (x - self.left) * self.scale + wall, (self.top - z) * self.scale + wall

    def rect(self, box: Box) -> Rect:
        """Return the footprint of `box`, cut off at the walls."""
        x, y = self.point(box.center.x - box.size.x / 2, box.center.z + box.size.z / 2)
        whole = Rect(x, y, box.size.x * self.scale, box.size.z * self.scale)
        return whole.within(self.floor)


def _extent(scene: Scene) -> tuple[float, float, float, float]:
    """Return left, right, near and far of the room, with room for all that stands in it."""
    bounds = scene.bounds
    boxes = [
        thing.box
        for thing in scene.objects
        if appearance(thing).drawn_as not in ("wall", "hidden") and thing.type != "Floor"
    ]
    if bounds.size.x <= 0 or bounds.size.z <= 0:
        floors = [thing.box for thing in scene.objects if thing.type == "Floor"]
        boxes = floors or boxes
    else:
        boxes = [bounds]
    left = min(box.center.x - box.size.x / 2 for box in boxes)
    right = max(box.center.x + box.size.x / 2 for box in boxes)
    low = min(box.center.z - box.size.z / 2 for box in boxes)
    high = max(box.center.z + box.size.z / 2 for box in boxes)
    return left, right, low, high


class Turned(NamedTuple):
    """A footprint that may stand at an angle: its own width and depth, and its turn."""

    cx: float
    cy: float
    width: float
    depth: float
    yaw: float


def turned(thing: SceneObject, canvas: Canvas) -> Turned:
    """Return the footprint of `thing` in its own axes, worked out from its box and its turn.

    The box is axis-aligned, W = w|cos| + d|sin| and D = w|sin| + d|cos|; near 45° that says
    nothing about w and d apart, so they are taken as equal.
    """
    rect = canvas.rect(thing.box)
    turn = math.radians(thing.yaw)
    cos, sin = abs(math.cos(turn)), abs(math.sin(turn))
    divisor = cos * cos - sin * sin
    if abs(divisor) < 0.3:
        side = min(rect.width, rect.height) / (cos + sin)
        return Turned(rect.cx, rect.cy, side, side, thing.yaw)
    width = (rect.width * cos - rect.height * sin) / divisor
    depth = (rect.height * cos - rect.width * sin) / divisor
    if min(width, depth) < 0.3 * max(width, depth) and min(cos, sin) > 0.1:
        return Turned(rect.cx, rect.cy, rect.width, rect.height, 0.0)
    return Turned(rect.cx, rect.cy, width, depth, thing.yaw)


def bands(thing: SceneObject, scene: Scene, canvas: Canvas) -> list[Rect]:
    """Return the surface of `thing`; a counter around a corner has several parts.

    AI2-THOR reports only the box around such a counter, which would cover the open floor.
    """
    area = canvas.rect(thing.box)
    if thing.type != "CounterTop":
        return [area]
    drawn = []
    for part in counter_parts(thing, scene.objects, scene.bounds):
        x, y = canvas.point(part.x - part.half_width, part.z + part.half_depth)
        size = 2 * part.half_width * canvas.scale, 2 * part.half_depth * canvas.scale
        drawn.append(Rect(x, y, *size).within(area))
    return drawn
