"""The room as it is now: what contains what, where the robot is, and what it sees."""

from collections.abc import Iterator
from dataclasses import dataclass, fields
from functools import cached_property
from operator import attrgetter
from typing import Any

from reibench.household.cameras import Camera
from reibench.household.floor import GRID, WalkableFloor
from reibench.household.geometry import Footprint, Sight, footprint, forward, shifted
from reibench.household.objects import SOURCES
from reibench.household.rooms import Room
from reibench.scene import CONTAINERS, Box, Pose, Scene, SceneObject, Vector

Objects = dict[str, SceneObject]
_NAMES = tuple(field.name for field in fields(SceneObject))
_PLACES = {name: place for place, name in enumerate(_NAMES)}
_values = attrgetter(*_NAMES)
HAND_HEIGHT = 1.1
HAND_DISTANCE = 0.45
"""Where a held thing floats: in front of the camera, in metres."""


@dataclass(frozen=True)
class Settings:
    """How a controller was asked to behave."""

    grid: float = GRID
    reach: float = 1.5
    """Metres within which things are visible and can be acted on, measured horizontally."""
    field_of_view: float = 90.0
    """Degrees."""
    screen: tuple[int, int] = (300, 300)
    """Width and height of frames, in pixels."""


@dataclass(frozen=True)
class Moment:
    """A room at one moment; later actions leave it as it is."""

    room: Room
    objects: Objects
    """By id; never changed in place."""
    footprints: dict[str, Footprint]
    openness: dict[str, float]
    """How far what is open is open, 0 to 1, where that is neither."""
    agent: Pose
    sight: Sight
    settings: Settings
    cameras: tuple[Camera, ...] = ()
    """Third-party cameras, in the order they were hung up."""

    @cached_property
    def scene(self) -> Scene:
        """The scene as both simulators report it."""
        objects, takes_in = self.objects, self.sight.takes_in
        visible = frozenset(
            name
            for name, area in self.footprints.items()
            if takes_in(area) and not hidden(objects, objects[name])
        )
        things = tuple(objects.values())
        return Scene(self.room.name, things, self.agent, visible, self.room.bounds)

    def sees(self, name: str) -> bool:
        """Whether the robot sees that object."""
        thing = self.objects.get(name)
        if thing is None or not self.sight.takes_in(self.footprints[name]):
            return False
        return not hidden(self.objects, thing)


