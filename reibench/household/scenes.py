"""Scene names: AI2-THOR's builds call the room FloorPlan1 `FloorPlan1_physics`."""

import re

from reibench.household.rooms import room_names

SUFFIX = "_physics"
_NUMBERED = re.compile(r"FloorPlan\d+")


def scene_name(room: str) -> str:
    """Return what a build calls that room."""
    return room + SUFFIX if _NUMBERED.fullmatch(room) else room


def room_name(scene: str) -> str:
    """Return the room a build means by `scene`."""
    room = scene.removesuffix(SUFFIX)
    return room if _NUMBERED.fullmatch(room) else scene


def scene_names() -> tuple[str, ...]:
    """Return what a build calls the rooms at hand."""
    return tuple(scene_name(room) for room in room_names())
