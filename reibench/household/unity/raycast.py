"""Ray casting: a picture of boxes in a room, every pixel's nearest surface found with NumPy."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, radians, sin, tan
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from reibench.scene import Vector

Floats = NDArray[np.float32]
Surfaces = NDArray[np.int16]
SIDES = 6
"""Shades of each colour: surfaces across x, seen from above, across z, from below; insides."""
SHADES = np.array([0.80, 1.0, 0.66, 0.45, 0.5, 0.55], np.float32)
FROM_BELOW, INSIDE, INSIDE_FLOOR = 3, 4, 5
ROOM, BLOCKS = SIDES, 2 * SIDES
"""Surfaces are numbered: the sky's, the room's, then each block's."""
FLOOR, ODD_TILE = ROOM + 1, ROOM + 4
TILES = (160, 138, 114), (150, 128, 105)
TILE = 0.5
"""Metres along a tile of the floor."""
EDGE = 0.62
"""How much darker the edges of surfaces are."""


class View(NamedTuple):
    """A camera."""

    position: Vector
    yaw: float
    """Degrees clockwise from +z."""
    pitch: float
    """Degrees down from the horizon."""
    field_of_view: float
    """Degrees from top to bottom."""
    orthographic: float | None
    """Half the height of what it takes in, in metres; None for a perspective camera."""
    width: int
    height: int
    near: float = 0.1
    far: float = 20.0
    sky: tuple[int, int, int] = (150, 190, 220)


class Block(NamedTuple):
    """A box to be drawn."""

    low: tuple[float, float, float]
    high: tuple[float, float, float]
    color: tuple[int, int, int]
    opening: tuple[int, int] | None = None
    """The side that is open, so that one looks inside: its axis, and 1 or -1 along it."""


@dataclass(frozen=True)
class Rays:
    """A ray for each pixel, bottom row first, by axis; lengths count along the line of sight."""

    origin: tuple[Any, Any, Any]
    inverse: tuple[Any, Any, Any]
    """One over the direction."""
    axes: Floats
    """Right, up and forward of the camera, in rows."""

    def at(self, rows: slice, columns: slice) -> "Rays":
        """Return those of a part of the picture."""
        parts = [
            tuple(one[rows, columns] if np.ndim(one) else one for one in three)
            for three in (self.origin, self.inverse)
        ]
        return Rays(parts[0], parts[1], self.axes)