class State:
    """A room in use. Every change replaces what it touches, so moments stay as they were."""

    def __init__(self, room: Room, settings: Settings) -> None:
        self.room = room
        self.settings = settings
        self.objects: Objects = room.by_id
        self.footprints = room.footprints
        self.openness = dict(room.openness)
        self.held = next((thing.id for thing in room.objects if thing.held), "")
        self.warmth: dict[str, int] = {}
        """When each hot or cold thing was last kept so."""
        self.time = 0
        self.sources = [thing.id for thing in room.objects if thing.type in SOURCES]
        self.cameras: tuple[Camera, ...] = ()
        self.agent = room.start
        self._moment: Moment | None = None

    @property
    def agent(self) -> Pose:
        """Where the robot stands and looks."""
        return self._agent

    @agent.setter
    def agent(self, pose: Pose) -> None:
        self._agent = pose
        reach, field_of_view = self.settings.reach, self.settings.field_of_view
        self.sight = Sight.of(pose.position, pose.yaw, reach, field_of_view)
        self._moment = None
        if self.held:
            self.move(self.held, self._hand())

    @cached_property
    def floor(self) -> WalkableFloor:
        """Where the robot can walk, on the grid asked for."""
        if self.settings.grid == GRID:
            return self.room.floor
        return self.room.floor_of(self.settings.grid)

    def configure(self, settings: Settings) -> None:
        """Behave as `settings` say from now on."""
        self.settings = settings
        self.__dict__.pop("floor", None)
        self.agent = self._agent

    def moment(self) -> Moment:
        """Return the room at this moment."""
        if self._moment is None:
            self._moment = Moment(
                self.room,
                self.objects,
                self.footprints,
                self.openness,
                self._agent,
                self.sight,
                self.settings,
                self.cameras,
            )
        return self._moment

    def forget_moment(self) -> None:
        """Have the next moment made anew, because something in it has changed."""
        self._moment = None

    def sees(self, name: str) -> bool:
        """Whether the robot sees that object."""
        return self.moment().sees(name)

    def of_type(self, object_type: str) -> list[SceneObject]:
        """Return the objects of exactly this type."""
        return [thing for thing in self.objects.values() if thing.type == object_type]

    def inside(self, name: str) -> Iterator[SceneObject]:
        """Go through all that is in or on an object, however deep, and can be taken out.

        Real rooms list what is built in too: a counter "in" the cup that stands on it.
        """
        seen, left = {name}, list(self.objects[name].contents or ())
        for inner in left:
            if inner not in seen and self.objects[inner].pickupable:
                seen.add(inner)
                yield self.objects[inner]
                left += self.objects[inner].contents or ()

    def change(self, name: str, **fields: Any) -> SceneObject:
        """Give an object other values for some fields."""
        changed = altered(self.objects[name], **fields)
        self.objects = self.objects | {name: changed}
        self._moment = None
        return changed

    def set_open(self, name: str, openness: float) -> None:
        """Open an object that far, from 0 to 1."""
        kept = {each: much for each, much in self.openness.items() if each != name}
        self.openness = kept if openness in (0, 1) else kept | {name: openness}
        self.change(name, open=openness > 0)

    def move(self, name: str, middle: Vector, size: Vector | None = None, **fields: Any) -> None:
        """Move an object's box to be around `middle`, and all that is in or on it along.

        With a `size` its box becomes that large: it was turned over. Other `fields` change with it.
        """
        thing = self.objects[name]
        dx, dy, dz = (new - old for new, old in zip(middle, thing.box.center, strict=True))
        x, y, z = thing.position
        box, position = Box(middle, size or thing.box.size), Vector(x + dx, y + dy, z + dz)
        moved = {name: altered(thing, position=position, box=box, **fields)}
        for each in self.inside(name):
            x, y, z = each.position
            box, position = shifted(each.box, dx, dy, dz), Vector(x + dx, y + dy, z + dz)
            moved[each.id] = altered(each, position=position, box=box)
        self.objects = self.objects | moved
        areas = {each: footprint(thing.box) for each, thing in moved.items()}
        self.footprints = self.footprints | areas
        self._moment = None

    def take(self, name: str) -> None:
        """Put an object into the robot's hand, from wherever it is."""
        self._leave(name)
        self._shed(name)
        self.held = name
        self.move(name, self._hand(), parents=(), held=True)

    def put(
        self, name: str, middle: Vector, size: Vector | None = None, *, receptacle: str = ""
    ) -> None:
        """Put an object down around `middle`, in or on `receptacle`, from wherever it is."""
        self._leave(name)
        if self.held == name:
            self.held = ""
        parents = (receptacle,) if receptacle else ()
        if receptacle:
            contents = self.objects[receptacle].contents or ()
            self.change(receptacle, contents=(*contents, name))
        self.move(name, middle, size, parents=parents, held=False)

    def add(self, thing: SceneObject) -> None:
        """Add a new object, in or on what its `parents` say."""
        self.objects = self.objects | {thing.id: thing}
        self.footprints = self.footprints | {thing.id: footprint(thing.box)}
        for parent in thing.parents:
            contents = self.objects[parent].contents or ()
            self.change(parent, contents=(*contents, thing.id))
        self._moment = None

    def remove(self, name: str) -> None:
        """Remove an object."""
        self._leave(name)
        self.objects = {each: thing for each, thing in self.objects.items() if each != name}
        areas = self.footprints.items()
        self.footprints = {each: area for each, area in areas if each != name}
        self.openness = {each: much for each, much in self.openness.items() if each != name}
        self.warmth.pop(name, None)
        self._moment = None

    def _leave(self, name: str) -> None:
        """Strike an object from the contents of whatever it is in or on."""
        for parent in self.objects[name].parents:
            contents = self.objects[parent].contents or ()
            self.change(parent, contents=tuple(one for one in contents if one != name))

    def _shed(self, name: str) -> None:
        """Strike what is built in from the contents of something that is taken away."""
        contents = self.objects[name].contents or ()
        built_in = [inner for inner in contents if not self.objects[inner].pickupable]
        for inner in built_in:
            parents = self.objects[inner].parents
            self.change(inner, parents=tuple(one for one in parents if one != name))
        if built_in:
            self.change(name, contents=tuple(one for one in contents if one not in built_in))

    def _hand(self) -> Vector:
        (x, _, z), yaw = self._agent.position, self._agent.yaw
        ahead_x, ahead_z = forward(yaw)
        return Vector(x + HAND_DISTANCE * ahead_x, HAND_HEIGHT, z + HAND_DISTANCE * ahead_z)


def altered(thing: SceneObject, **fields: Any) -> SceneObject:
    """Return `thing` with other values for some fields, faster than `dataclasses.replace`."""
    values = list(_values(thing))
    for name, value in fields.items():
        values[_PLACES[name]] = value
    return SceneObject(*values)


def hidden(objects: Objects, thing: SceneObject, seen: tuple[str, ...] = ()) -> bool:
    """Whether a thing is inside something closed, however deep.

    Only what can be picked up can be; in real rooms the boxes of cabinets and tables overlap so
    that fixed things are listed in each other.
    """
    if not thing.pickupable:
        return False
    for name in thing.parents:
        parent = objects[name]
        if parent.openable and not parent.open and parent.type in CONTAINERS:
            return True
        if parent.parents and name not in seen and hidden(objects, parent, (*seen, name)):
            return True
    return False
