"""AI2-THOR 5's event metadata: written from a moment, read back into a scene."""

from collections.abc import Iterable, Mapping
from itertools import product
from struct import Struct
from typing import Any

from reibench.errors import InvalidRoom
from reibench.household.cameras import camera_metadata
from reibench.household.geometry import forward, volume
from reibench.household.objects import object_type
from reibench.household.particulars import Particulars, usual
from reibench.household.scenes import room_name, scene_name
from reibench.household.state import HAND_DISTANCE, HAND_HEIGHT, Moment
from reibench.scene import Box, Pose, Scene, SceneObject, Vector

CAMERA = 0.675
"""Metres from the robot's position up to its camera, as in AI2-THOR."""
NOWHERE = {"x": 0.0, "y": 0.0, "z": 0.0}
Metadata = dict[str, Any]


def agent_metadata(moment: Moment) -> Metadata:
    """Return what AI2-THOR reports of a moment, but for objects and how the last action went."""
    scene, pose = moment.scene, moment.agent
    held, (width, height) = scene.held, moment.settings.screen
    return {
        "isSceneAtRest": True,
        "agent": {
            "name": "agent",
            "position": _point(pose.position),
            "rotation": _turn(pose.yaw),
            "cameraHorizon": pose.horizon,
            "isStanding": pose.standing,
            "inHighFrictionArea": False,
        },
        "heldObjectPose": _hand(pose),
        "arm": None,
        "fov": moment.settings.field_of_view,
        "cameraPosition": _point(camera_position(pose)),
        "cameraOrthSize": 0.0,
        "thirdPartyCameras": [camera_metadata(*each) for each in enumerate(moment.cameras)],
        "collided": False,
        "collidedObjects": [],
        "inventoryObjects": [{"objectId": held.id, "objectType": held.type}] if held else [],
        "sceneName": scene_name(scene.room),
        "screenWidth": width,
        "screenHeight": height,
        "agentId": 0,
        "depthFormat": "Meters",
        **dict.fromkeys(_UNUSED),
        "actionIntReturn": 0,
        "actionFloatReturn": 0.0,
        "visibleRange": None,
        "sceneBounds": _box(scene.bounds),
    }


def object_metadata(moment: Moment, thing: SceneObject) -> Metadata:
    """Return what AI2-THOR reports of one object."""
    room = moment.room
    own = room.particulars.get(thing.id) or usual(object_type(thing.type), thing)
    # Boxes are replaced, never changed: the same one has not been moved.
    at_home = room.particulars and room.by_id.get(thing.id, thing).box is thing.box
    seen = thing.id in moment.scene.visible
    in_order = own.parents if sorted(own.parents) == sorted(thing.parents) else thing.parents
    return {
        "name": thing.name,
        "objectId": thing.id,
        "objectType": thing.type,
        "assetId": own.asset,
        "position": _point(thing.position),
        "rotation": _turn(thing.yaw, *(own.tilt if at_home else ())),
        "visible": seen,
        "isInteractable": seen,
        "distance": distance_between(thing.position, moment.agent.position),
        "receptacle": thing.receptacle,
        "receptacleObjectIds": None if thing.contents is None else list(thing.contents),
        "parentReceptacles": list(in_order) or None,
        "pickupable": thing.pickupable,
        "isPickedUp": thing.held,
        "moveable": thing.moveable,
        "isMoving": False,
        "openable": thing.openable,
        "isOpen": thing.open,
        "openness": moment.openness.get(thing.id, 1.0 if thing.open else 0.0),
        **_states(thing),
        "mass": own.mass,
        "salientMaterials": None if own.materials is None else list(own.materials),
        "controlledObjects": list(room.controls.get(thing.id, ())) if thing.toggleable else None,
        "axisAlignedBoundingBox": _box(thing.box),
        "objectOrientedBoundingBox": _oriented(thing, own) if at_home else _around(thing),
    }


def distance_between(point: Vector, other: Vector) -> float:
    """Return how far two points are apart, in metres."""
    (x, y, z), (other_x, other_y, other_z) = point, other
    return float(((x - other_x) ** 2 + (y - other_y) ** 2 + (z - other_z) ** 2) ** 0.5)


def _states(thing: SceneObject) -> Metadata:
    return {
        "toggleable": thing.toggleable,
        "isToggled": thing.on,
        "breakable": thing.breakable,
        "isBroken": thing.broken,
        "canFillWithLiquid": thing.fillable,
        "isFilledWithLiquid": thing.filled,
        "fillLiquid": thing.liquid or None,
        "dirtyable": thing.dirtyable,
        "isDirty": thing.dirty,
        "canBeUsedUp": False,
        "isUsedUp": False,
        "cookable": thing.cookable,
        "isCooked": thing.cooked,
        "sliceable": thing.sliceable,
        "isSliced": thing.sliced,
        "temperature": thing.temperature,
        "isHeatSource": thing.heat_source,
        "isColdSource": thing.cold_source,
    }


def scene_from_metadata(metadata: Mapping[str, Any]) -> Scene:
    """Read AI2-THOR 5's metadata, or a bare table of objects by id.

    Raises:
        InvalidRoom: when something a scene needs is missing or of the wrong form.
    """
    try:
        return _read(metadata)
    except KeyError as error:
        raise InvalidRoom(f"The metadata lack {error}.") from None
    except (TypeError, ValueError, AttributeError) as error:
        raise InvalidRoom(f"The metadata hold a value of the wrong form ({error}).") from None


