"""Kitchens: counters along one or two walls, with sink, stove and fridge; a table if it fits."""

from typing import NamedTuple

from reibench.household.furnishing.common import (
    Cramped,
    add_bin,
    add_chairs,
    add_door,
    add_drawers,
    add_plant,
    add_windows,
    hang,
    place,
)
from reibench.household.geometry import footprint
from reibench.household.layout import PASSAGE, Draft, Wall
from reibench.scene import Box, SceneObject, Vector

DEPTH = 0.64
TOP = 0.92
"""Of a counter: how far it stands out from the wall, and how high its top is."""
SLAB = 0.04
HUNG = 1.45
"""Height of the lower side of wall cabinets."""
SINK, STOVE = 0.8, 0.62
"""Widths of the counter they take."""


class Run(NamedTuple):
    """A counter along a wall, from one place along it to another."""

    wall: Wall
    begin: float
    end: float


def furnish_kitchen(draft: Draft) -> None:
    """Furnish a kitchen."""
    back, _, left, right = draft.walls
    fridge = Vector(0.76, 1.85, 0.8)
    side, mirrored = (left, 1) if draft.random.random() < 0.5 else (right, -1)
    # The fridge ends the counter at the corner where the second wall has none.
    corner = mirrored * (draft.width / 2 - fridge.x / 2 - 0.03)
    draft.stand("Fridge", back.box(corner, fridge, gap=0.03), back.yaw)
    draft.reserve(footprint(back.box(corner, fridge._replace(z=PASSAGE), gap=0.03 + fridge.z)))
    inner = corner - mirrored * (fridge.x / 2 + 0.03)
    ends = sorted((inner, -mirrored * draft.width / 2))
    main = Run(back, ends[0], ends[1])
    counters = [_main_counter(draft, main, mirrored)]
    reach = draft.random.uniform(1.3, 1.9) * min(draft.plenty, 1.5)
    end = draft.depth / 2 - DEPTH
    if draft.wants("CounterTop", 0.9):
        counters.append(_side_counter(draft, Run(side, max(end - reach, -end + 0.9), end)))
    _appliances(draft, counters)
    add_door(draft)
    if draft.wants("DiningTable"):
        _dining_table(draft)
    elif draft.random.random() < 0.7:
        _island(draft)
    if draft.wants("SideTable"):
        place(draft, "SideTable", Vector(0.5, 0.7, 0.45))
    if draft.wants("Shelf"):
        hang(draft, "Shelf", Vector(0.8, 0.25, 0.25), 1.4)
    add_bin(draft)
    if draft.wants("HousePlant"):
        add_plant(draft, ())
    add_windows(draft, 1, "Blinds" if draft.wants("Blinds") else "")


def _main_counter(draft: Draft, run: Run, mirrored: int) -> SceneObject:
    """Build the counter with sink and stove; its far end turns the corner."""
    counter = _slab(draft, run)
    begin, end = run.begin, run.end
    # The last stretch is behind the side counter, where nobody gets at a cabinet.
    usable = (begin + DEPTH, end) if mirrored > 0 else (begin, end - DEPTH)
    length = usable[1] - usable[0]
    if length < SINK + STOVE + 0.4:
        raise Cramped("counter")
    modules = ["sink", "stove"]
    draft.random.shuffle(modules)
    spare = length - SINK - STOVE
    count = max(1, min(6, round(spare / 0.5 * min(1.0, draft.plenty))))
    kinds = ["drawers" if each % 2 else "cabinet" for each in range(count)]
    order = [kinds.pop(), modules[0]]
    order += [kinds.pop()] if kinds else []
    order += [modules[1], *kinds]
    width = spare / count
    at = usable[0]
    for module in order:
        wide = {"sink": SINK, "stove": STOVE}.get(module, width)
        _MODULES[module](draft, run.wall, at + wide / 2, wide, counter)
        at += wide
    return draft.things[counter.id]


def _side_counter(draft: Draft, run: Run) -> SceneObject:
    counter = _slab(draft, run)
    length = run.end - run.begin
    count = max(1, min(4, round(length / 0.5 * min(1.0, draft.plenty))))
    width = length / count
    for number in range(count):
        module = "cabinet" if number % 2 else "drawers"
        _MODULES[module](draft, run.wall, run.begin + width * (number + 0.5), width, counter)
    return draft.things[counter.id]


def _slab(draft: Draft, run: Run) -> SceneObject:
    extent = Vector(run.end - run.begin, SLAB, DEPTH)
    along = (run.begin + run.end) / 2
    box = run.wall.box(along, extent, low=TOP - SLAB)
    draft.bodies.append(footprint(box))
    passage = run.wall.box(along, Vector(extent.x - 0.1, 1, PASSAGE), gap=DEPTH)
    draft.reserve(footprint(passage))
    return draft.add("CounterTop", box, run.wall.yaw)


def _cabinet(draft: Draft, wall: Wall, along: float, width: float, counter: SceneObject) -> None:
    extent = Vector(width - 0.02, 0.76, 0.58)
    draft.add("Cabinet", wall.box(along, extent, low=0.1, gap=0.02), wall.yaw)
    _hung_cabinet(draft, wall, along, width)


def _drawers(draft: Draft, wall: Wall, along: float, width: float, counter: SceneObject) -> None:
    body = wall.box(along, Vector(width, 0.76, 0.58), low=0.1, gap=0.02)
    count = draft.random.choice((3, 4)) if draft.plenty >= 1 else 2
    add_drawers(draft, body, wall.yaw, count, low=0.1, high=0.86)
    _hung_cabinet(draft, wall, along, width)


