"""The walkable floor: where in a room the robot can stand."""

from collections.abc import Callable, Iterable, Sequence
from functools import partial
from math import ceil, dist, floor, hypot
from typing import NamedTuple

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


LOWEST = 0.15
"""What is lower than this the robot passes over."""

CLOSE = 0.01
"""Metres within which two points are the same."""


class Solid(NamedTuple):
    """Where something keeps the robot from standing."""

    extent: Footprint
    """The area outside of which it never does."""
    shape: Callable[[float, float], bool] | None = None
    """Says where within; everywhere if there is none."""

    def covers(self, x: float, z: float) -> bool:
        """Whether the robot cannot stand at that point."""
        return self.extent.covers(x, z) and (self.shape is None or self.shape(x, z))


class WalkableFloor:
    """The part of a room's floor the robot can reach from where it starts."""

    def __init__(
        self,
        bounds: Box,
        objects: Iterable[SceneObject],
        start: Vector | None,
        grid: float = GRID,
        *,
        solids: Iterable[tuple[str, Solid]] | None = None,
    ) -> None:
        """Find where to stand among `solids`, by default the boxes of `objects`."""
        self.obstacles = list(_boxes(objects) if solids is None else solids)
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
        for _, solid in self.obstacles:
            cells -= set(_covered(solid, grid))
        return cells


class SurveyedFloor(WalkableFloor):
    """A floor of which AI2-THOR itself said where the robot can stand."""

    def __init__(
        self, bounds: Box, solids: Iterable[tuple[str, Solid]], standing: Sequence[Vector]
    ) -> None:
        super().__init__(bounds, (), None, solids=solids)
        self._known = {self._cell(point.x, point.z): point for point in standing}
        self._cells = frozenset(self._known)
        self.points = tuple(standing)

    def blocker(self, x: float, z: float) -> str:
        """Return the id of what keeps the robot from standing there, `wall`, or nothing."""
        if self._is_known(x, z):
            return ""
        return super().blocker(x, z) or ("" if self._cell(x, z) in self._known else "wall")

    def reaches(self, x: float, z: float) -> bool:
        """Whether it is one of the points said, or free and next to one."""
        return self._is_known(x, z) or super().reaches(x, z)

    def _is_known(self, x: float, z: float) -> bool:
        point = self._known.get(self._cell(x, z))
        return point is not None and hypot(point.x - x, point.z - z) < CLOSE


def blocks(thing: SceneObject) -> bool:
    """Whether the robot has to walk around it; small things it steps over."""
    if thing.pickupable or thing.type == "Floor":
        return False
    return bottom(thing.box) < HEADROOM and top(thing.box) > LOWEST


def _boxes(objects: Iterable[SceneObject]) -> Iterable[tuple[str, Solid]]:
    """Yield, by object id, the obstacles of a room where everything is as large as its box."""
    for thing in objects:
        if blocks(thing):
            yield thing.id, Solid(footprint(thing.box).grown(RADIUS))


def _covered(solid: Solid, grid: float) -> Iterable[tuple[int, int]]:
    area, shape = solid
    for column in range(ceil(area.left / grid), floor(area.right / grid) + 1):
        for row in range(ceil(area.near / grid), floor(area.far / grid) + 1):
            if shape is None or shape(column * grid, row * grid):
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
