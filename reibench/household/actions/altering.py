"""Slicing, breaking, cleaning and soiling."""

from dataclasses import replace

from reibench.household.actions import Refused, action, interactable
from reibench.household.entries import name_of
from reibench.household.objects import SLICES, object_type
from reibench.household.state import State
from reibench.scene import Box, SceneObject, Vector


@action("SliceObject")
def slice_object(state: State, objectId: str, forceAction: bool = False) -> None:
    """Cut something up; no knife is needed, as in AI2-THOR. An egg is cracked."""
    thing = interactable(state, objectId, force=forceAction)
    if not thing.sliceable:
        raise Refused(f"{thing.name} Does not have the CanBeSliced property!")
    if thing.id == state.held:
        raise Refused("target object cannot be sliced if it is in the agent's hand")
    _cut_up(state, thing)


@action("BreakObject")
def break_object(state: State, objectId: str, forceAction: bool = False) -> None:
    """Break something; what it holds stays. An egg is cracked."""
    thing = interactable(state, objectId, force=forceAction)
    if not thing.breakable:
        raise Refused(f"{thing.name} Does not have the CanBreak property!")
    if thing.broken:
        raise Refused("object is already broken!")
    if thing.type == "Egg" and thing.id != state.held:
        _cut_up(state, thing)
    else:
        state.change(thing.id, broken=True, filled=False, liquid="", on=False)


@action("CleanObject")
def clean_object(state: State, objectId: str, forceAction: bool = False) -> None:
    """Clean something dirty."""
    _soil(state, interactable(state, objectId, force=forceAction), dirty=False)


@action("DirtyObject")
def dirty_object(state: State, objectId: str, forceAction: bool = False) -> None:
    """Make something dirty."""
    _soil(state, interactable(state, objectId, force=forceAction), dirty=True)


def _soil(state: State, thing: SceneObject, *, dirty: bool) -> None:
    if not thing.dirtyable:
        raise Refused(f"{thing.id} does not have dirtyable property!")
    if thing.dirty == dirty:
        raise Refused(f"object is already {'dirty' if dirty else 'clean'}")
    state.change(thing.id, dirty=dirty)


def _cut_up(state: State, whole: SceneObject) -> None:
    """Replace a thing by its pieces, side by side where it lay, as warm and cooked as it was."""
    name = "EggCracked" if whole.type == "Egg" else f"{whole.type}Sliced"
    warm = state.warmth.get(whole.id)
    state.remove(whole.id)
    count = SLICES.get(whole.type, 1)
    for number in range(count):
        piece = _piece(whole, name, number, count)
        state.add(piece)
        if warm is not None:
            state.warmth[piece.id] = warm


def _piece(whole: SceneObject, name: str, number: int, count: int) -> SceneObject:
    kind, ident = object_type(name), f"{whole.id}|{name}_{number}"
    (x, y, z), (width, height, depth) = whole.box
    middle = Vector(x + width * ((number + 0.5) / count - 0.5), y, z)
    size = kind.size if count == 1 else Vector(width / count, height * 0.9, depth * 0.9)
    return replace(
        whole,
        id=ident,
        type=name,
        name=name_of(ident),
        position=middle,
        box=Box(middle, size),
        sliceable=False,
        breakable=False,
        cookable="cookable" in kind.traits,
    )
