"""Setting up a task's room through AI2-THOR actions, the same for both simulators."""

import random
from math import dist

from reibench.episode import SceneSetup
from reibench.errors import InvalidEpisode
from reibench.scene import CONTAINERS, Pose, Scene, Vector
from reibench.worlds.restoring import action_poses, restored
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
    if setup.toggles or setup.dirty_and_empty or setup.poses:
        _restore(simulator, setup)
    if setup.start:
        _stand_near(simulator, setup.start)
    else:
        _stand(simulator, setup.seed)


def _restore(simulator: Simulator, setup: SceneSetup) -> None:
    """Do what ALFRED's `restore_scene` does, in its order."""
    for toggle in setup.toggles:
        _set_states(simulator, "toggleable", objectType=toggle.type, isToggled=toggle.on)
    if setup.dirty_and_empty:
        _set_states(simulator, "dirtyable", isDirty=True)
        _set_states(simulator, "canFillWithLiquid", isFilledWithLiquid=False)
    if setup.poses:
        scene = simulator.scene()
        poses = action_poses(scene, restored(scene, setup.poses))
        _must(simulator, "SetObjectPoses", objectPoses=poses, placeStationary=True)


def _set_states(simulator: Simulator, change: str, **values: object) -> None:
    _must(simulator, "SetObjectStates", SetObjectStates={"stateChange": change, **values})


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
        target = f" of {arguments['objectId']}" if "objectId" in arguments else ""
        raise InvalidEpisode(f"{action}{target} failed while setting up: {outcome.message}.")


def _stand(simulator: Simulator, seed: int) -> None:
    """Start somewhere free, so that no start is nearer to the solution by design."""
    choose = random.Random(seed)
    place = choose.choice(simulator.reachable())
    _must(simulator, "Teleport", **_pose(place, choose.choice((0.0, 90.0, 180.0, 270.0)), 30.0))


def _stand_near(simulator: Simulator, start: Pose) -> None:
    """Start where the trial does, or at the free place nearest to it."""
    if not simulator.act("Teleport", **_pose(*start[:3])).success:
        places = simulator.reachable()
        if not places:
            raise InvalidEpisode("There is nowhere in the room for the robot to stand.")
        near = min(places, key=lambda place: dist(place, start.position))
        _must(simulator, "Teleport", **_pose(near, start.yaw, start.horizon))


def _pose(place: Vector, yaw: float, horizon: float) -> dict[str, object]:
    return {
        "position": {"x": place.x, "y": place.y, "z": place.z},
        "rotation": {"x": 0.0, "y": yaw, "z": 0.0},
        "horizon": horizon,
        "standing": True,
    }
