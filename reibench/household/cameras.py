"""Third-party cameras: where they hang, how they look, and what the metadata say of them."""

from dataclasses import dataclass
from typing import Any

from reibench.scene import Vector

FIELD_OF_VIEW = 90.0
"""Degrees, AI2-THOR's default."""


@dataclass(frozen=True)
class Camera:
    """A camera that is not the robot's."""

    position: Vector
    rotation: Vector
    """Degrees about x (down is positive), y (clockwise from +z) and z."""
    field_of_view: float = FIELD_OF_VIEW
    """Degrees, from top to bottom."""
    skybox: str = "default"
    """What is seen past the room: `default`, or an HTML colour."""
    orthographic: bool = False
    orthographic_size: float = 5.0
    """Half the height of what it takes in, in metres, if orthographic."""
    near: float = 0.1
    far: float = 20.0
    """Metres between which things are drawn."""


def camera_metadata(number: int, camera: Camera) -> dict[str, Any]:
    """Return what AI2-THOR reports of its camera of that number."""
    return {
        "thirdPartyCameraId": number,
        "position": camera.position._asdict(),
        "rotation": camera.rotation._asdict(),
        "fieldOfView": camera.field_of_view,
    }
