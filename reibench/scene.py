"""Scenes: what is in a room at one moment, as both simulators report it.

Positions are in metres in AI2-THOR's axes (x right, y up, z forward); angles in degrees.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple

Temperature = Literal["RoomTemp", "Hot", "Cold"]


class Vector(NamedTuple):
    """A point or an extent in metres."""

    x: float
    y: float
    z: float


class Box(NamedTuple):
    """An axis-aligned box."""

    center: Vector
    size: Vector


class Pose(NamedTuple):
    """Where the robot stands and looks."""

    position: Vector
    yaw: float
    """Degrees clockwise from +z."""
    horizon: float = 0.0
    """Degrees the camera looks down."""
    standing: bool = True


@dataclass(frozen=True, slots=True)
class SceneObject:
    """One object: what it can be, where it is and what state it is in."""

    id: str
    """`Type|+xx.xx|+yy.yy|+zz.zz`, fixed at load time."""
    type: str
    name: str
    position: Vector
    yaw: float
    box: Box
    parents: tuple[str, ...] = ()
    """Ids of the receptacles it is in or on, nearest first."""
    contents: tuple[str, ...] | None = None
    """Ids of what it holds; None unless it is a receptacle."""
    pickupable: bool = False
    moveable: bool = False
    openable: bool = False
    toggleable: bool = False
    sliceable: bool = False
    breakable: bool = False
    dirtyable: bool = False
    fillable: bool = False
    cookable: bool = False
    heat_source: bool = False
    cold_source: bool = False
    held: bool = False
    open: bool = False
    on: bool = False
    sliced: bool = False
    broken: bool = False
    dirty: bool = False
    filled: bool = False
    liquid: str = ""
    """What it is filled with, e.g. `water`; empty if nothing."""
    cooked: bool = False
    temperature: Temperature = "RoomTemp"

    @property
    def receptacle(self) -> bool:
        """Whether things can be in or on it."""
        return self.contents is not None


@dataclass(frozen=True)
class Scene:
    """A room at one moment."""

    room: str
    objects: tuple[SceneObject, ...]
    agent: Pose
    visible: frozenset[str] = frozenset()
    """Ids of what the robot sees: in its view, in reach, and not hidden in something closed."""
    bounds: Box = Box(Vector(0, 0, 0), Vector(0, 0, 0))
    """The inside of the room."""

    @cached_property
    def by_id(self) -> dict[str, SceneObject]:
        """The objects by their id."""
        return {thing.id: thing for thing in self.objects}

    @cached_property
    def held(self) -> SceneObject | None:
        """What the robot has in its hand."""
        return next((thing for thing in self.objects if thing.held), None)

    def of_type(self, object_type: str) -> list[SceneObject]:
        """Return the objects of exactly this type, in scene order."""
        return [thing for thing in self.objects if thing.type == object_type]

    def closed_around(self, thing: SceneObject) -> SceneObject | None:
        """Return the closed container `thing` is inside, if any, however deep.

        Only what can be picked up can be; in real rooms the boxes of fixed things overlap, and a
        microwave that stands on a fridge is listed in it.
        """
        if not thing.pickupable:
            return None
        # Real metadata holds loops (a cup "in" the counter it stands on), so ids are met once.
        waiting, met = list(thing.parents), {thing.id}
        while waiting:
            parent_id = waiting.pop(0)
            parent = self.by_id.get(parent_id)
            if parent is None or parent_id in met:
                continue
            met.add(parent_id)
            if parent.openable and not parent.open and parent.type in CONTAINERS:
                return parent
            if parent.pickupable:  # what is built in goes nowhere with the plate that stood on it
                waiting.extend(parent.parents)
        return None


CONTAINERS = frozenset(("Box", "Cabinet", "Drawer", "Fridge", "LaundryHamper", "Microwave", "Safe"))
"""Types that hide what they hold while closed; Book, Laptop and Toilet open but hide nothing."""
