"""Rooms: what stands where before anything happens, and the files they are kept in."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any
from zlib import crc32

from reibench.errors import InvalidRoom, UnknownName, unknown
from reibench.household.floor import WalkableFloor
from reibench.household.geometry import Footprint, footprint
from reibench.household.objects import TRAITS, object_type, type_of
from reibench.scene import Box, Pose, SceneObject, Vector

ROOMS = Path(__file__).parents[2] / "assets" / "rooms"
STATES = ("open", "on", "dirty", "filled", "broken", "cooked")


@dataclass(frozen=True)
class Room:
    """A room as it is before anything happens."""

    name: str
    kind: str
    """`kitchen`, `living room`, `bedroom` or `bathroom`."""
    bounds: Box
    """The inside of its walls."""
    objects: tuple[SceneObject, ...]
    start: Pose
    controls: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Ids of what a switch switches: a stove knob its burner."""

    @cached_property
    def by_id(self) -> dict[str, SceneObject]:
        """The objects by their id."""
        return {thing.id: thing for thing in self.objects}

    @cached_property
    def footprints(self) -> dict[str, Footprint]:
        """What each object covers, seen from above."""
        return {thing.id: footprint(thing.box) for thing in self.objects}

    @cached_property
    def floor(self) -> WalkableFloor:
        """Where the robot can walk, on the usual grid."""
        return WalkableFloor(self.bounds, self.objects, self.start.position)

    @property
    def reachable(self) -> tuple[Vector, ...]:
        """The grid positions the robot can reach from its start."""
        return self.floor.points


def room_names() -> tuple[str, ...]:
    """Return the names of the rooms at hand, sorted."""
    return tuple(sorted(path.stem for path in ROOMS.glob("*.json")))


def load_room(name: str | Path) -> Room:
    """Return the room called `name`, or the one in that file.

    Raises:
        UnknownName: when there is none called that.
        InvalidRoom: when its file is damaged or says something impossible.
    """
    path = Path(name)
    if path.suffix != ".json":
        if str(name) not in room_names():
            raise unknown("room", str(name), room_names())
        path = ROOMS / f"{name}.json"
    try:
        return parse_room(json.loads(path.read_text(encoding="utf-8")))
    except FileNotFoundError:
        raise UnknownName(f"There is no room file {path}.") from None
    except (OSError, ValueError) as error:
        raise InvalidRoom(f"The room file {path} cannot be read as JSON: {error}.") from None
    except InvalidRoom as error:
        raise InvalidRoom(f"The room file {path} is not a room: {error}") from None


def save_room(room: Room, path: Path) -> None:
    """Write `room` to a file that `load_room` reads, one object a line."""
    path.write_text(format_room(room), encoding="utf-8")


def format_room(room: Room) -> str:
    """Return `room` as the text of its file."""
    head = {
        "name": room.name,
        "kind": room.kind,
        "bounds": _numbers(*room.bounds.center, *room.bounds.size),
        "start": _numbers(*room.start.position, room.start.yaw, room.start.horizon),
        "controls": {name: list(ids) for name, ids in room.controls.items()},
    }
    lines = [f' "{key}": {_dump(value)},' for key, value in head.items()]
    objects = ",\n".join(f"  {_dump(_describe(thing))}" for thing in room.objects)
    return "{\n" + "\n".join(lines) + f'\n "objects": [\n{objects}\n ]\n}}\n'


def parse_room(content: object) -> Room:
    """Read what a room file holds; raises InvalidRoom."""
    try:
        return _parse(content)
    except KeyError as error:
        raise InvalidRoom(f"{error} is missing.") from None
    except (TypeError, ValueError, AttributeError) as error:
        raise InvalidRoom(f"a value has the wrong form ({error}).") from None
    except UnknownName as error:
        raise InvalidRoom(str(error)) from None


def name_of(object_id: str) -> str:
    """Return an object name like AI2-THOR's: the type and eight digits, here made of the id."""
    return f"{type_of(object_id)}_{crc32(object_id.encode()):08x}"


