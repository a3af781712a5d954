"""Scenery: the blocks a room is drawn with, furniture in a few parts so that it is recognised."""

from collections.abc import Iterator
from math import cos, radians, sin
from typing import NamedTuple

from reibench.household.state import Moment, hidden
from reibench.household.unity.palette import Color, color_of
from reibench.household.unity.raycast import Block
from reibench.scene import CONTAINERS, Box, Pose, SceneObject, Vector


class Part(NamedTuple):
    """A part of a thing: its middle and extent as shares of the whole, which faces +z."""

    x: float
    y: float
    z: float
    width: float
    height: float
    depth: float


LIFT = 0.002
"""Metres by which undersides are raised, so that a thing on the floor is nearer than the floor."""
WALL: Color = (226, 220, 208)
ROBOT: Color = (60, 120, 220)
BEAK: Color = (250, 210, 60)
LEGS = tuple(Part(x, 0.46, z, 0.07, 0.92, 0.07) for x in (0.05, 0.95) for z in (0.05, 0.95))
TABLE = (Part(0.5, 0.96, 0.5, 1, 0.08, 1), *LEGS)
CHAIR_LEGS = tuple(Part(x, 0.22, z, 0.1, 0.44, 0.1) for x in (0.08, 0.92) for z in (0.08, 0.92))
CHAIR = (Part(0.5, 0.47, 0.5, 1, 0.07, 1), Part(0.5, 0.75, 0.06, 1, 0.5, 0.12), *CHAIR_LEGS)
SEAT = (
    Part(0.5, 0.25, 0.5, 1, 0.5, 1),
    Part(0.5, 0.5, 0.12, 1, 1, 0.24),
    Part(0.06, 0.36, 0.5, 0.12, 0.72, 1),
    Part(0.94, 0.36, 0.5, 0.12, 0.72, 1),
)
BED = (Part(0.5, 0.3, 0.5, 1, 0.6, 1), Part(0.5, 0.5, 0.03, 1, 1, 0.06))
LAMP = (
    Part(0.5, 0.02, 0.5, 0.7, 0.04, 0.7),
    Part(0.5, 0.4, 0.5, 0.12, 0.8, 0.12),
    Part(0.5, 0.84, 0.5, 1, 0.32, 1),
)
TOILET = (Part(0.5, 0.25, 0.6, 0.9, 0.5, 0.8), Part(0.5, 0.5, 0.12, 1, 1, 0.24))
PARTS: dict[str, tuple[Part, ...]] = {
    **dict.fromkeys(("DiningTable", "CoffeeTable", "SideTable", "Desk", "Stool"), TABLE),
    "Chair": CHAIR,
    **dict.fromkeys(("Sofa", "ArmChair"), SEAT),
    "Bed": BED,
    **dict.fromkeys(("FloorLamp", "DeskLamp"), LAMP),
    "Toilet": TOILET,
}
OPEN_ABOVE = frozenset(("Drawer", "Box", "LaundryHamper"))
"""Containers that open at the top; the others open at their front."""


def blocks(moment: Moment, *, robot: bool) -> list[Block]:
    """Return all that is not hidden in something closed, big things first; the robot if asked."""
    found: list[Block] = []
    for thing in sorted(moment.objects.values(), key=_size, reverse=True):
        if thing.type != "Floor" and not hidden(moment.objects, thing):
            found += _of_thing(thing)
    return found + (list(_of_robot(moment.agent)) if robot else [])


def room_block(bounds: Box) -> Block:
    """Return the room itself."""
    block = _block(bounds, WALL)
    x, y, z = block.low
    return block._replace(low=(x, y - LIFT, z))


def _size(thing: SceneObject) -> float:
    width, height, depth = thing.box.size
    return width * height * depth


def _of_thing(thing: SceneObject) -> Iterator[Block]:
    color = _painted(thing)
    opening = None
    if thing.open and thing.type in CONTAINERS:
        opening = (1, 1) if thing.type in OPEN_ABOVE else _front(thing.yaw)
    for part in PARTS.get(thing.type, ()):
        yield _block(_placed(part, thing.box, thing.yaw), color)
    if thing.type not in PARTS:
        yield _block(thing.box, color, opening)


def _painted(thing: SceneObject) -> Color:
    red, green, blue = color_of(thing.type)
    if thing.dirty:
        return red * 2 // 3, green * 3 // 5, blue // 2
    if thing.toggleable and not thing.on and thing.type.endswith("Lamp"):
        return red * 2 // 3, green * 2 // 3, blue * 2 // 3
    if thing.on and thing.type in ("Microwave", "StoveBurner", "Toaster", "Television"):
        return min(255, red + 110), green, blue
    return red, green, blue


def _front(yaw: float) -> tuple[int, int]:
    """Return the side a thing faces: the axis, and the direction along it."""
    quarter = round(yaw / 90) % 4
    return (0 if quarter % 2 else 2), (1 if quarter < 2 else -1)


def _placed(part: Part, box: Box, yaw: float) -> Box:
    """Return where a part is, of a thing turned to the nearest quarter."""
    (x, y, z), (width, height, depth) = box
    quarter = round(yaw / 90) % 4
    right, ahead = part.x - 0.5, part.z - 0.5
    if quarter % 2:
        extent = Vector(part.depth * width, part.height * height, part.width * depth)
    else:
        extent = Vector(part.width * width, part.height * height, part.depth * depth)
    turn = radians(90 * quarter)
    off_x, off_z = right * cos(turn) + ahead * sin(turn), ahead * cos(turn) - right * sin(turn)
    middle = Vector(x + off_x * width, y + (part.y - 0.5) * height, z + off_z * depth)
    return Box(middle, extent)


def _of_robot(pose: Pose) -> Iterator[Block]:
    """Draw the robot as others see it: a body, and a beak that shows where it looks."""
    (x, _, z), turn = pose.position, radians(pose.yaw)
    yield _block(Box(Vector(x, 0.75, z), Vector(0.36, 1.5, 0.36)), ROBOT)
    tip = Vector(x + 0.2 * sin(turn), 1.56, z + 0.2 * cos(turn))
    yield _block(Box(tip, Vector(0.16, 0.1, 0.16)), BEAK)


def _block(box: Box, color: Color, opening: tuple[int, int] | None = None) -> Block:
    (x, y, z), (width, height, depth) = box
    low = x - width / 2, y - height / 2 + LIFT, z - depth / 2
    high = x + width / 2, y + height / 2, z + depth / 2
    return Block(low, high, color, opening)
