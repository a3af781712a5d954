"""Geometry on the floor plan: footprints of boxes, reach and view."""

from math import cos, radians, sin
from typing import NamedTuple

from reibench.scene import Box, Vector


class Footprint(NamedTuple):
    """A box seen from above, with its centre."""

    left: float
    right: float
    near: float
    far: float
    x: float
    z: float

    def grown(self, margin: float) -> "Footprint":
        """Return it with `margin` metres added on every side."""
        left, right, near, far, x, z = self
        return Footprint(left - margin, right + margin, near - margin, far + margin, x, z)

    def covers(self, x: float, z: float) -> bool:
        """Whether the point lies on it."""
        return self.left <= x <= self.right and self.near <= z <= self.far

    def meets(self, other: "Footprint", slack: float = 0.0) -> bool:
        """Whether the two overlap by more than `slack` metres."""
        return (
            self.left + slack < other.right
            and other.left + slack < self.right
            and self.near + slack < other.far
            and other.near + slack < self.far
        )

    def distance(self, x: float, z: float) -> float:
        """Return how far the point is from its nearest edge, 0 inside."""
        dx = max(self.left - x, 0.0, x - self.right)
        dz = max(self.near - z, 0.0, z - self.far)
        return float((dx * dx + dz * dz) ** 0.5)


def footprint(box: Box) -> Footprint:
    """Return `box` seen from above."""
    (x, _, z), (width, _, depth) = box
    return Footprint(x - width / 2, x + width / 2, z - depth / 2, z + depth / 2, x, z)


def bottom(box: Box) -> float:
    """Return the height of the box's lower side."""
    return box.center.y - box.size.y / 2


def top(box: Box) -> float:
    """Return the height of the box's upper side."""
    return box.center.y + box.size.y / 2


def volume(box: Box) -> float:
    """Return the box's volume in cubic metres."""
    width, height, depth = box.size
    return width * height * depth


def shifted(box: Box, dx: float, dy: float, dz: float) -> Box:
    """Return `box` moved."""
    (x, y, z), size = box
    return Box(Vector(x + dx, y + dy, z + dz), size)


def forward(yaw: float) -> tuple[float, float]:
    """Return the unit step (x, z) of something facing `yaw` degrees."""
    angle = radians(yaw)
    return sin(angle), cos(angle)


class Sight(NamedTuple):
    """Where a camera is on the floor plan and what it takes in."""

    x: float
    z: float
    ahead_x: float
    ahead_z: float
    reach: float
    """Metres, measured horizontally."""
    cosine: float
    """Cosine of half the field of view."""

    @classmethod
    def of(cls, position: Vector, yaw: float, reach: float, field_of_view: float) -> "Sight":
        """Return what a camera at `position` sees that faces `yaw` degrees."""
        ahead = forward(yaw)
        return cls(position.x, position.z, *ahead, reach, cos(radians(field_of_view / 2)))

    def takes_in(self, area: Footprint) -> bool:
        """Whether the nearest point of `area` is in reach and it, or the centre, in view."""
        x, z, ahead_x, ahead_z, reach, cosine = self
        left, right, near, far, middle_x, middle_z = area
        dx = left - x if x < left else right - x if x > right else 0.0
        dz = near - z if z < near else far - z if z > far else 0.0
        squared = dx * dx + dz * dz
        if squared > reach * reach:
            return False
        if squared < 1e-6:
            return True
        # A ten-thousandth of slack keeps a point on the very edge of the view in it.
        limit = cosine - 1e-4
        if dx * ahead_x + dz * ahead_z >= limit * squared**0.5:
            return True
        dx, dz = middle_x - x, middle_z - z
        return bool(dx * ahead_x + dz * ahead_z >= limit * (dx * dx + dz * dz) ** 0.5)
