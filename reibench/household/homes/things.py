"""Small things: put where real rooms have them, and in the states they are in there."""

from collections.abc import Mapping

from reibench.household.geometry import Footprint, bottom, footprint, forward, top
from reibench.household.habits import real_rooms
from reibench.household.homes.site import Site, facing, overlap
from reibench.household.layout import Wall
from reibench.household.objects import object_type, object_types
from reibench.household.placement import Rank, free_spot, nearest_to
from reibench.scene import CONTAINERS, Box, SceneObject, Vector

TRIES = 8
_BOX, _PAN = Vector(0.5, 0.3, 0.46), Vector(0.42, 0.2, 0.3)
_PLATE, _CUP = Vector(0.27, 0.1, 0.27), Vector(0.13, 0.15, 0.13)
SPARE = {
    **dict.fromkeys(("CoffeeTable", "DiningTable", "Bed", "Sofa"), _BOX),
    **dict.fromkeys(("CounterTop", "Desk", "Dresser"), _PAN),
    **dict.fromkeys(("TVStand", "SinkBasin", "ArmChair", "Toilet"), _PLATE),
    **dict.fromkeys(("SideTable", "Shelf"), _CUP),
}
"""What is kept free on receptacles, so that things can be put down there."""
ON_RIM = frozenset(("Candle", "SoapBar", "SoapBottle", "ToiletPaper", "TissueBox", "DishSponge"))
"""What stands on the rim of a tub rather than lies in it."""
SOLID = frozenset(
    "Cabinet CoffeeMachine DeskLamp Desktop Faucet Fridge HousePlant Microwave Mirror Painting"
    " Poster Shelf Television Toaster".split()
)
"""What else stands on or over receptacles and takes up room there."""
STANDING = frozenset(("HousePlant",))
"""What stands on the floor where it stands on nothing AI2-THOR names; other things hang."""
UPRIGHT = {"BaseballBat": Vector(0.12, 0.85, 0.12), "TennisRacket": Vector(0.28, 0.62, 0.12)}
"""What leans at the wall in most rooms and lies in some: no middle describes it."""
STANDING_PARTS = frozenset(
    "Cabinet Drawer Shelf Curtains ShowerCurtain ShowerDoor ShowerGlass".split()
)
"""Parts AI2-THOR counts among what is on the floor, in some rooms, if they reach down to it."""
OVERLAPS = (("ShowerCurtain", "Bathtub"), ("Faucet", "CounterTop"), ("Sink", "CounterTop"))
"""Types of which AI2-THOR says in some rooms that one is in or on the other, as it reaches in."""


def add_things(site: Site) -> None:
    """Put in all small things the room is to have."""
    kinds = [
        name
        for name, each in object_types().items()
        if "pickupable" in each.traits and site.count(name)
    ]
    for name in sorted(kinds, key=lambda name: (-max(_natural(site, name)), name)):
        for _ in range(site.count(name)):
            if not put_on(site, name, _natural(site, name)):
                site.miss(name)


def put_on(site: Site, kind: str, extent: Vector, *, back: bool = False) -> bool:
    """Put something on what real ones stand on; `back` puts it as far back as it goes."""
    full: set[str] = set()
    closed = {thing.id for thing in site.things.values() if thing.type in CONTAINERS}
    for number in range(4 * TRIES):
        receptacle = _draw_receptacle(site, kind, full)
        if receptacle is None:
            if not closed & full:
                return False
            full -= closed
            closed = set()
            continue
        if not number and receptacle.id not in closed:
            # What finds no room in the open is not put away for that, unless it has to be.
            full |= closed
        if receptacle.type == "Floor":
            if _lay_on_floor(site, kind, extent):
                return True
        elif any(_put_in(site, kind, extent, receptacle, back) for _ in range(TRIES)):
            return True
        full.add(receptacle.id)
    return False


