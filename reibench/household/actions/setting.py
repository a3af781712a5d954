"""Setting up: states, poses, the controller itself, and doing nothing."""

from typing import Any

from reibench.household.actions import Refused, action, interactable, vector
from reibench.household.geometry import bottom, footprint, volume
from reibench.household.placement import surface
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
    """Put things where they are said to be, by `objectName`; things not named stay.

    What they end up in or on is the smallest receptacle at that place.
    """
    by_name = {thing.name: thing for thing in state.objects.values()}
    for pose in objectPoses:
        thing = by_name.get(pose.get("objectName", ""))
        if thing is None:
            raise Refused(f"No object of name {pose.get('objectName', '')} found.")
        if not (thing.pickupable or thing.moveable):
            raise Refused(f"{thing.name} can neither be picked up nor moved.")
        _put_at(state, thing, Vector(*vector(pose.get("position"))))
        if (turn := (pose.get("rotation") or {}).get("y")) is not None:
            state.change(thing.id, yaw=float(turn))


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
    if not (thing.pickupable or thing.moveable):
        raise Refused(f"{thing.name} can neither be picked up nor moved.")
    _put_at(state, thing, Vector(*vector(position)))
    if rotation is not None:
        state.change(thing.id, yaw=float(rotation.get("y", thing.yaw)))


def _put_at(state: State, thing: SceneObject, position: Vector) -> None:
    old, middle = thing.position, thing.box.center
    offset = (new - before for new, before in zip(position, old, strict=True))
    there = Vector(*(a + b for a, b in zip(middle, offset, strict=True)))
    state.put(thing.id, there)
    receptacle = _receptacle_at(state, state.objects[thing.id])
    state.put(thing.id, there, receptacle=receptacle)
    state.change(thing.id, position=position)


def _receptacle_at(state: State, thing: SceneObject) -> str:
    """Return the id of the smallest receptacle a thing at its place is in or on."""
    x, y, z = thing.box.center
    low = bottom(thing.box)
    own = {thing.id, *(inner.id for inner in state.inside(thing.id))}
    found = []
    for other in state.objects.values():
        if not other.receptacle or other.id in own or other.id == state.held:
            continue
        if not footprint(other.box).covers(x, z):
            continue
        within = abs(y - other.box.center.y) <= other.box.size.y / 2 + 0.05
        if within or abs(low - surface(other)) < 0.1:
            found.append((volume(other.box), other.id))
    return min(found)[1] if found else ""
