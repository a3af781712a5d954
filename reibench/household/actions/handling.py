"""Picking up, putting and dropping."""

from dataclasses import replace

from reibench.household.actions import Refused, action, interactable
from reibench.household.geometry import Footprint
from reibench.household.objects import object_type
from reibench.household.placement import Rank, Spot, free_spot, nearest_to
from reibench.household.state import State
from reibench.scene import Box, SceneObject, Vector

OUT_OF_VIEW = 1e6
FEET = 0.3
"""How far before the robot things are dropped, in metres."""
AROUND = 0.5
"""How far from there a dropped thing may land."""


@action("PickupObject")
def pickup_object(
    state: State, objectId: str, forceAction: bool = False, manualInteract: bool = False
) -> None:
    """Take a thing into the hand, with all that is in or on it."""
    if state.held:
        raise Refused(
            "Agent hand has something in it already! Can't pick up anything else", "InventoryFull"
        )
    thing = interactable(state, objectId, force=forceAction)
    if not thing.pickupable:
        raise Refused(
            f"{thing.id} must have the property CanPickup to be picked up.", "ObjectNotPickupable"
        )
    state.take(thing.id)


@action("PutObject")
def put_object(
    state: State,
    objectId: str,
    forceAction: bool = False,
    placeStationary: bool = True,
    randomSeed: int = 0,
) -> None:
    """Put what the hand holds in or on a receptacle.

    `forceAction` lifts the need to see it and AI2-THOR's rules of what may go where; it opens
    nothing and makes no room.
    """
    if not state.held:
        raise Refused(
            "Can't place an object if Agent isn't holding anything", "ObjectNotInInventory"
        )
    thing = state.objects[state.held]
    receptacle = _receptacle(state, objectId, forceAction)
    if not forceAction and not _may_go(thing, receptacle):
        raise Refused(
            f"{thing.name} cannot be placed in {receptacle.name}", "ObjectNotAllowedInReceptacle"
        )
    if _shut(receptacle):
        raise Refused(
            "Target openable Receptacle is CLOSED, can't place if target is not open!",
            "ReceptacleNotOpen",
        )
    lying, holds = _as_lying(state, thing), state.room.surface(receptacle.id)
    spot = free_spot(state.objects, lying, receptacle, _before(state), holds=holds)
    if spot is None:
        raise Refused("No valid points to place object found", "ReceptacleFull")
    state.put(thing.id, *spot, receptacle=receptacle.id)


@action("DropHandObject")
def drop_hand_object(state: State, forceAction: bool = False, autoSimulation: bool = True) -> None:
    """Let go of what the hand holds: it lands on the floor nearby, and does not break."""
    if not state.held:
        raise Refused("Nothing is in the agent's hand to drop!", "ObjectNotInInventory")
    thing = state.objects[state.held]
    thing = _as_lying(state, thing)
    (x, _, z), sight = state.agent.position, state.sight
    x, z = x + FEET * sight.ahead_x, z + FEET * sight.ahead_z
    area = Footprint(x - AROUND, x + AROUND, z - AROUND, z + AROUND, x, z)
    for floor in state.of_type("Floor"):
        # Where nothing is free around the feet it lands on top of whatever is there.
        on_top = Spot(Vector(x, thing.box.size.y / 2, z), thing.box.size)
        spot = free_spot(state.objects, thing, floor, nearest_to(x, z), area) or on_top
        state.put(thing.id, *spot, receptacle=floor.id)
        return
    raise Refused("There is no floor to drop it on.")


def _as_lying(state: State, thing: SceneObject) -> SceneObject:
    """Return a held thing with the extent it had at first: in a mug a pen stands upright."""
    size = state.room.by_id.get(thing.id, thing).box.size
    return thing if thing.box.size == size else replace(thing, box=Box(thing.box.center, size))


def _before(state: State) -> Rank:
    """Rank places by how near they are to the robot, those in its view before all others."""
    here_x, here_z, ahead_x, ahead_z, _, cosine = state.sight

    def rank(x: float, z: float) -> float:
        dx, dz = x - here_x, z - here_z
        squared = dx * dx + dz * dz
        in_view = dx * ahead_x + dz * ahead_z >= cosine * squared**0.5
        return squared if in_view else squared + OUT_OF_VIEW

    return rank


def _receptacle(state: State, name: str, force: bool) -> SceneObject:
    """Return the receptacle meant; of a sink, its basin."""
    target = state.objects.get(name)
    if target is None or not (force or state.sees(name)):
        raise Refused("No valid Receptacle found", "ReceptacleNotVisible")
    basin = state.objects.get(f"{name}|{target.type}Basin")
    target = basin or target
    if not target.receptacle:
        raise Refused("This target object is NOT a receptacle!")
    inside = [state.held, *(thing.id for thing in state.inside(state.held))]
    if target.id in inside:
        raise Refused("No valid Receptacle found", "ReceptacleNotVisible")
    return target


def _may_go(thing: SceneObject, receptacle: SceneObject) -> bool:
    return object_type(thing.type).may_go(receptacle.type)


def _shut(receptacle: SceneObject) -> bool:
    return object_type(receptacle.type).encloses and not receptacle.open