def cast(view: View, room: Block, blocks: Sequence[Block]) -> NDArray[np.uint8]:
    """Return what `view` sees, as height x width x 3 bytes, bottom row first.

    Of the room only the surfaces that face inwards are seen, so one can look in from outside.
    """
    rays = _rays(view)
    depth, surface = _room(view, rays, room)
    if blocks:
        for number, rows, columns in _windows(view, rays, blocks):
            _draw(
                rays.at(rows, columns),
                blocks[number],
                SIDES * number + BLOCKS,
                (depth[rows, columns], surface[rows, columns]),
                view,
            )
    # Seen from below, an underside; of the room it is the ceiling.
    looking_up = np.broadcast_to(rays.inverse[1] > 0, surface.shape)
    surface += ((surface % SIDES == 1) & looking_up) * np.int16(FROM_BELOW - 1)
    edges = surface[1:, 1:] != surface[:-1, 1:]
    edges |= surface[1:, 1:] != surface[1:, :-1]
    _tile(surface, rays, depth)
    table = _colors(view, room, blocks)
    surface[1:, 1:] += edges * np.int16(len(table) // 2)
    return table.take(surface).view(np.uint8).reshape(*surface.shape, 4)[:, :, :3]


def _rays(view: View) -> Rays:
    yaw, pitch = radians(view.yaw), radians(view.pitch)
    right = (cos(yaw), 0.0, -sin(yaw))
    up = (sin(yaw) * sin(pitch), cos(pitch), cos(yaw) * sin(pitch))
    ahead = (sin(yaw) * cos(pitch), -sin(pitch), cos(yaw) * cos(pitch))
    half = view.orthographic or tan(radians(view.field_of_view / 2))
    v = (np.arange(view.height, dtype=np.float32) + 0.5) / view.height * 2 - 1
    u = (np.arange(view.width, dtype=np.float32) + 0.5) / view.width * 2 - 1
    v, u = v[:, None] * np.float32(half), u * np.float32(half * view.width / view.height)
    spread = [u * np.float32(r) + v * np.float32(p) for r, p in zip(right, up, strict=True)]
    axes = np.array((right, up, ahead), np.float32)
    if view.orthographic:
        origin = tuple(place + off for place, off in zip(view.position, spread, strict=True))
        inverse = tuple(np.float32(1 / _not_zero(one)) for one in ahead)
        return Rays(origin, inverse, axes)  # type: ignore[arg-type]
    inverses = []
    for off, one in zip(spread, ahead, strict=True):
        direction = off + np.float32(one)
        direction[np.abs(direction) < 1e-6] = 1e-6
        inverses.append(1 / direction)
    return Rays(tuple(view.position), tuple(inverses), axes)  # type: ignore[arg-type]


def _not_zero(value: float) -> float:
    return value if abs(value) > 1e-6 else 1e-6


def _crossings(rays: Rays, block: Block) -> tuple[list[Floats], list[Floats]]:
    """Return, by axis, where rays enter and leave the space between a box's two sides."""
    enters, leaves = [], []
    for axis in range(3):
        one = (block.low[axis] - rays.origin[axis]) * rays.inverse[axis]
        other = (block.high[axis] - rays.origin[axis]) * rays.inverse[axis]
        enters.append(np.minimum(one, other))
        leaves.append(np.maximum(one, other))
    return enters, leaves


def _room(view: View, rays: Rays, room: Block) -> tuple[Floats, Surfaces]:
    """Return each pixel's distance to the room's far side, and which surface that is."""
    shape = (view.height, view.width)
    enters, leaves = _crossings(rays, room)
    enter = np.maximum(np.maximum(enters[0], enters[1]), enters[2])
    leave = np.minimum(np.minimum(leaves[0], leaves[1]), leaves[2])
    axis = (leave == leaves[1]) + np.int16(2) * (leave == leaves[2])
    seen = np.broadcast_to((enter < leave) & (leave > view.near) & (leave < view.far), shape)
    depth = np.where(seen, leave, np.float32(view.far))
    surface = np.where(seen, ROOM + np.minimum(axis, 2), 0).astype(np.int16)
    return np.ascontiguousarray(depth, np.float32), surface


def _windows(view: View, rays: Rays, blocks: Sequence[Block]) -> list[tuple[int, slice, slice]]:
    """Return the part of the picture each block can appear in, blocks out of view left out."""
    ends = np.array([(block.low, block.high) for block in blocks], np.float32)
    picks = np.array([[i >> 2 & 1, i >> 1 & 1, i & 1] for i in range(8)])
    corners = ends[:, picks, np.arange(3)] - np.array(view.position, np.float32)
    x, y, z = np.moveaxis(corners @ rays.axes.T, -1, 0)
    behind = z < view.near
    if view.orthographic:
        half, scale = view.orthographic, np.ones_like(z)
    else:
        half, scale = tan(radians(view.field_of_view / 2)), 1 / np.maximum(z, view.near)
    column = ((x * scale) / (half * view.width / view.height) + 1) / 2 * view.width
    row = ((y * scale) / half + 1) / 2 * view.height
    # A box that reaches behind the camera can appear anywhere.
    partly = behind.any(1) & (view.orthographic is None)
    left = np.where(partly, 0, np.floor(column.min(1))).clip(0, view.width).astype(int)
    right = np.where(partly, view.width, np.ceil(column.max(1))).clip(0, view.width).astype(int)
    low = np.where(partly, 0, np.floor(row.min(1))).clip(0, view.height).astype(int)
    high = np.where(partly, view.height, np.ceil(row.max(1))).clip(0, view.height).astype(int)
    shown = (left < right) & (low < high) & ~behind.all(1) & (z.min(1) < view.far)
    return [
        (int(i), slice(int(low[i]), int(high[i])), slice(int(left[i]), int(right[i])))
        for i in np.flatnonzero(shown)
    ]


def _draw(
    rays: Rays,
    block: Block,
    number: int,
    picture: tuple[Floats, Surfaces],
    view: View,
) -> None:
    """Put a block into the picture where it is the nearest so far."""
    depth, surface = picture
    enters, leaves = _crossings(rays, block)
    enter = np.maximum(np.maximum(enters[0], enters[1]), enters[2])
    leave = np.minimum(np.minimum(leaves[0], leaves[1]), leaves[2])
    hit = enter <= leave
    hit &= enter > view.near
    axis = np.int16(2) * (enter == enters[2])
    axis += enter == enters[1]
    if block.opening is not None:
        across, sign = block.opening
        through = (axis == across) & (rays.inverse[across] * sign < 0)
        floor = (leave == leaves[1]) & (rays.inverse[1] < 0)
        inside = np.where(floor, np.int16(INSIDE_FLOOR), np.int16(INSIDE))
        axis = np.where(through, inside, axis)
        enter = np.where(through, leave, enter)
    hit &= enter < depth
    np.copyto(depth, enter, where=hit)
    axis += np.int16(number)
    np.copyto(surface, axis, where=hit)


def _colors(view: View, room: Block, blocks: Sequence[Block]) -> NDArray[np.uint32]:
    """Return the colours of all surfaces by their number, then again those of their edges."""
    base = np.array([view.sky, room.color, *(block.color for block in blocks)], np.float32)
    table = base[:, None, :] * SHADES[None, :, None]
    table[0] = view.sky
    table[1] = np.array(room.color) * np.array([[0.93], [0], [0.87], [1], [0], [0]])
    table[1, [FLOOR - ROOM, ODD_TILE - ROOM]] = TILES
    flat = table.reshape(-1, 3)
    both = np.concatenate((flat, flat * EDGE)).clip(0, 255).astype(np.uint8)
    return np.pad(both, ((0, 0), (0, 1))).view(np.uint32)[:, 0]


def _tile(surface: Surfaces, rays: Rays, depth: Floats) -> None:
    """Lay tiles on the floor, by which one sees how far things are."""
    floor = surface == FLOOR
    length = depth[floor]
    x, z = (
        np.broadcast_to(rays.origin[axis], depth.shape)[floor]
        + length / np.broadcast_to(rays.inverse[axis], depth.shape)[floor]
        for axis in (0, 2)
    )
    odd = (np.floor(x / TILE) + np.floor(z / TILE)).astype(np.int16) & 1
    surface[floor] = FLOOR + odd * np.int16(ODD_TILE - FLOOR)
