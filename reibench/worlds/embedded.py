"""The embedded world: the skill layer over `reibench.household`, no download, display or GPU."""

from collections.abc import Mapping, Sequence
from typing import Any

from reibench.household import Controller, Room, load_room
from reibench.scene import Scene, Vector
from reibench.worlds import Announce, World, silently, worlds
from reibench.worlds.rules import STRICT, Rules
from reibench.worlds.simulator import Outcome
from reibench.worlds.thor import ThorWorld


class EmbeddedSimulator:
    """`household.Controller` as the skill layer wants it."""

    def __init__(self) -> None:
        self._controller: Controller | None = None

    def load(self, room: str) -> None:
        """Set the room as it is at load time."""
        if self._controller is None:
            self._controller = Controller(self.room_called(room))
        else:
            self._controller.reset(self.room_called(room))

    def room_called(self, name: str) -> Room:
        """Return the room of that name; raises UnknownName."""
        return load_room(name)

    @property
    def controller(self) -> Controller:
        """The controller, once a room is loaded."""
        if self._controller is None:
            raise RuntimeError("no room is loaded yet; call load first")
        return self._controller

    def act(self, action: str, **arguments: object) -> Outcome:
        """Carry out one AI2-THOR action."""
        event = self.controller.step(action, **arguments)
        return Outcome(event.success, event.message, event.code)

    def scene(self) -> Scene:
        """Report the room as it is now."""
        return self.controller.snapshot()

    def metadata(self) -> Mapping[str, Any]:
        """Report the room as AI2-THOR's metadata."""
        return self.controller.last_event.metadata

    def sees(self, object_id: str) -> bool:
        """Whether the object is visible now."""
        return self.controller.sees(object_id)

    def reachable(self) -> Sequence[Vector]:
        """Return the free places of the floor grid."""
        return self.controller.reachable()

    def close(self) -> None:
        """Forget the room."""
        self._controller = None


@worlds.register("embedded")
def embedded_world(
    rules: Rules = STRICT,
    *,
    variant: str = "",
    frames: bool = False,
    announce: Announce = silently,
) -> World:
    """Make a household world in this process; it renders nothing."""
    return ThorWorld(EmbeddedSimulator(), rules)
