"""Bathrooms: a wash basin in a counter, a toilet, a tub or a shower, towels on the wall."""

from reibench.household.furnishing.common import (
    Cramped,
    add_bin,
    add_door,
    add_drawers,
    add_windows,
    hang,
    place,
)
from reibench.household.furnishing.shelves import hang_shelves
from reibench.household.geometry import footprint
from reibench.household.layout import Draft, Wall
from reibench.scene import Vector

TOP, DEPTH = 0.86, 0.55
"""Of the counter around the basin."""


def furnish_bathroom(draft: Draft) -> None:
    """Furnish a bathroom."""
    if draft.wants("Bathtub"):
        _tub(draft)
    else:
        _shower(draft)
    _counter(draft)
    add_door(draft)
    _toilet(draft)
    add_bin(draft)
    for kind, extent, low in (
        ("TowelHolder", Vector(0.66, 0.05, 0.1), 1.3),
        ("HandTowelHolder", Vector(0.2, 0.2, 0.06), 1.5),
    ):
        if draft.wants(kind):
            towel = Vector(extent.x + 0.1, 0.7, 0.15)
            hung = hang(draft, kind, extent, low, space=towel)
            if hung is None:
                raise Cramped(kind)
    if draft.wants("SideTable"):
        place(draft, "SideTable", Vector(0.4, 0.6, 0.35))
    if draft.wants("Shelf"):
        _shelves(draft)
    if draft.wants("Window"):
        add_windows(draft, 1)


def _tub(draft: Draft) -> None:
    extent = Vector(1.7, 0.55, 0.78)
    found = draft.along_wall(extent, passage=0.6, gap=0.02, corner=True)
    if found is None:
        raise Cramped("tub")
    wall, along = found
    tub = draft.stand("Bathtub", wall.box(along, extent, gap=0.02), wall.yaw)
    inner = wall.box(along, Vector(1.5, 0.42, 0.6), low=0.12, gap=0.11)
    draft.add("BathtubBasin", inner, wall.yaw, part_of=tub.id)
    end = 0.75 if along > 0 else -0.75
    draft.add("Faucet", wall.box(along + end, Vector(0.1, 0.2, 0.14), low=0.56, gap=0.3), wall.yaw)
    if draft.wants("ShowerHead"):
        head = wall.box(along + end, Vector(0.2, 0.9, 0.2), low=1.3, gap=0.25)
        draft.add("ShowerHead", head, wall.yaw)
    if draft.wants("ShowerCurtain", 0.6):
        # Drawn aside, at the far end of the tub's front.
        cloth = wall.box(along - end * 0.9, Vector(0.3, 1.9, 0.06), low=0.15, gap=0.82)
        draft.add("ShowerCurtain", cloth, wall.yaw)


def _shower(draft: Draft) -> None:
    extent = Vector(0.95, 0.1, 0.95)
    found = draft.along_wall(extent, passage=0.6, gap=0.0, corner=True)
    if found is None:
        raise Cramped("shower")
    wall, along = found
    draft.bodies.append(footprint(wall.box(along, extent)))
    door = wall.box(along, Vector(0.9, 1.95, 0.04), low=0.05, gap=0.95)
    draft.add("ShowerDoor", door, wall.yaw)
    side = -1 if along > 0 else 1
    glass = wall.box(along + side * 0.47, Vector(0.04, 1.95, 0.92), low=0.05, gap=0.01)
    draft.add("ShowerGlass", glass, wall.yaw)
    head = wall.box(along, Vector(0.2, 0.9, 0.3), low=1.2, gap=0.02)
    draft.add("ShowerHead", head, wall.yaw)


def _counter(draft: Draft) -> None:
    length = draft.random.choice((1.0, 1.3, 1.6))
    extent = Vector(length, TOP, DEPTH)
    found = draft.along_wall(extent, passage=0.7, gap=0.0)
    if found is None:
        raise Cramped("wash basin")
    wall, along = found
    draft.bodies.append(footprint(wall.box(along, extent)))
    slab = wall.box(along, extent._replace(y=0.04), low=TOP - 0.04)
    draft.add("CounterTop", slab, wall.yaw)
    _basin(draft, wall, along)
    mirror = Vector(length - 0.1, 0.9, 0.03)
    draft.add("Mirror", wall.box(along, mirror, low=1.15), wall.yaw)
    below = wall.box(along, Vector(length, 0.7, DEPTH - 0.05), low=0.1)
    if draft.wants("Drawer", 0.6):
        add_drawers(draft, below, wall.yaw, 2, low=0.1, high=0.78, across=2)
    else:
        for off in (-0.25, 0.25):
            half = Vector(length / 2 - 0.02, 0.68, DEPTH - 0.05)
            box = wall.box(along + off * length, half, low=0.1)
            draft.add("Cabinet", box, wall.yaw)


def _basin(draft: Draft, wall: Wall, along: float) -> None:
    sink = draft.add("Sink", wall.box(along, Vector(0.56, 0.18, 0.4), low=TOP - 0.15, gap=0.1))
    inner = wall.box(along, Vector(0.46, 0.13, 0.32), low=TOP - 0.13, gap=0.14)
    draft.add("SinkBasin", inner, wall.yaw, part_of=sink.id)
    tap = wall.box(along, Vector(0.08, 0.2, 0.14), low=TOP, gap=0.02)
    draft.add("Faucet", tap, wall.yaw)


def _toilet(draft: Draft) -> None:
    extent = Vector(0.46, 0.95, 0.68)
    found = draft.along_wall(extent, passage=0.6, gap=0.02)
    if found is None:
        raise Cramped("toilet")
    wall, along = found
    draft.stand("Toilet", wall.box(along, extent, gap=0.02), wall.yaw)
    holder = Vector(0.18, 0.12, 0.1)
    for side in (0.42, -0.42):
        if draft.free_wall(wall, along + side, holder, 0.7):
            draft.add("ToiletPaperHanger", wall.box(along + side, holder, low=0.7), wall.yaw)
            return
    raise Cramped("paper hanger")


def _shelves(draft: Draft) -> None:
    """Hang shelves anywhere but over the tub."""
    tubs = [thing for thing in draft.things.values() if thing.type == "Bathtub"]
    for wall in draft.walls:
        for step in range(-10, 11):
            along = step * wall.length / 22
            below = footprint(wall.box(along, Vector(0.9, 1, 0.25)))
            if any(below.meets(footprint(tub.box)) for tub in tubs):
                continue
            if hang_shelves(draft, wall, along, 2, low=1.2):
                return
