"""A home being furnished: a draft that knows what it is to hold and how large things are."""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import TypeVar

from reibench.household.floor import WalkableFloor
from reibench.household.furnishing.common import Cramped
from reibench.household.geometry import Footprint, footprint
from reibench.household.habits import Inventory, extent_of, real_rooms
from reibench.household.layout import CEILING, PASSAGE, Draft, Wall
from reibench.scene import Box, SceneObject, Vector

Item = TypeVar("Item")

NEAR = 0.95
"""Metres from where the robot can stand within which small things lie."""


@dataclass(kw_only=True)
class Site(Draft):
    """A room being furnished as real ones are."""

    inventory: Inventory
    lenient: bool = False
    """Whether what finds no place is left out; otherwise another layout is tried."""
    doorways: list[Box] = field(default_factory=list)
    walkable: tuple[Vector, ...] = ()
    kept: int = 0
    """How many of the passages seats keep clear of too."""

    def count(self, kind: str) -> int:
        """Return how many of a type the room is to have."""
        return self.inventory.count(kind)

    def extent(self, kind: str) -> Vector:
        """Draw how long, high and deep something is."""
        drawn = extent_of(self.kind, kind, self.random)
        return Vector(*(max(0.01, round(side, 2)) for side in drawn))

    def chance(self, kind: str, place: str) -> float:
        """Return how often real things of a type lie on that type of receptacle."""
        statistics = real_rooms()[self.kind].types.get(kind)
        if statistics is None:
            return 0.0
        return statistics.found_on.get(place, 0) / sum(statistics.found_on.values())

    def miss(self, kind: str) -> None:
        """Take note that something found no place; raises Cramped unless lenient."""
        if not self.lenient:
            raise Cramped(kind)

    def between(self, low: float, high: float) -> float:
        """Draw a length in metres, to the centimetre."""
        return round(self.random.uniform(low, high), 2)

    def shuffled(self, items: Iterable[Item]) -> list[Item]:
        """Return the items in a random order."""
        made = list(items)
        self.random.shuffle(made)
        return made

    def opposite(self, wall: Wall) -> Wall:
        """Return the wall across the room."""
        return next(one for one in self.walls if one.yaw == (wall.yaw + 180) % 360)

    def beside(self, wall: Wall) -> tuple[Wall, Wall]:
        """Return the walls at the lower and the upper end of a wall."""
        back, front, left, right = self.walls
        return (left, right) if wall.yaw in (0, 180) else (front, back)

    def free_wall(self, wall: Wall, along: float, extent: Vector, low: float) -> bool:
        """Whether nothing hangs or stands at that place on a wall, and no door is there."""
        if not super().free_wall(wall, along, extent, low):
            return False
        box = wall.box(along, extent, low=low)
        return not any(overlap(box, doorway) for doorway in self.doorways)

    def against_wall(
        self,
        kind: str,
        extent: Vector,
        *,
        passage: float = PASSAGE,
        corner: bool = False,
        walls: Iterable[Wall] | None = None,
        turned: bool = False,
    ) -> tuple[SceneObject, Wall, float] | None:
        """Stand something against a wall where there is room; None where there is none.

        `turned` lets it stand with its short side to the wall if it has to.
        """
        choices = self.shuffled(walls if walls is not None else self.walls)
        for size in (extent, *([Vector(extent.z, extent.y, extent.x)] if turned else [])):
            found = self.along_wall(size, walls=choices, passage=passage, corner=corner)
            if found is not None:
                wall, along = found
                return self.stand(kind, wall.box(along, size, gap=0.03), wall.yaw), wall, along
        self.miss(kind)
        return None

    def stand_at(self, kind: str, box: Box, yaw: float, spare: float = 0.0) -> SceneObject | None:
        """Stand something at a place if that is free, with so much margin; None if not."""
        if not self.clear(footprint(box)):
            return None
        around = footprint(box).grown(spare)
        if any(around.meets(each) for each in self.bodies):
            return None
        return self.stand(kind, box, yaw)

    def roomy(self, seat: Box, table: Box) -> bool:
        """Whether a seat has room where it stands, but for the table it is pushed under."""
        area, under = footprint(seat), footprint(table)
        if abs(area.x) + seat.size.x / 2 > self.width / 2:
            return False
        if abs(area.z) + seat.size.z / 2 > self.depth / 2:
            return False
        others = [each for each in self.bodies if each[:4] != under[:4]]
        return not any(area.meets(each) for each in others + self.passages[: self.kept])

    def clear_of_bodies(self, area: Footprint) -> bool:
        """Whether no furniture stands there."""
        return not any(area.meets(each) for each in self.bodies)

    def place_in(self, name: str, receptacle: str) -> None:
        """List a thing among what a receptacle holds, where it is already."""
        order = list(self.things)
        thing, holder = self.things[name], self.things[receptacle]
        self.things[name] = replace(thing, parents=(*thing.parents, receptacle))
        held = sorted((*(holder.contents or ()), name), key=order.index)
        self.things[receptacle] = replace(holder, contents=tuple(held))

    def walk(self) -> None:
        """Find out where the robot can walk, with the furniture there is by now."""
        bounds = Box(Vector(0.0, CEILING / 2, 0.0), Vector(self.width, CEILING, self.depth))
        self.walkable = WalkableFloor(bounds, self.things.values(), None).points

    def within_reach(self, area: Footprint) -> bool:
        """Whether the robot can stand near enough; anything is near, before it walked."""
        return not self.walkable or any(
            area.distance(point.x, point.z) <= NEAR for point in self.walkable
        )

    def keep_passages(self) -> None:
        """Let no seat stand in any passage there is by now."""
        self.kept = len(self.passages)


def turned(extent: Vector) -> Vector:
    """Return an extent with width and depth exchanged."""
    return Vector(extent.z, extent.y, extent.x)


def facing(extent: Vector, yaw: float) -> Vector:
    """Return width, height and depth as x, y, z of something that faces `yaw`."""
    return extent if yaw in (0, 180) else turned(extent)


def overlap(one: Box, other: Box) -> bool:
    """Whether two boxes have room in common."""
    return all(
        abs(one.center[axis] - other.center[axis]) * 2 < one.size[axis] + other.size[axis]
        for axis in range(3)
    )
