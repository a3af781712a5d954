"""Setting up a task's room through AI2-THOR actions, the same for both simulators."""

import random

from reibench.episode import SceneSetup
from reibench.errors import InvalidEpisode
from reibench.scene import CONTAINERS, Scene
from reibench.worlds.simulator import Simulator


def prepare(simulator: Simulator, setup: SceneSetup) -> None:
    """Load the room, move and dirty what the setup says, and stand the robot at its start.

    Raises:
        InvalidEpisode: when the room lacks an object, or it does not fit where it should go.
    """
    simulator.load(setup.room)
    scene = simulator.scene()
    for placement in setup.placements:
        _require(scene, setup.room, placement.object_id, placement.receptacle_id)
        _place(simulator, scene, placement.object_id, placement.receptacle_id)
    for object_id in setup.dirty:
        _require(scene, setup.room, object_id)
        _must(simulator, "DirtyObject", objectId=object_id, forceAction=True)
    _stand(simulator, setup.seed)


def _require(scene: Scene, room: str, *object_ids: str) -> None:
    for object_id in object_ids:
        if object_id not in scene.by_id:
            kind = object_id.split("|", maxsplit=1)[0]
            there = ", ".join(thing.id for thing in scene.of_type(kind)) or f"no {kind}"
            raise InvalidEpisode(f"The room {room} has no object {object_id!r}; it has {there}.")


def _place(simulator: Simulator, scene: Scene, object_id: str, receptacle_id: str) -> None:
    receptacle = scene.by_id[receptacle_id]
    opens = receptacle.type in CONTAINERS and receptacle.openable and not receptacle.open
    _must(simulator, "PickupObject", objectId=object_id, forceAction=True)
    if opens:
        _must(simulator, "OpenObject", objectId=receptacle_id, forceAction=True)
    _must(simulator, "PutObject", objectId=receptacle_id, forceAction=True, placeStationary=True)
    if opens:
        _must(simulator, "CloseObject", objectId=receptacle_id, forceAction=True)


def _must(simulator: Simulator, action: str, **arguments: object) -> None:
    outcome = simulator.act(action, **arguments)
    if not outcome.success:
        target = arguments.get("objectId")
        raise InvalidEpisode(f"{action} of {target} failed while setting up: {outcome.message}.")


def _stand(simulator: Simulator, seed: int) -> None:
    """Start somewhere free, so that no start is nearer to the solution by design."""
    choose = random.Random(seed)
    place = choose.choice(simulator.reachable())
    _must(
        simulator,
        "Teleport",
        position={"x": place.x, "y": place.y, "z": place.z},
        rotation={"x": 0.0, "y": choose.choice((0.0, 90.0, 180.0, 270.0)), "z": 0.0},
        horizon=30.0,
        standing=True,
    )
