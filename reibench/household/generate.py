"""Making rooms up: furniture along the walls, things in and on it, decided by a seed.

`python -m reibench.household.generate` writes the rooms that come with the project.
"""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from random import Random

from reibench.errors import InvalidRoom, unknown
from reibench.household.belongings import add_belongings, put, spare_portables
from reibench.household.floor import STANDING, WalkableFloor
from reibench.household.furnishing import FURNISHERS
from reibench.household.furnishing.common import Cramped
from reibench.household.furnishing.shelves import add_shelving
from reibench.household.geometry import footprint
from reibench.household.habits import Stratum
from reibench.household.homes import draft_home
from reibench.household.layout import CEILING, Draft
from reibench.household.objects import ROOM_KINDS, object_type
from reibench.household.plans import PLANS, Plan
from reibench.household.rooms import ROOMS, Room, save_room, with_contents
from reibench.household.state import hidden
from reibench.scene import Box, Pose, SceneObject, Vector

ATTEMPTS = 300
ARM = 1.0
"""Metres within which the robot must get to everything."""
EXTENTS = {
    "kitchen": ((3.9, 4.7), (3.6, 4.3)),
    "living room": ((4.6, 5.6), (4.2, 5.0)),
    "bedroom": ((3.7, 4.4), (3.6, 4.2)),
    "bathroom": ((3.2, 3.8), (2.9, 3.4)),
}
"""Least and greatest width and depth in metres."""


@dataclass(frozen=True)
class Wishes:
    """What a room is asked to be, beside its kind; `generate_room` says what each means."""

    require: frozenset[str]
    allow: frozenset[str] | None
    objects: int | None
    where: Mapping[str, str]


def generate_room(
    kind: str,
    seed: int,
    *,
    name: str,
    require: Collection[str] = (),
    objects: int | None = None,
    allow: Collection[str] | None = None,
    where: Mapping[str, str] | None = None,
) -> Room:
    """Make up a room; the same arguments give the same room.

    Args:
        kind: `kitchen`, `living room`, `bedroom` or `bathroom`.
        seed: decides everything left open.
        name: what the room will be called.
        require: types it must have.
        objects: about how many objects it should have; None for as many as real rooms.
        allow: small and optional types that may appear beside the required ones; None for any.
        where: for some types, the type of receptacle they start in or on.

    Raises:
        UnknownName: for a kind or type there is none of.
        InvalidRoom: when no room like that works out.
    """
    if kind not in ROOM_KINDS:
        raise unknown("kind of room", kind, ROOM_KINDS)
    for each in (*require, *(allow or ())):
        object_type(each)
    allowed = None if allow is None else frozenset(allow)
    wishes = Wishes(frozenset(require), allowed, objects, where or {})
    for attempt in range(ATTEMPTS):
        room = _try(kind, name, Random(f"{kind} {seed} {attempt}"), wishes)
        if room is not None:
            return room
    raise InvalidRoom(f"No {kind} with seed {seed} and all that is asked of it worked out.")


def generate_home(kind: str, seed: int, *, name: str, stratum: Stratum | None = None) -> Room:
    """Make up a room that is like real ones; the same arguments give the same room.

    Args:
        kind: `kitchen`, `living room`, `bedroom` or `bathroom`.
        seed: decides everything left open.
        name: what the room will be called.
        stratum: which of several rooms it is that together are to be like the real ones.

    Raises:
        UnknownName: for a kind there is none of.
        InvalidRoom: when no room like that works out.
    """
    if kind not in ROOM_KINDS:
        raise unknown("kind of room", kind, ROOM_KINDS)
    for attempt in range(ATTEMPTS):
        try:
            draft = draft_home(kind, seed, attempt, stratum)
        except Cramped:
            continue
        room = _finish(draft, name)
        if not shortcomings(room, hiding=False):
            return room
    raise InvalidRoom(f"No {kind} with seed {seed} worked out.")


def planned_room(name: str, plan: Plan) -> Room:
    """Make one of the rooms that come with the project."""
    if plan.stratum is not None:
        return generate_home(plan.kind, plan.seed, name=name, stratum=plan.stratum)
    return generate_room(
        plan.kind,
        plan.seed,
        name=name,
        require=plan.require,
        allow=plan.require if plan.closed else None,
        where=plan.where,
    )