def _hung_cabinet(draft: Draft, wall: Wall, along: float, width: float) -> None:
    extent = Vector(width - 0.02, 0.7, 0.34)
    if draft.random.random() < 0.8 * draft.plenty and draft.free_wall(wall, along, extent, HUNG):
        draft.add("Cabinet", wall.box(along, extent, low=HUNG), wall.yaw)


def _sink(draft: Draft, wall: Wall, along: float, width: float, counter: SceneObject) -> None:
    extent = Vector(width - 0.12, 0.2, 0.48)
    sink = draft.add("Sink", wall.box(along, extent, low=TOP - 0.17, gap=0.1), wall.yaw)
    inner = Vector(width - 0.24, 0.15, 0.38)
    basin = wall.box(along, inner, low=TOP - 0.15, gap=0.15)
    draft.add("SinkBasin", basin, wall.yaw, part_of=sink.id)
    tap = Vector(0.08, 0.26, 0.16)
    draft.add("Faucet", wall.box(along, tap, low=TOP, gap=0.03), wall.yaw)
    below = Vector(width - 0.02, 0.6, 0.58)
    draft.add("Cabinet", wall.box(along, below, low=0.1, gap=0.02), wall.yaw)
    window = Vector(0.9, 1.0, 0.06)
    if draft.wants("Window", 0.9) and draft.free_wall(wall, along, window, 1.25):
        draft.add("Window", wall.box(along, window, low=1.25), wall.yaw)


def _stove(draft: Draft, wall: Wall, along: float, width: float, counter: SceneObject) -> None:
    burners = []
    for gap in (0.34, 0.07):
        for off in (-0.145, 0.145):
            extent = Vector(0.26, 0.03, 0.26)
            box = wall.box(along + off, extent, low=TOP, gap=gap)
            burners.append(draft.add("StoveBurner", box, wall.yaw).id)
    for number, burner in enumerate(burners):
        off = (number - 1.5) * 0.13
        box = wall.box(along + off, Vector(0.05, 0.05, 0.04), low=TOP - 0.08, gap=DEPTH)
        knob = draft.add("StoveKnob", box, wall.yaw)
        draft.controls[knob.id] = (burner,)


_MODULES = {"cabinet": _cabinet, "drawers": _drawers, "sink": _sink, "stove": _stove}


def _appliances(draft: Draft, counters: list[SceneObject]) -> None:
    """Stand microwave, coffee machine and toaster at the back of the counters."""
    kinds = [
        ("Microwave", Vector(0.5, 0.32, 0.38)),
        ("CoffeeMachine", Vector(0.26, 0.36, 0.32)),
        ("Toaster", Vector(0.3, 0.2, 0.2)),
    ]
    for kind, extent in kinds:
        draft.random.shuffle(counters)
        spots = [spot for counter in counters for spot in _backs(draft, counter, extent)]
        if not spots:
            raise Cramped(kind)
        counter, wall, along = spots[0]
        box = wall.box(along, extent, low=TOP, gap=0.06)
        draft.add(kind, box, wall.yaw, parent=counter.id)


def _backs(
    draft: Draft, counter: SceneObject, extent: Vector
) -> list[tuple[SceneObject, Wall, float]]:
    """Return free places at the back of a counter."""
    wall = next(wall for wall in draft.walls if wall.yaw == counter.yaw)
    sideways = counter.yaw in (90, 270)
    (x, _, z), (width, _, depth) = counter.box
    middle, length = (z, depth) if sideways else (x, width)
    found = []
    for step in range(int((length - extent.x) / 0.1) + 1):
        along = middle - (length - extent.x) / 2 + step * 0.1
        # Not over the front edge of the stove, nor so near another that no hand fits between.
        area = footprint(wall.box(along, Vector(extent.x + 0.1, 1, DEPTH)))
        taken = (
            other
            for other in draft.things.values()
            if other.type in ("Sink", "StoveBurner", "Microwave", "CoffeeMachine", "Toaster")
        )
        if not any(area.meets(footprint(other.box)) for other in taken):
            found.append((counter, wall, along))
    draft.random.shuffle(found)
    return found


def _island(draft: Draft) -> None:
    """Build a counter with cabinets into the open floor."""
    box = draft.in_the_open(Vector(1.3, TOP, DEPTH), 0.75)
    if box is None:
        return
    draft.bodies.append(footprint(box))
    (x, _, z), (width, _, depth) = box
    slab = Box(Vector(x, TOP - SLAB / 2, z), Vector(width, SLAB, depth))
    draft.add("CounterTop", slab)
    for off in (-0.25, 0.25):
        middle = Vector(x + off * width, 0.48, z)
        draft.add("Cabinet", Box(middle, Vector(width / 2 - 0.02, 0.76, depth - 0.04)), 180)


def _dining_table(draft: Draft) -> None:
    """Put a table with chairs into the open floor, or against a wall."""
    long = draft.random.choice((1.1, 1.3))
    extents = [Vector(long, 0.78, 0.8), Vector(0.8, 0.78, long), Vector(0.9, 0.78, 0.7)]
    box: Box | None = None
    for extent in extents:
        box = draft.in_the_open(extent, 0.55)
        if box is not None:
            break
    if box is None:
        place(draft, "DiningTable", Vector(0.9, 0.78, 0.7), passage=0.5)
        return
    draft.stand("DiningTable", box)
    if draft.wants("Chair", 0.9):
        add_chairs(draft, box, draft.random.choice((2, 4)))
