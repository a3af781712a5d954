"""What the skill layer needs of an AI2-THOR controller, embedded or real."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from reibench.scene import Scene, Vector


@dataclass(frozen=True)
class Outcome:
    """How an AI2-THOR action went."""

    success: bool
    message: str = ""
    code: str = ""
    """AI2-THOR's errorCode, e.g. `ReceptacleFull`."""


class Simulator(Protocol):
    """An AI2-THOR controller, as far as skills need it."""

    def load(self, room: str) -> None:
        """Set the room as it is at load time; raises UnknownName or InvalidRoom."""
        ...

    def act(self, action: str, **arguments: object) -> Outcome:
        """Carry out one AI2-THOR action."""
        ...

    def scene(self) -> Scene:
        """Report the room as it is now."""
        ...

    def metadata(self) -> Mapping[str, Any]:
        """Report the room as AI2-THOR's metadata, for dumps; skills read `scene`."""
        ...

    def sees(self, object_id: str) -> bool:
        """Whether the object is visible from where the robot stands and looks."""
        ...

    def reachable(self) -> Sequence[Vector]:
        """Return the free places of the floor grid."""
        ...

    def close(self) -> None:
        """Free the simulator."""
        ...