def main() -> None:
    """Write the rooms that come with the project."""
    for name, plan in PLANS.items():
        save_room(planned_room(name, plan), ROOMS / f"{name}.json")


def shortcomings(room: Room, require: Collection[str] = (), *, hiding: bool = True) -> list[str]:
    """Say what is wrong with a room: what is missing, in the way or out of reach.

    `hiding` asks for something that is put away, which many a real room has not.
    """
    present = {thing.type for thing in room.objects}
    wrong = [f"no {name}" for name in sorted(set(require) - present)]
    if len(room.reachable) < 12:
        wrong.append("hardly any floor to walk on")
    if hiding and not any(inner.parents and hidden(room.by_id, inner) for inner in room.objects):
        wrong.append("nothing is put away")
    for thing in room.objects:
        used = thing.receptacle or thing.openable or thing.toggleable or thing.pickupable
        if used and not approachable(room, thing):
            wrong.append(f"{thing.id} is out of reach")
    return wrong


def approachable(room: Room, thing: SceneObject) -> bool:
    """Whether the robot can stand near enough to a thing."""
    area = footprint(thing.box)
    return any(area.distance(point.x, point.z) <= ARM for point in room.reachable)


def _try(kind: str, name: str, random: Random, wishes: Wishes) -> Room | None:
    """Make one attempt; None if the room has shortcomings."""
    draft = _empty_room(kind, random, wishes)
    try:
        FURNISHERS[kind](draft)
        _add_storage(draft)
    except Cramped:
        return None
    add_belongings(draft, wishes.where)
    if wishes.objects is not None:
        _fit_number(draft, wishes.objects)
    room = _finish(draft, name)
    return None if shortcomings(room, wishes.require) else room


def _empty_room(kind: str, random: Random, wishes: Wishes) -> Draft:
    (least, most), (shallow, deep) = EXTENTS[kind]
    plenty = 1.0 if wishes.objects is None else min(2.0, max(0.5, wishes.objects / 50))
    # Many objects need more room, but rooms grow slower than what is in them.
    stretch = max(1.0, plenty**0.4)
    width = round(random.uniform(least, most) * stretch, 1)
    depth = round(random.uniform(shallow, deep) * stretch, 1)
    return Draft(kind, random, width, depth, wishes.require, wishes.allow, plenty)


def _add_storage(draft: Draft) -> None:
    """Put in more shelves where a room has to hold more than usual."""
    for _ in range(int((draft.plenty - 1.0) * 4)):
        add_shelving(draft, 4)


def _fit_number(draft: Draft, objects: int) -> None:
    """Take out or put in small and spare things until there are about that many objects."""
    order = list(draft.things.values())
    draft.random.shuffle(order)
    for thing in sorted(order, key=_dispensable):
        if len(draft.things) <= objects:
            break
        needed = thing.type in draft.require or _dispensable(thing) > 5
        if not needed and not draft.things[thing.id].contents:
            draft.remove(thing.id)
    names = [name for name in spare_portables(draft.kind) if _may_appear(draft, name)]
    for _ in range(5 * objects):
        if len(draft.things) >= objects or not names:
            break
        name = draft.random.choice(names)
        if not put(draft, name):
            names.remove(name)


def _may_appear(draft: Draft, name: str) -> bool:
    return draft.allow is None or name in draft.allow or name in draft.require


def _dispensable(thing: SceneObject) -> int:
    """Return how soon a thing is left out of a small room; over 5 never."""
    if thing.type in ("Painting", "Poster", "Window", "Blinds", "Curtains", "Mirror"):
        return 0
    if thing.pickupable:
        return 1
    ranks = {"Chair": 2, "HousePlant": 2, "Shelf": 3, "Cabinet": 3, "Drawer": 4, "SideTable": 5}
    return ranks.get(thing.type, 9)


def _finish(draft: Draft, name: str) -> Room:
    bounds = Box(Vector(0.0, CEILING / 2, 0.0), Vector(draft.width, CEILING, draft.depth))
    things = with_contents(list(draft.things.values()))
    points = WalkableFloor(bounds, things, None).points or (Vector(0.0, STANDING, 0.0),)
    start = draft.random.choice(points)
    yaw = float(draft.random.choice((0, 90, 180, 270)))
    return Room(name, draft.kind, bounds, things, Pose(start, yaw), draft.controls)


if __name__ == "__main__":
    main()