def settle(site: Site) -> None:
    """Give everything the states real ones are in, and list what reaches down to the floor."""
    _set_states(site)
    for kind in sorted(STANDING_PARTS):
        ours = sorted(_of_type(site, kind), key=lambda thing: bottom(thing.box))
        for thing in ours[: round(site.chance(kind, "Floor") * len(ours))]:
            if bottom(thing.box) < 0.45:
                site.place_in(thing.id, site.floor)
    for kind, over in OVERLAPS:
        for thing in _of_type(site, kind):
            area = footprint(thing.box)
            below = [one for one in _of_type(site, over) if footprint(one.box).meets(area)]
            if below and site.random.random() < site.chance(kind, over):
                site.place_in(thing.id, below[0].id)


def _set_states(site: Site) -> None:
    types, levels = real_rooms()[site.kind].types, site.inventory.levels
    seen: set[str] = set()
    for thing in list(site.things.values()):
        shares = types[thing.type].states if thing.type in types else {}
        # The first of each type is what the rooms differ in by plan, the others by chance.
        first = thing.type not in seen
        seen.add(thing.type)
        states = {
            state: (levels[f"{thing.type} {state}"] if first else site.random.random()) >= 1 - share
            for state, share in shares.items()
        }
        site.change(thing.id, **states)
        if states.get("filled"):
            site.change(thing.id, liquid="wine")
        if any(parent.startswith("Fridge") for parent in thing.parents):
            site.change(thing.id, temperature="Cold")


def _of_type(site: Site, kind: str) -> list[SceneObject]:
    return [thing for thing in site.things.values() if thing.type == kind]


def _natural(site: Site, name: str) -> Vector:
    extent = UPRIGHT.get(name) or site.extent(name)
    return extent if site.random.random() < 0.5 else Vector(extent.z, extent.y, extent.x)


def _draw_receptacle(site: Site, kind: str, full: set[str]) -> SceneObject | None:
    """Draw a receptacle of the room, as often as real instances lie on one of its type."""
    each = real_rooms()[site.kind].types.get(kind)
    found = dict(each.found_on) if each else dict(object_type(kind).found_on)
    nowhere = found.pop("", 0)
    if kind in STANDING:
        found["Floor"] = found.get("Floor", 0) + nowhere
    for whole in ("Sink", "Bathtub"):
        if whole in found and not (whole == "Bathtub" and kind in ON_RIM):
            found[f"{whole}Basin"] = found.pop(whole)
    present: dict[str, list[SceneObject]] = {}
    for thing in site.things.values():
        if thing.receptacle and thing.id not in full:
            present.setdefault(thing.type, []).append(thing)
    kind_of_place = _draw_place(site, kind, found, sorted(present))
    if not kind_of_place:
        return None
    of_type = present[kind_of_place]
    sizes = [max(0.2, thing.box.size.x * thing.box.size.z) for thing in of_type]
    return site.random.choices(of_type, sizes)[0]


def _draw_place(site: Site, kind: str, found: Mapping[str, int], present: list[str]) -> str:
    """Draw a type of receptacle out of those a room has.

    Real rooms with a desk have nearly everything on it: what counts is how often a thing lies on
    a type where there is one. The rarer types come first, the commonest takes what is left.
    """
    types = real_rooms()[site.kind].types
    total = sum(found.values())
    shares = {name: types[name].share for name in present if found.get(name) and name in types}
    drawn, passed = site.random.random(), 0.0
    for name in sorted(shares, key=lambda name: (shares[name], name)):
        passed += found[name] / total / shares[name]
        if drawn < passed:
            return name
    if shares:
        return max(shares, key=lambda name: (found[name], name))
    fitting = [name for name in present if object_type(kind).may_go(name) and name != "Floor"]
    fitting = [name for name in fitting if name in _LIKELY]
    return site.random.choice(fitting) if fitting else ""


_LIKELY = frozenset(
    "CounterTop DiningTable Desk Dresser Shelf SideTable CoffeeTable TVStand Bed Sofa Fridge"
    " Cabinet Drawer".split()
)


