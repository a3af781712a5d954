"""The embedded household simulator: AI2-THOR 5's actions and metadata without Unity.

    controller = Controller("kitchen-1")
    event = controller.step("PickupObject", objectId="Apple|+01.00|+00.95|-00.50")

Objects are boxes, seen and reached as the crow flies on the floor plan: nothing is rendered,
occluded or thrown about. What can be done, what is refused and what follows is AI2-THOR's.
"""

from typing import TYPE_CHECKING, Any

from reibench.household.controller import Controller, Event
from reibench.household.metadata import scene_from_metadata
from reibench.household.rooms import Room, load_room, room_names

if TYPE_CHECKING:
    from reibench.household.generate import generate_room

__all__ = [
    "Controller",
    "Event",
    "Room",
    "generate_room",
    "load_room",
    "room_names",
    "scene_from_metadata",
]


def __getattr__(name: str) -> Any:
    # Loaded when asked for: it is a program too, and few need it.
    if name == "generate_room":
        from reibench.household.generate import generate_room

        return generate_room
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
