"""Where to stand and how to look in order to see a thing."""

from math import atan2, degrees, hypot

from reibench.scene import Pose, SceneObject, Vector

CAMERA_HEIGHT = 1.58
"""Metres above the floor; AI2-THOR's standing agent."""

CLOSE_ENOUGH = 1.0
"""Metres: from here the robot need not move to something it sees (LoTA-Bench)."""
REACH = 1.5
"""Metres: AI2-THOR's visibility distance."""


def nearest_point(place: Vector, thing: SceneObject) -> tuple[float, float]:
    """Return the point (x, z) of the thing's footprint nearest to `place`."""
    center, size = thing.box
    x = min(max(place.x, center.x - size.x / 2), center.x + size.x / 2)
    z = min(max(place.z, center.z - size.z / 2), center.z + size.z / 2)
    return x, z


def distance(place: Vector, thing: SceneObject) -> float:
    """Return the horizontal distance in metres from `place` to the thing's footprint."""
    x, z = nearest_point(place, thing)
    return hypot(x - place.x, z - place.z)


def facing(place: Vector, thing: SceneObject) -> Pose:
    """Return the pose at `place` that looks at the nearest part of `thing`.

    Wide furniture is looked at where it is nearest: its centre may be out of reach.
    """
    x, z = nearest_point(place, thing)
    away = hypot(x - place.x, z - place.z)
    if away < 0.05:
        x, z = thing.box.center.x, thing.box.center.z
        away = hypot(x - place.x, z - place.z)
    yaw = degrees(atan2(x - place.x, z - place.z)) % 360
    down = degrees(atan2(CAMERA_HEIGHT - thing.box.center.y, max(away, 0.1)))
    return Pose(place, round(yaw, 1), float(round(min(max(down, -30.0), 60.0))))
