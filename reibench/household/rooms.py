"""Rooms: what stands where before anything happens, and the files they are kept in."""

import json
import os
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from pathlib import Path
from typing import Any

from reibench.errors import InvalidRoom, UnknownName, unknown
from reibench.household.entries import describe_object, exact, read_box, read_object, rounded
from reibench.household.floor import GRID, Solid, SurveyedFloor, WalkableFloor
from reibench.household.geometry import Footprint, footprint
from reibench.household.objects import SURFACES
from reibench.household.particulars import Particulars
from reibench.household.particulars import describe as describe_particulars
from reibench.household.particulars import read as read_particulars
from reibench.household.solids import holds, shapes, solids
from reibench.scene import Box, Pose, SceneObject, Vector

PROJECT = Path(__file__).parents[2]
ROOMS = PROJECT / "assets" / "rooms"
"""The rooms that come with the library."""


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
    openness: Mapping[str, float] = field(default_factory=dict)
    """How far what is neither shut nor wide open is open, 0 to 1."""
    particulars: Mapping[str, Particulars] = field(default_factory=dict)
    """By id, of the objects of rooms read from AI2-THOR; generated ones have none."""
    standing: tuple[Vector, ...] = ()
    """Where AI2-THOR says the robot can stand; empty if it has not been asked."""

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
        if self.standing:
            return SurveyedFloor(self.bounds, self.solids() or (), self.standing)
        return self.floor_of(GRID)

    def floor_of(self, grid: float) -> WalkableFloor:
        """Return where the robot can walk on a grid of that many metres."""
        start = self.start.position
        return WalkableFloor(self.bounds, self.objects, start, grid, solids=self.solids())

    def surface(self, name: str) -> Callable[[Box], bool] | None:
        """Return what says whether things stay on an object; None where its box says it."""
        thing = self.by_id.get(name)
        if not self.particulars or thing is None or thing.type not in SURFACES:
            return None
        parts = shapes(thing, self.objects, self.particulars, self.bounds)
        return partial(holds, parts)

    def solids(self) -> list[tuple[str, Solid]] | None:
        """Return, by object id, where the robot cannot be; None if the boxes say it."""
        if not self.particulars:
            return None
        return solids(self.objects, self.particulars, self.bounds)

    @property
    def reachable(self) -> tuple[Vector, ...]:
        """The grid positions the robot can reach from its start."""
        return self.floor.points


def imported_rooms() -> Path:
    """Where imported rooms are kept: `REIBENCH_ROOMS`, or `data/rooms` under the project."""
    return Path(os.environ.get("REIBENCH_ROOMS") or PROJECT / "data" / "rooms").expanduser()


def room_names() -> tuple[str, ...]:
    """Return the names of the rooms at hand, the shipped and the imported ones, sorted."""
    folders = (ROOMS, imported_rooms())
    names = {path.stem for folder in folders for path in folder.glob("*.json")}
    return tuple(sorted(names, key=_by_number))


def load_room(name: str | Path) -> Room:
    """Return the room called `name`, or the one in that file.

    Raises:
        UnknownName: when there is none called that.
        InvalidRoom: when its file is damaged or says something impossible.
    """
    path = _file_of(name)
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
    """Return `room` as the text of its file; what was measured in AI2-THOR is not rounded."""
    numbers = exact if room.particulars else rounded
    head = {
        "name": room.name,
        "kind": room.kind,
        "bounds": numbers(*room.bounds.center, *room.bounds.size),
        "start": numbers(*room.start.position, room.start.yaw, room.start.horizon),
        "controls": {name: list(ids) for name, ids in room.controls.items()},
    }
    if room.openness:
        head["openness"] = dict(room.openness)
    if room.standing:
        head["standing"] = [number for point in room.standing for number in point]
    lines = [f' "{key}": {_dump(value)},' for key, value in head.items()]
    objects = ",\n".join(f"  {_dump(entry)}" for entry in _entries(room))
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


def with_contents(things: list[SceneObject]) -> tuple[SceneObject, ...]:
    """Return `things` with each receptacle's `contents` made to agree with their `parents`.

    Contents that agree keep their order.
    """
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


def _entries(room: Room) -> Iterator[dict[str, Any]]:
    """Yield each object's entry; the order of contents is told where it is not the room's."""
    emptied = [replace(each, contents=() if each.receptacle else None) for each in room.objects]
    for thing, usual in zip(room.objects, with_contents(emptied), strict=True):
        entry = describe_object(thing, exact if room.particulars else rounded)
        if thing.contents != usual.contents:
            entry["holds"] = list(thing.contents or ())
        if own := room.particulars.get(thing.id):
            entry |= describe_particulars(own)
        yield entry


def _changed(thing: SceneObject, contents: tuple[str, ...] | None) -> SceneObject:
    same = sorted(thing.contents or ()) == sorted(contents or ())
    return thing if same else replace(thing, contents=contents)


def _file_of(name: str | Path) -> Path:
    path = Path(name)
    if path.suffix == ".json":
        return path
    for folder in (ROOMS, imported_rooms()):
        if path.name == str(name) and (folder / f"{name}.json").is_file():
            return folder / f"{name}.json"
    raise unknown("room", str(name), room_names())


def _by_number(name: str) -> list[tuple[int, str]]:
    """Sort `FloorPlan10` after `FloorPlan9`."""
    return [(int(part), "") if part.isdigit() else (0, part) for part in re.split(r"(\d+)", name)]


def _parse(content: Any) -> Room:
    things = [read_object(entry) for entry in content["objects"]]
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
        bounds=read_box(content["bounds"]),
        objects=with_contents(things),
        start=Pose(Vector(x, y, z), yaw, horizon),
        controls=controls,
        openness={str(name): float(much) for name, much in content.get("openness", {}).items()},
        particulars=dict(_particulars(content["objects"])),
        standing=_points(content.get("standing", ())),
    )


def _particulars(entries: list[dict[str, Any]]) -> Iterator[tuple[str, Particulars]]:
    for entry in entries:
        if own := read_particulars(entry):
            yield entry["id"], own


def _points(numbers: list[float]) -> tuple[Vector, ...]:
    flat = iter(map(float, numbers))
    return tuple(Vector(*each) for each in zip(flat, flat, flat, strict=True))


def _dump(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))
