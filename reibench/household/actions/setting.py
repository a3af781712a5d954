"""Setting up: states, poses, the controller itself, and doing nothing."""

from dataclasses import replace
from math import dist
from typing import Any

from reibench.household.actions import Refused, action, interactable, vector
from reibench.household.resting import AT_REST, gap, posed, resting_place
from reibench.household.state import Settings, State
from reibench.scene import SceneObject, Vector

PROPERTIES = {
    "openable": ("openable", "open", "isOpen"),
    "toggleable": ("toggleable", "on", "isToggled"),
    "breakable": ("breakable", "broken", "isBroken"),
    "canFillWithLiquid": ("fillable", "filled", "isFilledWithLiquid"),
    "dirtyable": ("dirtyable", "dirty", "isDirty"),
    "cookable": ("cookable", "cooked", "isCooked"),
}
"""AI2-THOR's `stateChange`, with the trait it asks for, the state, and the argument's name."""
UNMOVED = 1e-3
"""Metres within which a pose leaves furniture, and all that is on it, as it is."""


@action("Pass", "Done")
def wait(state: State) -> None:
    """Let one action's time go by."""


@action("Initialize", changes=False)
def initialize(state: State, **options: Any) -> dict[str, float]:
    """Take settings; what has no meaning without a camera or physics is let pass."""
    before = state.settings
    grid = _number(options, "gridSize", before.grid)
    if not 0 < grid <= 5:
        raise Refused("grid size must be in the range (0,5]")
    field_of_view = _number(options, "fieldOfView", before.field_of_view)
    if not 0 < field_of_view < 180:
        raise Refused("fov must be set to (0, 180) noninclusive.")
    reach = _number(options, "visibilityDistance", before.reach)
    state.configure(Settings(grid, reach, field_of_view, before.screen))
    return {"cameraNearPlane": 0.1, "cameraFarPlane": 20.0}


def _number(options: dict[str, Any], name: str, otherwise: float) -> float:
    value = options.get(name)
    if value is None:
        return otherwise
    try:
        return float(value)
    except (TypeError, ValueError):
        raise Refused(
            f"Initialize takes a number as {name}, not {value!r}.", "InvalidArgument"
        ) from None


@action("SetObjectStates")
def set_object_states(state: State, SetObjectStates: dict[str, Any]) -> None:
    """Give a state to every object that can have it, or to those of one `objectType`."""
    wanted = SetObjectStates
    change = wanted.get("stateChange") or next(
        (key for key, (_, _, argument) in PROPERTIES.items() if argument in wanted), ""
    )
    if change not in PROPERTIES:
        raise Refused(f"stateChange {change!r} is none of {', '.join(PROPERTIES)}.")
    trait, field, argument = PROPERTIES[change]
    if argument not in wanted:
        raise Refused(f"SetObjectStates with stateChange {change!r} needs {argument}.")
    value, only = bool(wanted[argument]), wanted.get("objectType")
    for thing in tuple(state.objects.values()):
        if not getattr(thing, trait) or (only and thing.type != only):
            continue
        if field == "open":
            state.set_open(thing.id, float(value))
        elif field == "filled":
            state.change(thing.id, filled=value, liquid=thing.liquid or "water" if value else "")
        else:
            state.change(thing.id, **{field: value})
        for name in state.room.controls.get(thing.id, ()) if field == "on" else ():
            state.change(name, on=value)


@action("SetObjectPoses")
def set_object_poses(
    state: State, objectPoses: list[dict[str, Any]], placeStationary: bool = True
) -> None:
    """Put things where they are said to be, by `objectName`.

    As in AI2-THOR 5 (SceneManager.cs) what can be picked up or moved and is not named is gone
    afterwards, and naming a thing again makes a copy of it.
    """
    by_name = {thing.name: thing for thing in state.objects.values()}
    for pose in objectPoses:
        name = pose.get("objectName", "")
        _require_movable(by_name.get(name), name)
    if not objectPoses:
        return
    named = {pose["objectName"] for pose in objectPoses}
    _take_away([thing for thing in by_name.values() if _movable(thing)], named, state)
    placed: set[str] = set()
    for number, pose in enumerate(objectPoses):
        thing = by_name[pose["objectName"]]
        if thing.name in placed:
            thing = _copy(state, thing, number)
        placed.add(thing.name)
        turn = (pose.get("rotation") or {}).get("y")
        _put_at(state, thing, Vector(*vector(pose.get("position"))), turn)


def _movable(thing: SceneObject) -> bool:
    return thing.pickupable or thing.moveable


def _require_movable(thing: SceneObject | None, name: str) -> None:
    if thing is None or not _movable(thing):
        raise Refused(f"No Pickupable or Moveable object of name {name} found in scene.")


def _take_away(things: list[SceneObject], named: set[str], state: State) -> None:
    """Take what can be picked up out of where it is, and what is not named away."""
    for thing in things:
        if thing.pickupable or thing.name not in named:
            state.put(thing.id, thing.box.center)
    for thing in things:
        if thing.name not in named:
            for inner in tuple(state.inside(thing.id)):
                state.put(inner.id, inner.box.center)
            state.remove(thing.id)


def _copy(state: State, thing: SceneObject, number: int) -> SceneObject:
    """Add a copy of a thing, empty and nowhere in particular, called as AI2-THOR calls it."""
    copy = replace(
        thing,
        id=f"{thing.id}_copy_{number}",
        name=f"{thing.name}_copy_{number}",
        parents=(),
        contents=None if thing.contents is None else (),
        held=False,
    )
    state.add(copy)
    return copy


@action("PlaceObjectAtPoint")
def place_object_at_point(
    state: State,
    objectId: str,
    position: dict[str, float],
    rotation: dict[str, float] | None = None,
    forceAction: bool = False,
    forceKinematic: bool = False,
) -> None:
    """Put a thing at a point, from wherever it is."""
    thing = interactable(state, objectId, force=True)
    if not _movable(thing):
        raise Refused(f"{thing.name} can neither be picked up nor moved.")
    turn = None if rotation is None else rotation.get("y", thing.yaw)
    _put_at(state, thing, Vector(*vector(position)), turn)


def _put_at(state: State, thing: SceneObject, position: Vector, turn: float | None) -> None:
    """Move a thing to a position, turn it, and let it be in or on what is there."""
    unmoved = dist(position, thing.position) < UNMOVED and (turn is None or turn == thing.yaw)
    if unmoved and not thing.pickupable and state.held != thing.id:
        return
    there = posed(thing, position, thing.yaw if turn is None else float(turn))
    state.put(thing.id, there.box.center, there.box.size)
    state.change(thing.id, position=position, yaw=there.yaw)
    receptacle = _receptacle_at(state, state.objects[thing.id])
    state.put(thing.id, there.box.center, receptacle=receptacle)


def _receptacle_at(state: State, thing: SceneObject) -> str:
    """Return the id of the receptacle a thing at its place is in or on."""
    own = {thing.id, state.held, *(inner.id for inner in state.inside(thing.id))}
    others = (o for o in state.objects.values() if o.receptacle and o.id not in own)
    rest = resting_place(thing, (other for other in others if gap(thing, other) <= AT_REST))
    return rest.receptacle.id if rest else ""
