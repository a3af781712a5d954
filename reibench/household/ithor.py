"""Real rooms: AI2-THOR 5's object metadata of a whole room, read into a `Room`."""

import json
import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from reibench.errors import InvalidRoom, UnknownName
from reibench.household.floor import RADIUS, WalkableFloor
from reibench.household.geometry import Footprint, footprint
from reibench.household.metadata import scene_from_metadata
from reibench.household.objects import object_type
from reibench.household.particulars import Particulars
from reibench.household.rooms import Room
from reibench.scene import Box, Pose, Scene, SceneObject, Vector

NOWHERE = Pose(Vector(0.0, 0.0, 0.0), 0.0)
KINDS = {0: "kitchen", 2: "living room", 3: "bedroom", 4: "bathroom"}
"""Kinds of iTHOR's rooms by the hundreds of their number."""
NOT_MODELLED = {
    "visible": "depends on where the robot stood, which a dump does not say",
    "isInteractable": "depends on where the robot stood",
    "distance": "depends on where the robot stood",
    "isMoving": "how things were settling when the dump was made; nothing moves by itself here",
}
"""Keys of object metadata that do not come out of a room as they were read, and why.

Every other key comes out exactly as it went in: same value, same order, to the last digit.
"""
STANDING_KEY = "reachablePositions"
"""Key of a dump, beside the objects' ids, for where the robot can stand."""


def read_dump(path: Path) -> Room:
    """Read a room's dump: object metadata by object id, its name the file's.

    Raises:
        InvalidRoom: when it is no dump, or something a room needs is missing in it.
    """
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
        return room_from_dump(path.stem.removesuffix("_physics"), content)
    except (OSError, ValueError) as error:
        raise InvalidRoom(f"The dump {path} cannot be read as JSON: {error}.") from None
    except InvalidRoom as error:
        raise InvalidRoom(f"{path} is not the dump of a room: {error}") from None


def room_from_dump(name: str, content: object) -> Room:
    """Make a room of its dump; raises InvalidRoom."""
    if not isinstance(content, Mapping):
        raise InvalidRoom("it should be one JSON object, of object metadata by object id.")
    described = {key: each for key, each in content.items() if _is_object(each)}
    if not described:
        raise InvalidRoom("there is no object metadata in it.")
    scene = scene_from_metadata(described)
    _check(scene)
    try:
        standing = tuple(
            Vector(float(point["x"]), float(point["y"]), float(point["z"]))
            for point in content.get(STANDING_KEY, ())
        )
        room = Room(
            name=name,
            kind=_kind(name, scene),
            bounds=_bounds(scene, standing),
            objects=scene.objects,
            start=NOWHERE,
            controls={
                each["objectId"]: tuple(each["controlledObjects"])
                for each in described.values()
                if each.get("controlledObjects")
            },
            openness={
                each["objectId"]: float(each["openness"])
                for each in described.values()
                if float(each["openness"]) != float(each["isOpen"])
            },
            particulars={
                thing.id: _particulars(described[thing.id], thing) for thing in scene.objects
            },
            standing=standing,
        )
    except (KeyError, TypeError, ValueError) as error:
        raise InvalidRoom(f"a value is missing or of the wrong form ({error!r}).") from None
    return replace(room, start=_start(room))


def _check(scene: Scene) -> None:
    try:
        types = {object_type(thing.type).name for thing in scene.objects}
    except UnknownName as error:
        raise InvalidRoom(str(error)) from None
    if "Floor" not in types or len(types) == 1:
        raise InvalidRoom("a room has a floor and something on it.")


def _is_object(value: object) -> bool:
    return isinstance(value, Mapping) and "objectId" in value


def _kind(name: str, scene: Scene) -> str:
    """Return the kind of room: by its number, or else by what only stands in rooms of a kind."""
    if numbered := re.fullmatch(r"FloorPlan(\d+)", name):
        return KINDS.get(int(numbered[1]) // 100, "living room")
    for type_, kind in {"Toilet": "bathroom", "Fridge": "kitchen", "Bed": "bedroom"}.items():
        if scene.of_type(type_):
            return kind
    return "living room"


def _particulars(each: Mapping[str, Any], thing: SceneObject) -> Particulars:
    materials, oriented = each["salientMaterials"], each["objectOrientedBoundingBox"]
    parents = tuple(each["parentReceptacles"] or ())
    turn = each["rotation"]
    return Particulars(
        asset=str(each["assetId"]),
        mass=float(each["mass"]),
        materials=None if materials is None else tuple(materials),
        tilt=(float(turn["x"]), float(turn["z"])),
        corners=tuple(Vector(*map(float, one)) for one in oriented["cornerPoints"])
        if oriented
        else (),
        parents=() if parents == thing.parents else parents,
    )


def _start(room: Room) -> Pose:
    """Return the place to start from: in the middle of the largest part of the floor."""
    walkable = WalkableFloor(room.bounds, (), None, solids=room.solids())
    points = room.standing or walkable.points
    if not points:
        raise InvalidRoom("there is nowhere in it to stand.")
    x, _, z = room.bounds.center
    nearest = min(points, key=lambda point: (point.x - x) ** 2 + (point.z - z) ** 2)
    return Pose(nearest, 0.0, 30.0)


def _bounds(scene: Scene, standing: tuple[Vector, ...]) -> Box:
    """Return the inside of the walls: as far as anything goes but the floor, whose box is wide."""
    areas = [footprint(thing.box) for thing in scene.objects if thing.type != "Floor"]
    areas += [Footprint(x, x, z, z, x, z).grown(RADIUS) for x, _, z in standing]
    left, right = min(a.left for a in areas), max(a.right for a in areas)
    near, far = min(a.near for a in areas), max(a.far for a in areas)
    middle = Vector((left + right) / 2, 1.5, (near + far) / 2)
    return Box(middle, Vector(right - left, 3.0, far - near))
