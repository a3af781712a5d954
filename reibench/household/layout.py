"""Laying out a room: walls, and furniture that keeps clear of other furniture."""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from random import Random
from typing import Any, NamedTuple

from reibench.household.entries import name_of
from reibench.household.geometry import Footprint, bottom, footprint
from reibench.household.objects import ROOM_KINDS, TRAITS, object_type
from reibench.scene import Box, SceneObject, Vector

CEILING = 2.6
PASSAGE = 0.7
"""Metres kept free in front of what is opened or used."""


class Wall(NamedTuple):
    """One wall, seen from inside; places along it are measured from its middle."""

    yaw: float
    """Which way what stands against it faces."""
    length: float
    distance: float
    """From the room's middle."""

    def box(self, along: float, extent: Vector, *, low: float = 0.0, gap: float = 0.0) -> Box:
        """Return a box of that width, height and depth, its back `gap` metres from the wall."""
        width, height, depth = extent
        away = self.distance - gap - depth / 2
        middle = low + height / 2
        match self.yaw:
            case 0:
                return Box(Vector(along, middle, -away), Vector(width, height, depth))
            case 180:
                return Box(Vector(along, middle, away), Vector(width, height, depth))
            case 90:
                return Box(Vector(-away, middle, along), Vector(depth, height, width))
            case _:
                return Box(Vector(away, middle, along), Vector(depth, height, width))


