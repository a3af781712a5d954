"""The walkable floor: where in a room the robot can stand."""

from collections.abc import Iterable
from functools import partial
from math import ceil, dist, floor

from reibench.household.geometry import Footprint, bottom, footprint, top
from reibench.scene import Box, SceneObject, Vector

GRID = 0.25
"""Distance between neighbouring positions, AI2-THOR's default."""
RADIUS = 0.2
"""The robot's, in metres."""
STANDING = 0.9
"""Height AI2-THOR reports for the robot's position."""
HEADROOM = 1.0
"""What hangs higher than this is above the robot's shoulders or flat on the wall."""


class WalkableFloor:
    """The part of a room's floor the robot can reach from where it starts."""

    def __init__(
        self, bounds: Box, objects: Iterable[SceneObject], start: Vector | None, grid: float = GRID
    ) -> None:
        self.obstacles = [
            (thing.id, footprint(thing.box).grown(RADIUS)) for thing in objects if blocks(thing)
        ]
        self._inside = footprint(bounds).grown(-RADIUS)
        self._grid = grid
        free = self._free_cells()
        cells = _connected(free, self._cell(start.x, start.z) if start else None)
        self._cells = frozenset(cells)
        self.points = tuple(Vector(x * grid, STANDING, z * grid) for x, z in sorted(cells))

    def blocker(self, x: float, z: float) -> str:
        """Return the id of what keeps the robot from standing there, `wall`, or nothing."""
        if not self._inside.covers(x, z):
            return "wall"
        return next((name for name, area in self.obstacles if area.covers(x, z)), "")

    def reaches(self, x: float, z: float) -> bool:
        """Whether the robot can get to that point: on the grid, or free and next to it."""
        column, row = self._cell(x, z)
        on_grid = abs(x - column * self._grid) < 1e-3 and abs(z - row * self._grid) < 1e-3
        if on_grid:
            return (column, row) in self._cells
        near = ((column + i, row + j) in self._cells for i in (-1, 0, 1) for j in (-1, 0, 1))
        return any(near) and not self.blocker(x, z)

    def _cell(self, x: float, z: float) -> tuple[int, int]:
        return round(x / self._grid), round(z / self._grid)

    def _free_cells(self) -> set[tuple[int, int]]:
        grid, inside = self._grid, self._inside
        cells = {
            (column, row)
            for column in range(ceil(inside.left / grid), floor(inside.right / grid) + 1)
            for row in range(ceil(inside.near / grid), floor(inside.far / grid) + 1)
        }
        for _, area in self.obstacles:
            cells -= set(_covered(area, grid))
        return cells


def blocks(thing: SceneObject) -> bool:
    """Whether the robot has to walk around it; small things it steps over."""
    if thing.pickupable or thing.type == "Floor":
        return False
    return bottom(thing.box) < HEADROOM and top(thing.box) > 0.15


def _covered(area: Footprint, grid: float) -> Iterable[tuple[int, int]]:
    for column in range(ceil(area.left / grid), floor(area.right / grid) + 1):
        for row in range(ceil(area.near / grid), floor(area.far / grid) + 1):
            yield column, row


def _connected(free: set[tuple[int, int]], start: tuple[int, int] | None) -> set[tuple[int, int]]:
    """Return the connected part of `free` around `start`, or the largest one."""
    if start is not None and free:
        return _flood(free, min(free, key=partial(dist, start)))
    best: set[tuple[int, int]] = set()
    left = set(free)
    while left:
        part = _flood(left, min(left))
        left -= part
        best = max(best, part, key=len)
    return best


def _flood(free: set[tuple[int, int]], start: tuple[int, int]) -> set[tuple[int, int]]:
    found, edge = {start}, [start]
    while edge:
        column, row = edge.pop()
        for step in ((column + 1, row), (column - 1, row), (column, row + 1), (column, row - 1)):
            if step in free and step not in found:
                found.add(step)
                edge.append(step)
    return found
