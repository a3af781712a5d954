"""Opening, closing, switching on and off."""

from reibench.household.actions import Refused, action, interactable
from reibench.household.state import State
from reibench.scene import SceneObject


@action("OpenObject")
def open_object(
    state: State, objectId: str, forceAction: bool = False, openness: float = 1.0
) -> None:
    """Open something, wholly or by a part of 1."""
    thing = interactable(state, objectId, force=forceAction)
    if not thing.openable:
        raise Refused(f"{thing.id} is not an Openable object")
    if not 0 < openness <= 1:
        raise Refused("openness must be in [0.0:1.0]", "InvalidArgument")
    if thing.on and thing.type == "Microwave":
        raise Refused("Target must be OFF to open!")
    if thing.open and state.openness.get(thing.id, 1.0) == openness:
        raise Refused(f"{thing.id} is already open")
    state.set_open(thing.id, openness)


@action("CloseObject")
def close_object(state: State, objectId: str, forceAction: bool = False) -> None:
    """Close something."""
    thing = interactable(state, objectId, force=forceAction)
    if not thing.openable:
        raise Refused(f"{thing.id} is not an Openable object")
    if not thing.open:
        raise Refused("object is already closed")
    state.set_open(thing.id, 0.0)


@action("ToggleObjectOn")
def toggle_object_on(state: State, objectId: str, forceAction: bool = False) -> None:
    """Switch something on."""
    _toggle(state, interactable(state, objectId, force=forceAction), on=True)


@action("ToggleObjectOff")
def toggle_object_off(state: State, objectId: str, forceAction: bool = False) -> None:
    """Switch something off."""
    _toggle(state, interactable(state, objectId, force=forceAction), on=False)


def _toggle(state: State, thing: SceneObject, *, on: bool) -> None:
    if not thing.toggleable:
        raise Refused(f"{thing.id} is not toggleable")
    if thing.broken and on:
        raise Refused("Target is broken and cannot be Toggled!")
    if thing.on == on:
        word = "on" if on else "off"
        raise Refused(f"can't toggle object {word} if it's already {word}!")
    if on and thing.open and thing.type == "Microwave":
        raise Refused("Target must be closed to Toggle On!")
    state.change(thing.id, on=on)
    for name in state.room.controls.get(thing.id, ()):
        state.change(name, on=on)