@dataclass
class Draft:
    """A room being furnished."""

    kind: str
    random: Random
    width: float
    depth: float
    require: frozenset[str] = frozenset()
    allow: frozenset[str] | None = None
    """Which optional types may appear beside the required ones; None for any."""
    plenty: float = 1.0
    """How much furniture to put in, about 1."""
    things: dict[str, SceneObject] = field(default_factory=dict)
    controls: dict[str, tuple[str, ...]] = field(default_factory=dict)
    bodies: list[Footprint] = field(default_factory=list)
    """Floor that furniture stands on."""
    passages: list[Footprint] = field(default_factory=list)
    """Floor that has to stay free."""

    full: set[tuple[str, str]] = field(default_factory=set)
    """Object types, with ids of receptacles that were found to have no room for them."""

    def __post_init__(self) -> None:
        # What one walks on is its upper side, at height 0, and that is where it is said to be.
        size = Vector(self.width, 0.0, self.depth)
        self.floor = self.add("Floor", Box(Vector(0.0, 0.0, 0.0), size)).id

    @property
    def walls(self) -> tuple[Wall, ...]:
        """The four walls: back, front, left, right."""
        x, z = self.width / 2, self.depth / 2
        return (
            Wall(180, self.width, z),
            Wall(0, self.width, z),
            Wall(90, self.depth, x),
            Wall(270, self.depth, x),
        )

    def wants(self, kind: str, chance: float | None = None) -> bool:
        """Whether to put in something optional: by `chance`, or as often as real rooms do."""
        drawn = self.random.random()
        if kind in self.require:
            return True
        if self.allow is not None and kind not in self.allow:
            return False
        if chance is None:
            chance = object_type(kind).rooms[ROOM_KINDS.index(self.kind)] / 30
        return drawn < chance * self.plenty

    def add(
        self, kind: str, box: Box, yaw: float = 0.0, *, parent: str = "", part_of: str = ""
    ) -> SceneObject:
        """Add an object; `part_of` names the sink or tub it is the basin of."""
        box = Box(_rounded(box.center), _rounded(box.size))
        thing = _make(kind, box, yaw, parent)
        if part_of:
            thing = _renamed(thing, f"{part_of}|{kind}")
        while thing.id in self.things:
            x, y, z = thing.position
            thing = replace(thing, position=_rounded(Vector(x + 0.01, y, z)))
            thing = _renamed(thing, _ident(kind, thing.position))
        self.things[thing.id] = thing
        if parent:
            holder = self.things[parent]
            self.things[parent] = replace(holder, contents=(*(holder.contents or ()), thing.id))
        return thing

    def stand(self, kind: str, box: Box, yaw: float = 0.0) -> SceneObject:
        """Add a piece of furniture on the floor."""
        self.bodies.append(footprint(box))
        return self.add(kind, box, yaw, parent=self.floor)

    def remove(self, name: str) -> None:
        """Take an object out again."""
        for parent in self.things[name].parents:
            holder = self.things[parent]
            left = tuple(each for each in holder.contents or () if each != name)
            self.things[parent] = replace(holder, contents=left)
        del self.things[name]
        self.controls.pop(name, None)

    def change(self, name: str, **states: Any) -> None:
        """Give an object other initial states."""
        self.things[name] = replace(self.things[name], **states)

    def reserve(self, area: Footprint) -> None:
        """Keep some floor free."""
        self.passages.append(area)

    def clear(self, area: Footprint) -> bool:
        """Whether furniture may stand there."""
        if not _within(area, self.width, self.depth):
            return False
        return not any(area.meets(other, 0.01) for other in (*self.bodies, *self.passages))

    def along_wall(
        self,
        extent: Vector,
        *,
        walls: Iterable[Wall] | None = None,
        passage: float = PASSAGE,
        gap: float = 0.03,
        corner: bool = False,
    ) -> tuple[Wall, float] | None:
        """Find a place against a wall where something fits, with its passage, if there is one.

        The passage is kept free from then on; `corner` prefers corners to the middle of walls.
        """
        places = []
        for wall in walls if walls is not None else self.walls:
            room = (wall.length - extent.x) / 2 - 0.03
            steps = int(room * 2 / 0.1)
            for step in range(max(0, steps) + 1):
                along = -room + step * 0.1
                edge = room - abs(along)
                rank = edge if corner else 0.0
                places.append((round(rank, 1), self.random.random(), wall, along))
        for _, _, wall, along in sorted(places, key=lambda place: place[:2]):
            body = footprint(wall.box(along, extent, gap=gap))
            front = footprint(wall.box(along, extent._replace(z=passage), gap=gap + extent.z))
            if self.clear(body) and not any(front.meets(each, 0.01) for each in self.bodies):
                if passage:
                    self.reserve(front)
                return wall, along
        return None

    def in_the_open(self, extent: Vector, margin: float) -> Box | None:
        """Find a place for something away from the walls, with `margin` metres all round."""
        width, height, depth = extent
        places = []
        for column in range(int((self.width - width - 2 * margin) / 0.1) + 1):
            for row in range(int((self.depth - depth - 2 * margin) / 0.1) + 1):
                x = -self.width / 2 + margin + width / 2 + column * 0.1
                z = -self.depth / 2 + margin + depth / 2 + row * 0.1
                places.append((self.random.random(), x, z))
        for _, x, z in sorted(places):
            box = Box(Vector(x, height / 2, z), extent)
            area = footprint(box)
            around = area.grown(margin)
            if self.clear(area) and not any(around.meets(each) for each in self.bodies):
                return box
        return None

    def free_wall(self, wall: Wall, along: float, extent: Vector, low: float) -> bool:
        """Whether nothing hangs or stands at that place on a wall."""
        if abs(along) + extent.x / 2 > wall.length / 2 - 0.05:
            return False
        (x, y, z), (width, height, depth) = wall.box(along, extent, low=low)
        for other in self.things.values():
            (a, b, c), (w, h, d) = other.box
            if (
                abs(x - a) * 2 < width + w
                and abs(y - b) * 2 < height + h
                and abs(z - c) * 2 < depth + d
            ):
                return False
        return True


def _make(kind: str, box: Box, yaw: float, parent: str) -> SceneObject:
    of_kind = object_type(kind)
    position = _rounded(Vector(box.center.x, bottom(box), box.center.z))
    ident = _ident(kind, position)
    traits: dict[str, Any] = {trait: trait in of_kind.traits for trait in TRAITS[1:]}
    return SceneObject(
        id=ident,
        type=kind,
        name=name_of(ident),
        position=position,
        yaw=yaw,
        box=box,
        parents=(parent,) if parent else (),
        contents=() if "receptacle" in of_kind.traits else None,
        open=of_kind.opens_by_default,
        on=of_kind.on_by_default,
        **traits,
    )


def _ident(kind: str, position: Vector) -> str:
    return "|".join((kind, *(f"{value + 0.0:+06.2f}" for value in position)))


def _renamed(thing: SceneObject, ident: str) -> SceneObject:
    return replace(thing, id=ident, name=name_of(ident))


def _rounded(point: Vector) -> Vector:
    return Vector(*(round(value, 3) + 0.0 for value in point))


def _within(area: Footprint, width: float, depth: float) -> bool:
    return (
        area.left >= -width / 2
        and area.right <= width / 2
        and area.near >= -depth / 2
        and area.far <= depth / 2
    )
