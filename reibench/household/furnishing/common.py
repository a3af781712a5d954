"""What every kind of room has: a door, a light switch, windows, pictures, a bin."""

from reibench.household.geometry import footprint
from reibench.household.layout import Draft, Wall
from reibench.scene import Box, SceneObject, Vector

DOOR = Vector(0.9, 2.0, 0.9)
"""Width and height of the doorway, and how much floor before it stays free."""
DRAWER_GAP = 0.01


class Cramped(Exception):
    """A layout in which something necessary found no place; another one is tried."""


def add_door(draft: Draft, walls: tuple[Wall, ...] | None = None) -> None:
    """Leave a doorway free, near a corner, with the light switch beside it."""
    found = draft.along_wall(DOOR, walls=walls or draft.walls, passage=0, gap=0, corner=True)
    if found is None:
        raise Cramped("no doorway")
    wall, along = found
    draft.reserve(footprint(wall.box(along, DOOR)))
    side = -1 if along > 0 else 1
    extent = Vector(0.1, 0.15, 0.03)
    for beside in (along + side * 0.6, along - side * 0.6):
        if draft.free_wall(wall, beside, extent, 1.25):
            draft.add("LightSwitch", wall.box(beside, extent, low=1.25), wall.yaw)
            # Somebody has to get at the switch.
            draft.reserve(footprint(wall.box(beside, Vector(0.3, 1, 0.6))))
            return
    raise Cramped("no light switch")


def add_bin(draft: Draft) -> None:
    """Put a bin somewhere by a wall."""
    extent = Vector(0.34, 0.5, 0.34)
    place(draft, "GarbageCan", extent, passage=0.3, corner=True)


def place(
    draft: Draft,
    kind: str,
    extent: Vector,
    *,
    passage: float = 0.7,
    corner: bool = False,
    walls: tuple[Wall, ...] | None = None,
) -> tuple[SceneObject, Wall, float]:
    """Stand a piece of furniture against a wall; raises Cramped."""
    found = draft.along_wall(extent, walls=walls, passage=passage, corner=corner)
    if found is None:
        raise Cramped(kind)
    wall, along = found
    thing = draft.stand(kind, wall.box(along, extent, gap=0.03), wall.yaw)
    return thing, wall, along


def hang(
    draft: Draft, kind: str, extent: Vector, low: float, *, space: Vector | None = None
) -> tuple[Wall, float] | None:
    """Hang something on a free piece of wall; None where there is none.

    `space` is how much has to be free, from as high as the thing's upper side down, if that is
    more than the thing itself.
    """
    places = []
    for wall in draft.walls:
        steps = int((wall.length - extent.x) / 0.2)
        for step in range(steps + 1):
            along = -(wall.length - extent.x) / 2 + step * 0.2
            places.append((abs(along) + draft.random.random(), wall, along))
    needed = space or extent
    for _, wall, along in sorted(places, key=lambda place: place[0]):
        if draft.free_wall(wall, along, needed, low + extent.y - needed.y):
            draft.add(kind, wall.box(along, extent, low=low), wall.yaw)
            return wall, along
    return None


def add_windows(draft: Draft, count: int, cover: str = "") -> None:
    """Put windows into free walls, some with curtains or blinds before them."""
    window = Vector(1.2, 1.3, 0.06)
    curtains = Vector(1.5, 2.1, 0.12)
    for _ in range(count):
        wide = Vector(1.5, 2.1, 0.25) if cover == "Curtains" else Vector(1.3, 1.3, 0.3)
        found = hang(draft, "Window", window, 1.0, space=wide)
        if found is None:
            return
        wall, along = found
        if cover == "Blinds":
            extent = Vector(1.2, 0.2, 0.04)
            draft.add("Blinds", wall.box(along, extent, low=2.1, gap=0.06), wall.yaw)
        elif cover == "Curtains":
            draft.add("Curtains", wall.box(along, curtains, low=0.2, gap=0.06), wall.yaw)


def add_pictures(draft: Draft, kind: str, count: int) -> None:
    """Hang pictures."""
    for _ in range(count):
        width = draft.random.choice((0.5, 0.7, 0.9))
        hang(draft, kind, Vector(width, 0.6, 0.04), 1.45)


def add_plant(draft: Draft, surfaces: tuple[SceneObject, ...]) -> None:
    """Put a house plant on one of the surfaces, or on the floor."""
    if surfaces and draft.random.random() < 0.7:
        base = draft.random.choice(surfaces)
        (x, y, z), (width, height, depth) = base.box
        shift = (width / 2 - 0.16) * draft.random.choice((-1, 1))
        deep = (depth / 2 - 0.16) * draft.random.choice((-1, 1))
        if width > depth:
            deep = 0 if depth < 0.4 else deep
        else:
            shift = 0 if width < 0.4 else shift
        size = Vector(0.28, 0.45, 0.28)
        box = Box(Vector(x + shift, y + height / 2 + 0.225, z + deep), size)
        area = footprint(box)
        near = (each for each in draft.things.values() if base.id in each.parents)
        if not any(area.meets(footprint(each.box)) for each in near):
            draft.add("HousePlant", box, parent=base.id)
            return
    place(draft, "HousePlant", Vector(0.4, 0.9, 0.4), passage=0, corner=True)


def add_drawers(
    draft: Draft, body: Box, yaw: float, count: int, *, low: float, high: float, across: int = 1
) -> None:
    """Divide the front of a piece of furniture into `count` drawers over each other.

    `across` of them stand side by side; `low` and `high` bound them in height.
    """
    sideways = yaw in (90, 270)
    (x, _, z), (width, _, depth) = body
    breadth, length = (depth, width) if sideways else (width, depth)
    height = (high - low) / count
    for row in range(count):
        for column in range(across):
            off = breadth * ((column + 0.5) / across - 0.5)
            middle = low + height * (row + 0.5)
            extent = (breadth / across - 2 * DRAWER_GAP, height - DRAWER_GAP, length - 0.04)
            box = (
                Box(Vector(x, middle, z + off), Vector(extent[2], extent[1], extent[0]))
                if sideways
                else Box(Vector(x + off, middle, z), Vector(*extent))
            )
            draft.add("Drawer", box, yaw)


def add_chairs(draft: Draft, table: Box, count: int) -> None:
    """Push chairs under the long sides of a table, or the short ones of a small one."""
    (x, _, z), (width, _, depth) = table
    chair = Vector(0.42, 0.9, 0.42)
    across = width >= depth
    for number in range(count):
        side = 1 if number % 2 else -1
        off = (0.0 if count == 2 else (0.27 if number < 2 else -0.27)) * max(width, depth) / 1.1
        out = ((depth if across else width) / 2 + 0.08) * side
        middle = Vector(x + off, 0.45, z + out) if across else Vector(x + out, 0.45, z + off)
        yaw = (180.0 if side > 0 else 0.0) if across else (270.0 if side > 0 else 90.0)
        core = footprint(Box(middle, chair)).grown(-0.15)
        if not any(core.meets(each) for each in draft.bodies):
            draft.stand("Chair", Box(middle, chair), yaw)
