"""Living rooms: a sofa facing a television across a coffee table, and what stands around."""

from reibench.household.furnishing.common import (
    Cramped,
    add_bin,
    add_chairs,
    add_door,
    add_drawers,
    add_pictures,
    add_plant,
    add_windows,
    place,
)
from reibench.household.furnishing.shelves import add_shelving
from reibench.household.geometry import footprint
from reibench.household.layout import Draft, Wall
from reibench.scene import Box, SceneObject, Vector

SOFA = Vector(2.0, 0.85, 0.9)


def furnish_living_room(draft: Draft) -> None:
    """Furnish a living room."""
    wall, along = _sofa(draft)
    opposite = next(one for one in draft.walls if one.yaw == (wall.yaw + 180) % 360)
    stand = _television(draft, opposite, along)
    table = _coffee_table(draft, wall, along)
    sides = _side_tables(draft, wall, along)
    add_door(draft)
    if draft.wants("ArmChair"):
        _arm_chairs(draft, table)
    if draft.wants("FloorLamp"):
        _lamp(draft, wall, along)
    _more_furniture(draft)
    add_bin(draft)
    if draft.wants("HousePlant"):
        add_plant(draft, (*sides, stand))
    cover = "Curtains" if draft.wants("Curtains") else ""
    add_windows(draft, draft.random.choice((1, 2)), cover)
    if draft.wants("Painting"):
        add_pictures(draft, "Painting", draft.random.choice((2, 3)))


def _more_furniture(draft: Draft) -> None:
    if draft.wants("Shelf"):
        add_shelving(draft, draft.random.choice((3, 4)))
    if draft.wants("Dresser"):
        dresser, _, _ = place(draft, "Dresser", Vector(1.0, 0.9, 0.48))
        add_drawers(draft, dresser.box, dresser.yaw, 3, low=0.1, high=0.88, across=2)
    if draft.wants("DiningTable", 0.3):
        box = draft.in_the_open(Vector(1.2, 0.76, 0.8), 0.5)
        if box is not None:
            draft.stand("DiningTable", box)
            add_chairs(draft, box, 2)
    if draft.wants("Desk"):
        place(draft, "Desk", Vector(1.2, 0.76, 0.6))
    if draft.wants("Ottoman"):
        place(draft, "Ottoman", Vector(0.7, 0.43, 0.5), passage=0.2)


def _sofa(draft: Draft) -> tuple[Wall, float]:
    # Against a long wall, about its middle, so that the rest finds its place around it.
    walls = sorted(draft.walls, key=lambda wall: (-wall.length, draft.random.random()))
    for wall in walls[:2]:
        along = round(draft.random.uniform(-0.15, 0.15) * wall.length, 1)
        box = wall.box(along, SOFA, gap=0.05)
        if draft.clear(footprint(box)):
            draft.stand("Sofa", box, wall.yaw)
            return wall, along
    raise Cramped("sofa")


def _television(draft: Draft, wall: Wall, along: float) -> SceneObject:
    extent = Vector(1.5, 0.55, 0.45)
    box = wall.box(along, extent, gap=0.03)
    if not draft.clear(footprint(box)):
        raise Cramped("television")
    stand = draft.stand("TVStand", box, wall.yaw)
    draft.reserve(footprint(wall.box(along, Vector(1.5, 1, 0.6), gap=0.48)))
    if draft.wants("Drawer", 0.8):
        add_drawers(draft, box, wall.yaw, 1, low=0.1, high=0.4, across=3)
    screen = wall.box(along, Vector(1.1, 0.68, 0.12), low=0.55, gap=0.08)
    draft.add("Television", screen, wall.yaw, parent=stand.id)
    return draft.things[stand.id]


def _coffee_table(draft: Draft, wall: Wall, along: float) -> Box | None:
    extent = Vector(1.1, 0.43, 0.6)
    box = wall.box(along, extent, gap=0.05 + SOFA.z + 0.45)
    if draft.wants("CoffeeTable") and draft.clear(footprint(box)):
        draft.stand("CoffeeTable", box, wall.yaw)
        return box
    return None


def _side_tables(draft: Draft, wall: Wall, along: float) -> tuple[SceneObject, ...]:
    """Stand small tables at the ends of the sofa."""
    made = []
    extent = Vector(0.5, 0.6, 0.5)
    sides = [-1, 1]
    draft.random.shuffle(sides)
    for side in sides[: 2 if draft.plenty >= 1 and draft.random.random() < 0.6 else 1]:
        at = along + side * (SOFA.x / 2 + 0.08 + extent.x / 2)
        box = wall.box(at, extent, gap=0.05)
        if draft.wants("SideTable") and draft.clear(footprint(box)):
            table = draft.stand("SideTable", box, wall.yaw)
            draft.reserve(footprint(wall.box(at, Vector(0.5, 1, 0.5), gap=0.55)))
            add_drawers(draft, box, wall.yaw, 1, low=0.35, high=0.55)
            made.append(table)
    if made and draft.wants("DeskLamp"):
        base = made[0].box
        lamp = Vector(0.24, 0.45, 0.24)
        middle = Vector(base.center.x, base.size.y + lamp.y / 2, base.center.z)
        draft.add("DeskLamp", Box(middle, lamp), parent=made[0].id)
        draft.change(next(reversed(draft.things)), on=False)
    return tuple(made[1:])


def _arm_chairs(draft: Draft, table: Box | None) -> None:
    """Stand arm chairs at the ends of the coffee table, or somewhere by a wall."""
    count = draft.random.choice((1, 2))
    if table is not None:
        (x, _, z), (width, _, depth) = table
        across = width >= depth
        reach = max(width, depth) / 2 + 0.45 + 0.42
        for side in (1, -1)[:count]:
            at = Vector(x + side * reach, 0.42, z) if across else Vector(x, 0.42, z + side * reach)
            box = Box(at, Vector(0.84, 0.84, 0.84))
            yaw = (270.0 if side > 0 else 90.0) if across else (180.0 if side > 0 else 0.0)
            if draft.clear(footprint(box).grown(0.05)):
                draft.stand("ArmChair", box, yaw)
                return
    place(draft, "ArmChair", Vector(0.84, 0.84, 0.84), passage=0.4)


def _lamp(draft: Draft, wall: Wall, along: float) -> None:
    """Stand a floor lamp beside the sofa, or in a corner."""
    extent = Vector(0.4, 1.7, 0.4)
    for side in (-1, 1):
        for off in (0.3, 0.85):
            box = wall.box(along + side * (SOFA.x / 2 + off), extent, gap=0.1)
            if draft.clear(footprint(box)):
                draft.change(draft.stand("FloorLamp", box).id, on=False)
                return
    lamp, _, _ = place(draft, "FloorLamp", extent, passage=0.2, corner=True)
    draft.change(lamp.id, on=False)
