"""Picking up, putting and dropping."""

from dataclasses import replace

from reibench.household.actions import Refused, action, interactable
from reibench.household.geometry import Footprint, forward
from reibench.household.objects import object_type
from reibench.household.placement import Spot, free_spot
from reibench.household.state import State
from reibench.scene import CONTAINERS, Box, SceneObject, Vector

DROP_REACH = 0.6
"""How far from the robot's feet a dropped thing may land, in metres."""


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
    here = state.agent.position
    spot = free_spot(state.objects, _as_lying(state, thing), receptacle, (here.x, here.z))
    if spot is None:
        raise Refused("No valid points to place object found", "ReceptacleFull")
    settle_down(state, receptacle.id, spot)


@action("DropHandObject")
def drop_hand_object(state: State, forceAction: bool = False, autoSimulation: bool = True) -> None:
    """Let go of what the hand holds: it lands on the floor nearby, and does not break."""
    if not state.held:
        raise Refused("Nothing is in the agent's hand to drop!", "ObjectNotInInventory")
    thing = state.objects[state.held]
    (x, _, z), yaw = state.agent.position, state.agent.yaw
    ahead_x, ahead_z = forward(yaw)
    for floor in state.of_type("Floor"):
        reach = DROP_REACH
        area = Footprint(x - reach, x + reach, z - reach, z + reach, x, z)
        spot = free_spot(state.objects, _as_lying(state, thing), floor, (x, z), area)
        # Where nothing is free around the feet it lands on top of whatever is there.
        middle = Vector(x + 0.3 * ahead_x, thing.box.size.y / 2, z + 0.3 * ahead_z)
        settle_down(state, floor.id, spot or Spot(middle, thing.box.size))
        return
    raise Refused("There is no floor to drop it on.")


def settle_down(state: State, receptacle: str, spot: Spot) -> None:
    """Put what the hand holds at `spot`, in or on `receptacle`."""
    name = state.release()
    state.move(name, spot.middle, spot.size)
    state.attach(name, receptacle)


def _as_lying(state: State, thing: SceneObject) -> SceneObject:
    """Return a held thing with the extent it had at first: in a mug a pen stands upright."""
    size = state.room.by_id.get(thing.id, thing).box.size
    return thing if thing.box.size == size else replace(thing, box=Box(thing.box.center, size))


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
    return receptacle.openable and not receptacle.open and receptacle.type in CONTAINERS
