"""The build: what stands where Unity would, a controller that answers the client's actions."""

from contextlib import suppress
from typing import TYPE_CHECKING, Any

from reibench.household.controller import Controller, Misuse
from reibench.household.rooms import Room
from reibench.household.unity.channel import Answer
from reibench.scene import Box, Pose, Vector

if TYPE_CHECKING:
    from reibench.household.unity.frames import Frames

NOWHERE = Vector(0.0, 0.0, 0.0)
LOBBY = Room("", "", Box(NOWHERE, NOWHERE), (), Pose(NOWHERE, 0.0))
"""Where the robot is before the client asks for a room."""


class Build:
    """One running build: a controller, and the number of the client's last request."""

    def __init__(self, screen: tuple[int, int]) -> None:
        width, height = screen
        self._controller = Controller(LOBBY, width=width, height=height)
        self._frames: Frames | None = None

    def hello(self) -> Answer:
        """Return what a build sends unasked when it is up."""
        return Answer(self._controller.last_event, 0)

    def answer(self, request: dict[str, Any]) -> Answer:
        """Carry out what the client asks for."""
        action = request.pop("action")
        number = request.pop("sequenceId")
        wants_frames = request.get("renderImage", True)
        with suppress(Misuse):  # The event it leaves says so, and the client raises it again.
            self._controller.step(action, **request)
        if not wants_frames or self._controller.room is LOBBY:
            return Answer(self._controller.last_event, number)
        event, frames = self._controller.last_event, self._drawing()
        robot, cameras = frames.of_robot(event.moment), frames.of_cameras(event.moment)
        return Answer(event, number, [robot], cameras)

    def _drawing(self) -> "Frames":
        if self._frames is None:
            # Loaded with the first frame wanted: whoever wants none need not wait for NumPy.
            from reibench.household.unity.frames import Frames

            self._frames = Frames()
        return self._frames