def with_contents(things: list[SceneObject]) -> tuple[SceneObject, ...]:
    """Return `things` with each receptacle's `contents` made to agree with their `parents`."""
    held: dict[str, list[str]] = {thing.id: [] for thing in things}
    for thing in things:
        for parent in thing.parents:
            if parent not in held:
                raise InvalidRoom(f"{thing.id} is in {parent}, which is not in the room.")
            held[parent].append(thing.id)
    made = []
    for thing in things:
        if held[thing.id] and thing.contents is None:
            raise InvalidRoom(f"{thing.id} holds something, but is no receptacle.")
        contents = None if thing.contents is None else tuple(held[thing.id])
        made.append(_changed(thing, contents))
    return tuple(made)


def _changed(thing: SceneObject, contents: tuple[str, ...] | None) -> SceneObject:
    return thing if thing.contents == contents else replace(thing, contents=contents)


def _parse(content: Any) -> Room:
    things = [_read_object(entry) for entry in content["objects"]]
    ids = [thing.id for thing in things]
    if twice := next((name for name in ids if ids.count(name) > 1), None):
        raise InvalidRoom(f"{twice} is in it twice.")
    controls = {str(name): tuple(map(str, of)) for name, of in content["controls"].items()}
    for switch, switched in controls.items():
        if absent := next((name for name in (switch, *switched) if name not in ids), None):
            raise InvalidRoom(f"the switch {switch} names {absent}, which is not in the room.")
    x, y, z, yaw, horizon = map(float, content["start"])
    return Room(
        name=str(content["name"]),
        kind=str(content["kind"]),
        bounds=_box(content["bounds"]),
        objects=with_contents(things),
        start=Pose(Vector(x, y, z), yaw, horizon),
        controls=controls,
    )


def _read_object(entry: dict[str, Any]) -> SceneObject:
    kind = object_type(type_of(entry["id"]))
    traits = frozenset(entry.get("traits", kind.traits))
    return SceneObject(
        id=entry["id"],
        type=kind.name,
        name=entry.get("name") or name_of(entry["id"]),
        position=Vector(*map(float, entry["at"])),
        yaw=float(entry.get("yaw", 0)),
        box=_box(entry["box"]),
        parents=tuple(entry.get("in", ())),
        contents=() if "receptacle" in traits else None,
        liquid=entry.get("liquid", ""),
        temperature=entry.get("temperature", "RoomTemp"),
        **{trait: trait in traits for trait in TRAITS[1:]},
        **{state: bool(entry.get(state, False)) for state in STATES},
    )


def _describe(thing: SceneObject) -> dict[str, Any]:
    """Say only what its id and type do not."""
    entry: dict[str, Any] = {"id": thing.id, "at": _numbers(*thing.position)}
    entry["box"] = _numbers(*thing.box.center, *thing.box.size)
    if thing.yaw:
        entry["yaw"] = _numbers(thing.yaw)[0]
    if thing.parents:
        entry["in"] = list(thing.parents)
    if thing.name != name_of(thing.id):
        entry["name"] = thing.name
    traits = {trait for trait in TRAITS[1:] if getattr(thing, trait)}
    traits |= {"receptacle"} if thing.receptacle else set()
    if traits != object_type(thing.type).traits:
        entry["traits"] = sorted(traits)
    entry |= {state: True for state in STATES if getattr(thing, state)}
    if thing.liquid:
        entry["liquid"] = thing.liquid
    if thing.temperature != "RoomTemp":
        entry["temperature"] = thing.temperature
    return entry


def _box(numbers: list[float]) -> Box:
    x, y, z, width, height, depth = map(float, numbers)
    return Box(Vector(x, y, z), Vector(width, height, depth))


def _numbers(*values: float) -> list[float]:
    """Round to a tenth of a millimetre, so that files can be compared."""
    return [int(value) if value == int(value) else round(value, 4) for value in values]


def _dump(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))
