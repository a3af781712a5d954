"""Bedrooms: a bed with night stands, a desk with shelves above, a place for clothes."""

from reibench.household.furnishing.common import (
    Cramped,
    add_bin,
    add_door,
    add_drawers,
    add_pictures,
    add_plant,
    add_windows,
    hang,
    place,
)
from reibench.household.furnishing.shelves import add_shelving, hang_shelves
from reibench.household.geometry import footprint
from reibench.household.layout import Draft, Wall
from reibench.scene import Box, SceneObject, Vector

STAND = Vector(0.46, 0.55, 0.42)

OPTIONAL = {
    "LaundryHamper": Vector(0.45, 0.65, 0.45),
    "ArmChair": Vector(0.8, 0.85, 0.8),
    "Safe": Vector(0.45, 0.5, 0.45),
}
"""Furniture that stands in some corner of some bedrooms."""


def furnish_bedroom(draft: Draft) -> None:
    """Furnish a bedroom."""
    wall, along, width = _bed(draft)
    _night_stands(draft, wall, along, width)
    desk = _desk(draft) if draft.wants("Desk", 0.95) else None
    add_door(draft)
    if draft.wants("Dresser", 0.45):
        _dresser(draft)
    if draft.wants("Shelf"):
        _shelves(draft, desk)
    for kind, extent in OPTIONAL.items():
        if draft.wants(kind):
            place(draft, kind, extent, passage=0.4, corner=True)
    add_bin(draft)
    _adorn(draft)


def _adorn(draft: Draft) -> None:
    add_windows(draft, draft.random.choice((1, 2)), "Blinds" if draft.wants("Blinds") else "")
    if draft.wants("Mirror"):
        hang(draft, "Mirror", Vector(0.5, 1.2, 0.04), 0.8)
    if draft.wants("Painting"):
        add_pictures(draft, "Painting", draft.random.choice((1, 2)))
    if draft.wants("Poster"):
        add_pictures(draft, "Poster", 1)
    if draft.wants("HousePlant"):
        add_plant(draft, ())


def _bed(draft: Draft) -> tuple[Wall, float, float]:
    width = draft.random.choice((1.4, 1.6, 1.6))
    extent = Vector(width, 0.9, 2.05)
    walls = sorted(draft.walls, key=lambda wall: (wall.length, draft.random.random()))
    for wall in walls:
        along = round(draft.random.uniform(-0.2, 0.2) * (wall.length - width), 1)
        box = wall.box(along, extent, gap=0.03)
        if draft.clear(footprint(box)):
            draft.stand("Bed", box, wall.yaw)
            return wall, along, width
    raise Cramped("bed")


def _night_stands(draft: Draft, wall: Wall, along: float, width: float) -> None:
    sides = [-1, 1]
    draft.random.shuffle(sides)
    for number, side in enumerate(sides):
        at = along + side * (width / 2 + 0.06 + STAND.x / 2)
        box = wall.box(at, STAND, gap=0.03)
        if not draft.clear(footprint(box)) or not draft.wants("SideTable"):
            continue
        stand = draft.stand("SideTable", box, wall.yaw)
        draft.reserve(footprint(wall.box(at, Vector(STAND.x, 1, 0.8), gap=0.45)))
        count = draft.random.choice((1, 2))
        add_drawers(draft, box, wall.yaw, count, low=0.5 - 0.2 * count, high=0.52)
        if number == 0 and draft.wants("DeskLamp"):
            _lamp(draft, stand, box.center.x, box.center.z)


def _desk(draft: Draft) -> tuple[Wall, float]:
    extent = Vector(draft.random.choice((1.2, 1.4)), 0.76, 0.65)
    desk, wall, along = place(draft, "Desk", extent, passage=0.8)
    # The drawers fill one end; the chair stands before the other.
    side = draft.random.choice((-1, 1))
    end = wall.box(along + side * (extent.x / 2 - 0.22), Vector(0.4, 0.7, 0.55), gap=0.06)
    add_drawers(draft, end, wall.yaw, 3, low=0.1, high=0.68)
    if draft.wants("Chair"):
        chair = Vector(0.44, 0.9, 0.44)
        box = wall.box(along - side * 0.2, chair, gap=extent.z - 0.12)
        draft.stand("Chair", box, (wall.yaw + 180) % 360)
    if draft.wants("DeskLamp"):
        back = wall.box(along + side * (extent.x / 2 - 0.17), Vector(0.22, 1, 0.22), gap=0.08)
        _lamp(draft, desk, back.center.x, back.center.z)
    return wall, along


def _dresser(draft: Draft) -> None:
    dresser, at, _ = place(draft, "Dresser", Vector(1.1, 0.85, 0.48))
    add_drawers(draft, dresser.box, dresser.yaw, 3, low=0.1, high=0.83, across=2)
    if draft.wants("Television"):
        screen = Vector(0.9, 0.6, 0.12)
        middle = dresser.box.center._replace(y=0.85 + 0.3)
        size = screen if at.yaw in (0, 180) else Vector(screen.z, screen.y, screen.x)
        draft.add("Television", Box(middle, size), at.yaw, parent=dresser.id)


def _lamp(draft: Draft, base: SceneObject, x: float, z: float) -> None:
    height = 0.42
    middle = Vector(x, base.box.size.y + height / 2, z)
    lamp = draft.add("DeskLamp", Box(middle, Vector(0.22, height, 0.22)), parent=base.id)
    draft.change(lamp.id, on=False)


def _shelves(draft: Draft, desk: tuple[Wall, float] | None) -> None:
    """Hang shelves over the desk, or stand a unit somewhere."""
    if desk is not None and hang_shelves(draft, *desk, levels=2, low=1.35):
        return
    add_shelving(draft, 4)
