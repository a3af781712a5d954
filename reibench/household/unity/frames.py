"""Frames: the pictures a build sends, of the robot's eye and of third-party cameras."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from reibench.household.cameras import Camera
from reibench.household.metadata import camera_position
from reibench.household.state import Moment, Objects
from reibench.household.unity.palette import parse_color
from reibench.household.unity.raycast import View, cast
from reibench.household.unity.scenery import blocks, room_block
from reibench.scene import Pose

LABEL = (
    "#### ##### #### #   # ####      ##### #   #",
    "#      #   #  # ##  # #   #       #   ##  #",
    "####   #   #### # # # #   # ###   #   # # #",
    "   #   #   #  # #  ## #   #       #   #  ##",
    "####   #   #  # #   # ####      ##### #   #",
)
"""`STAND-IN`, written into every picture, so that none is taken for Unity's."""


@dataclass
class Frames:
    """Draws frames, and keeps each camera's last one while nothing it shows changes."""

    _drawn: dict[int, tuple[View, Objects, Pose, bytes]] = field(default_factory=dict)

    def of_robot(self, moment: Moment) -> bytes:
        """Return what the robot sees, as RGB bytes, bottom row first."""
        width, height = moment.settings.screen
        pose, fov = moment.agent, moment.settings.field_of_view
        view = View(camera_position(pose), pose.yaw, pose.horizon, fov, None, width, height)
        return self._frame(-1, view, moment)

    def of_cameras(self, moment: Moment) -> list[bytes]:
        """Return what each third-party camera sees."""
        screen = moment.settings.screen
        return [
            self._frame(number, _view(camera, screen), moment)
            for number, camera in enumerate(moment.cameras)
        ]

    def _frame(self, number: int, view: View, moment: Moment) -> bytes:
        known = self._drawn.get(number)
        # Objects are replaced, never changed, so the same ones look the same.
        if known and known[0] == view and known[1] is moment.objects and known[2] == moment.agent:
            return known[3]
        shown = blocks(moment, robot=number >= 0)
        image = cast(view, room_block(moment.room.bounds), shown)
        _write_label(image)
        frame = image.tobytes()
        self._drawn[number] = view, moment.objects, moment.agent, frame
        return frame


def _view(camera: Camera, screen: tuple[int, int]) -> View:
    return View(
        camera.position,
        camera.rotation.y,
        camera.rotation.x,
        camera.field_of_view,
        camera.orthographic_size if camera.orthographic else None,
        *screen,
        camera.near,
        camera.far,
        parse_color(camera.skybox),
    )


def _write_label(image: NDArray[np.uint8]) -> None:
    """Write what made it into the lower left corner, if it is large enough."""
    letters = np.array([[mark == "#" for mark in row] for row in reversed(LABEL)])
    height, width = letters.shape
    if image.shape[0] < height + 6 or image.shape[1] < width + 6:
        return
    corner = image[2 : height + 6, 2 : width + 6]
    corner[:] = corner // 3
    corner[2:-2, 2:-2][letters] = 255
