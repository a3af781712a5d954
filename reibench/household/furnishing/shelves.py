"""Shelves: units that stand on the floor, and boards on the wall."""

from reibench.household.furnishing.common import place
from reibench.household.layout import Draft, Wall
from reibench.scene import Vector

UNIT = Vector(0.9, 1.6, 0.36)


def add_shelving(draft: Draft, levels: int) -> None:
    """Stand a shelving unit against a wall; its levels are shelves of their own."""
    unit, wall, along = place(draft, "ShelvingUnit", UNIT)
    height = UNIT.y / levels
    for level in range(levels):
        extent = Vector(UNIT.x - 0.06, height - 0.04, UNIT.z - 0.02)
        box = wall.box(along, extent, low=level * height + 0.03, gap=0.04)
        draft.add("Shelf", box, unit.yaw)


def hang_shelves(draft: Draft, wall: Wall, along: float, levels: int, *, low: float) -> int:
    """Hang boards over each other on a wall and return how many found room."""
    made = 0
    for level in range(levels):
        extent = Vector(0.9, 0.26, 0.24)
        if draft.free_wall(wall, along, extent, low + level * 0.36):
            draft.add("Shelf", wall.box(along, extent, low=low + level * 0.36), wall.yaw)
            made += 1
    return made