def _put_in(site: Site, kind: str, extent: Vector, receptacle: SceneObject, back: bool) -> bool:
    if receptacle.type == "Bathtub":
        return _put_on_rim(site, kind, extent, receptacle)
    area = footprint(receptacle.box)
    near = (site.random.uniform(area.left, area.right), site.random.uniform(area.near, area.far))
    if back:
        extent = facing(extent, receptacle.yaw)
    middle = Vector(0, 0, 0)
    probe = SceneObject("", kind, "", middle, 0.0, Box(middle, extent))
    behind = back or (kind == "Pillow" and site.random.random() < 0.7)
    rank = _farthest_back(receptacle, near) if behind else nearest_to(*near)
    spot = free_spot(site.things, probe, site.things[receptacle.id], rank)
    if spot is None or not site.within_reach(footprint(Box(*spot))):
        return False
    if _in_the_way(site, Box(*spot), receptacle):
        return False
    yaw = receptacle.yaw if back else 0.0
    added = site.add(kind, Box(*spot), yaw, parent=receptacle.id)
    worked_on = receptacle.type in ("CounterTop", "DiningTable")
    if (back and not worked_on) or _has_room(site, receptacle):
        return True
    site.remove(added.id)
    return False


def _in_the_way(site: Site, box: Box, receptacle: SceneObject) -> bool:
    """Whether something that stands on another receptacle takes up part of a place."""
    inside = (receptacle.id, *receptacle.parents)
    return any(
        (other.pickupable or other.type in SOLID)
        and other.id not in inside
        and overlap(box, other.box)
        for other in site.things.values()
    )


def _has_room(site: Site, receptacle: SceneObject) -> bool:
    """Whether one more thing still finds room there: a room is to be worked in."""
    # A counter round a wash basin has room for little else.
    narrow = site.kind == "bathroom" and receptacle.type == "CounterTop"
    extent = _CUP if narrow else SPARE.get(receptacle.type)
    if extent is None:
        return True
    probe = SceneObject("", "Plate", "", extent, 0.0, Box(Vector(0, 0, 0), extent))
    middle = receptacle.box.center
    rank = nearest_to(middle.x, middle.z)
    return free_spot(site.things, probe, site.things[receptacle.id], rank) is not None


def _farthest_back(receptacle: SceneObject, near: tuple[float, float]) -> Rank:
    ahead_x, ahead_z = forward(receptacle.yaw)
    return lambda x, z: 10 * (x * ahead_x + z * ahead_z) + abs(x - near[0]) + abs(z - near[1])


def _put_on_rim(site: Site, kind: str, extent: Vector, tub: SceneObject) -> bool:
    wall = next(wall for wall in site.walls if wall.yaw == tub.yaw)
    long = max(tub.box.size.x, tub.box.size.z)
    middle = tub.box.center.x if wall.yaw in (0, 180) else tub.box.center.z
    along = middle + site.random.uniform(-0.4, 0.4) * long
    lying = Vector(max(extent.x, extent.z), extent.y, min(extent.x, extent.z))
    box = wall.box(along, lying, low=top(tub.box), gap=0.04)
    taken = (footprint(site.things[name].box) for name in site.things[tub.id].contents or ())
    if any(footprint(box).meets(each) for each in taken):
        return False
    if not site.within_reach(footprint(box)):
        return False
    site.add(kind, box, parent=tub.id)
    return True


def _lay_on_floor(site: Site, kind: str, extent: Vector) -> bool:
    """Lay something on the floor by a wall, out of the way."""
    places: list[tuple[float, Wall, float]] = []
    for wall in site.walls:
        room = (wall.length - extent.x) / 2 - 0.05
        for step in range(max(0, int(2 * room / 0.1)) + 1):
            along = -room + step * 0.1
            places.append((site.random.random() + 0.5 * (room - abs(along)), wall, along))
    for _, wall, along in sorted(places, key=lambda place: place[0]):
        box = wall.box(along, extent, gap=0.04)
        area: Footprint = footprint(box)
        if site.clear(area) and site.within_reach(area):
            site.stand(kind, box, wall.yaw)
            return True
    return False
