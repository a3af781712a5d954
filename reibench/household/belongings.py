"""Small things: which a room has, and where they lie at first."""

from collections.abc import Iterable, Mapping

from reibench.household.geometry import footprint, forward
from reibench.household.layout import Draft
from reibench.household.objects import ROOM_KINDS, ObjectType, object_type, object_types
from reibench.household.placement import free_spot, nearest_to
from reibench.scene import Box, SceneObject, Vector

NATURAL = {
    "Book": Vector(0.19, 0.03, 0.26),
    "BaseballBat": Vector(0.12, 0.85, 0.12),
    "Box": Vector(0.42, 0.26, 0.34),
    "ButterKnife": Vector(0.02, 0.01, 0.22),
    "CD": Vector(0.12, 0.002, 0.12),
    "CreditCard": Vector(0.086, 0.002, 0.054),
    "CellPhone": Vector(0.08, 0.01, 0.15),
    "HandTowel": Vector(0.17, 0.35, 0.05),
    "Knife": Vector(0.04, 0.02, 0.3),
    "Ladle": Vector(0.09, 0.06, 0.28),
    "Laptop": Vector(0.34, 0.24, 0.26),
    "Pan": Vector(0.26, 0.05, 0.38),
    "Pen": Vector(0.02, 0.01, 0.15),
    "Pot": Vector(0.28, 0.16, 0.26),
    "RemoteControl": Vector(0.06, 0.02, 0.18),
    "Spatula": Vector(0.08, 0.02, 0.3),
    "TennisRacket": Vector(0.28, 0.62, 0.1),
    "Watch": Vector(0.07, 0.04, 0.06),
}
"""Extents where the table's medians, taken over turned instances, would be misshapen."""

OFTEN_SEVERAL = {"Pillow": 2, "Statue": 2, "Vase": 2, "ToiletPaper": 2}
"""Types that real rooms usually have more than one of."""

CLOSED_PLACES = ("Cabinet", "Drawer", "Fridge")

UNLIKELY = frozenset(
    "Bathtub BathtubBasin Bowl Floor Chair CoffeeMachine Cup Footstool GarbageCan Microwave Mug Pan"
    " Plate Pot Safe SinkBasin Stool Toaster Box LaundryHamper".split()
)
"""Receptacles nobody keeps things in, unless real rooms were found to."""


def add_belongings(draft: Draft, where: Mapping[str, str]) -> None:
    """Put in the required small things, and others as often as real rooms have them.

    `where` says for some types what kind of receptacle they start in or on.
    """
    wanted = [name for name in _portable(draft.kind) if draft.wants(name)]
    wanted += [name for name in draft.require if _is_portable(name) and name not in wanted]
    where = dict(where) or _one_put_away(draft, wanted)
    for name in sorted(wanted, key=lambda name: (-_bulk(name), name)):
        count = OFTEN_SEVERAL.get(name, 1) if draft.random.random() < 0.6 else 1
        for _ in range(count):
            put(draft, name, where.get(name, ""))


def put(draft: Draft, name: str, receptacle_type: str = "") -> bool:
    """Put a thing where things like it are kept; False if there is no room for it."""
    kind = object_type(name)
    extent = NATURAL.get(name, kind.size)
    if draft.random.random() < 0.5:
        extent = Vector(extent.z, extent.y, extent.x)
    while (receptacle := _choose(draft, kind, receptacle_type)) is not None:
        if _put_in(draft, kind, extent, receptacle):
            return True
        draft.full.add((name, receptacle.id))
    return False


def _one_put_away(draft: Draft, names: list[str]) -> dict[str, str]:
    """Choose one thing to start inside something closed, so that looking about is not enough."""
    closed = {thing.type for thing in draft.things.values() if thing.type in CLOSED_PLACES}
    choices = [
        (name, place)
        for name in sorted(names)
        for place in sorted(closed)
        if object_type(name).may_go(place)
    ]
    return dict([draft.random.choice(choices)]) if choices else {}


def spare_portables(kind: str) -> list[str]:
    """Return the small types a kind of room usually has, for filling it up."""
    common = [name for name in _portable(kind) if object_type(name).rooms[_row(kind)] >= 10]
    return common or _portable(kind)


def _put_in(draft: Draft, kind: ObjectType, extent: Vector, receptacle: SceneObject) -> bool:
    area = footprint(receptacle.box)
    near = (
        draft.random.uniform(area.left, area.right),
        draft.random.uniform(area.near, area.far),
    )
    if kind.name == "Pillow":
        ahead_x, ahead_z = forward(receptacle.yaw)
        near = (near[0] - 2 * ahead_x, near[1] - 2 * ahead_z)
    probe = _probe(kind, extent)
    if receptacle.type == "Floor":
        return _lay_on_floor(draft, kind, extent)
    spot = free_spot(draft.things, probe, receptacle, nearest_to(*near))
    if spot is None:
        return False
    draft.add(kind.name, Box(*spot), parent=receptacle.id)
    return True


def _lay_on_floor(draft: Draft, kind: ObjectType, extent: Vector) -> bool:
    """Lay something on the floor by a wall, out of the way."""
    found = draft.along_wall(extent, passage=0, gap=0.04, corner=True)
    if found is None:
        return False
    wall, along = found
    draft.stand(kind.name, wall.box(along, extent, gap=0.04), wall.yaw)
    return True


def _probe(kind: ObjectType, extent: Vector) -> SceneObject:
    middle = Vector(0, 0, 0)
    return SceneObject("", kind.name, "", middle, 0.0, Box(middle, extent))


def _choose(draft: Draft, kind: ObjectType, receptacle_type: str) -> SceneObject | None:
    """Draw a receptacle of the room, by where real instances were found."""
    found = dict(kind.found_on)
    for whole in ("Sink", "Bathtub"):
        if whole in found:
            found[f"{whole}Basin"] = found.get(f"{whole}Basin", 0) + found.pop(whole)
    if kind.thor_receptacles:
        # Real rooms have keys and pillows on the floor where they fell off something.
        found = {name: count for name, count in found.items() if kind.may_go(name)}
    present: dict[str, list[SceneObject]] = {}
    for thing in draft.things.values():
        fits = thing.receptacle and (kind.name, thing.id) not in draft.full
        if fits and (not receptacle_type or thing.type == receptacle_type):
            present.setdefault(thing.type, []).append(thing)
    weights = {
        name: float(found.get(name, 0)) + _liking(kind, name)
        for name in present
        if receptacle_type or found.get(name) or kind.may_go(name)
    }
    names = [name for name, weight in weights.items() if weight or receptacle_type]
    if not names:
        return None
    drawn = draft.random.choices(names, [weights[name] or 1.0 for name in names])[0]
    return draft.random.choice(present[drawn])


def _liking(kind: ObjectType, receptacle: str) -> float:
    return 0.0 if receptacle in UNLIKELY or not kind.may_go(receptacle) else 0.5


def _portable(kind: str) -> list[str]:
    row = _row(kind)
    return [each.name for each in object_types().values() if each.rooms[row] and _carried(each)]


def _row(kind: str) -> int:
    return ROOM_KINDS.index(kind)


def _is_portable(name: str) -> bool:
    return _carried(object_type(name))


def _carried(kind: ObjectType) -> bool:
    return "pickupable" in kind.traits


def _bulk(name: str) -> float:
    """Order big things first: they find room more easily then."""
    extent: Iterable[float] = NATURAL.get(name, object_type(name).size)
    return max(extent)