def _read(metadata: Mapping[str, Any]) -> Scene:
    described: list[Mapping[str, Any]] = (
        metadata["objects"] if "objects" in metadata else list(metadata.values())
    )
    volumes = {
        each["objectId"]: volume(_read_box(each["axisAlignedBoundingBox"])) for each in described
    }
    objects = tuple(_read_object(each, volumes) for each in described)
    agent = metadata.get("agent")
    bounds = metadata.get("sceneBounds")
    return Scene(
        room=room_name(str(metadata.get("sceneName", ""))),
        objects=objects,
        agent=_read_pose(agent) if agent else Pose(Vector(0.0, 0.0, 0.0), 0.0),
        visible=frozenset(each["objectId"] for each in described if each["visible"]),
        bounds=_read_box(bounds) if bounds else Box(Vector(0, 0, 0), Vector(0, 0, 0)),
    )


def _read_pose(agent: Mapping[str, Any]) -> Pose:
    return Pose(
        _read_point(agent["position"]),
        float(agent["rotation"]["y"]),
        float(agent["cameraHorizon"]),
        bool(agent["isStanding"]),
    )


def _read_object(each: Mapping[str, Any], volumes: Mapping[str, float]) -> SceneObject:
    # AI2-THOR lists parents in no useful order; the smallest is the one a thing lies on.
    parents = [name for name in each["parentReceptacles"] or () if name in volumes]
    contents = each["receptacleObjectIds"]
    return SceneObject(
        id=each["objectId"],
        type=each["objectType"],
        name=each["name"],
        position=_read_point(each["position"]),
        yaw=float(each["rotation"]["y"]),
        box=_read_box(each["axisAlignedBoundingBox"]),
        parents=tuple(sorted(parents, key=lambda name: volumes[name])),
        contents=None if contents is None else tuple(contents),
        pickupable=each["pickupable"],
        moveable=each["moveable"],
        openable=each["openable"],
        toggleable=each["toggleable"],
        sliceable=each["sliceable"],
        breakable=each["breakable"],
        dirtyable=each["dirtyable"],
        fillable=each["canFillWithLiquid"],
        cookable=each["cookable"],
        heat_source=each["isHeatSource"],
        cold_source=each["isColdSource"],
        held=each["isPickedUp"],
        open=each["isOpen"],
        on=each["isToggled"],
        sliced=each["isSliced"],
        broken=each["isBroken"],
        dirty=each["isDirty"],
        filled=each["isFilledWithLiquid"],
        liquid=each["fillLiquid"] or "",
        cooked=each["isCooked"],
        temperature=each["temperature"],
    )


def _read_point(point: Mapping[str, float]) -> Vector:
    return Vector(float(point["x"]), float(point["y"]), float(point["z"]))


def _read_box(box: Mapping[str, Any]) -> Box:
    return Box(_read_point(box["center"]), _read_point(box["size"]))


def _point(point: Vector) -> dict[str, float]:
    return {"x": point.x, "y": point.y, "z": point.z}


def _turn(yaw: float, x: float = 0.0, z: float = 0.0) -> dict[str, float]:
    return {"x": x, "y": yaw, "z": z}


def camera_position(pose: Pose) -> Vector:
    """Return where the robot's eye is."""
    return pose.position._replace(y=pose.position.y + (CAMERA if pose.standing else 0.0))


def _hand(pose: Pose) -> Metadata:
    ahead_x, ahead_z = forward(pose.yaw)
    x, z = pose.position.x + HAND_DISTANCE * ahead_x, pose.position.z + HAND_DISTANCE * ahead_z
    return {
        "position": {"x": x, "y": HAND_HEIGHT, "z": z},
        "rotation": _turn(pose.yaw),
        "localPosition": {"x": 0.0, "y": HAND_HEIGHT - CAMERA, "z": HAND_DISTANCE},
        "localRotation": dict(NOWHERE),
    }


def _oriented(thing: SceneObject, own: Particulars) -> Metadata | None:
    if not own.corners:
        return None
    return {"cornerPoints": [list(corner) for corner in own.corners]}


def _around(thing: SceneObject) -> Metadata | None:
    """Return the box of something not turned, of what AI2-THOR reports one."""
    return _corners(thing.box) if thing.pickupable or thing.moveable else None


def _box(box: Box) -> Metadata:
    return {**_corners(box), "center": _point(box.center), "size": _point(box.size)}


def _corners(box: Box) -> Metadata:
    sides: Iterable[tuple[float, float]] = (
        (_single(middle + _single(extent / 2)), _single(middle - _single(extent / 2)))
        for middle, extent in zip(box.center, box.size, strict=True)
    )
    return {"cornerPoints": [list(corner) for corner in product(*sides)]}


def _single(value: float) -> float:
    """Round to single precision, in which AI2-THOR computes corners."""
    return float(_SINGLE.unpack(_SINGLE.pack(value))[0])


_SINGLE = Struct("f")
_UNUSED = (
    "colors flatSurfacesOnGrid distances normals isOpenableGrid segmentedObjectIds objectIdsInBox"
    " actionStringsReturn actionFloatsReturn actionVector3sReturn"
).split()
"""Keys that are null unless an action fills them that has no place here."""
