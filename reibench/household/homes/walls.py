"""Doors, windows, curtains, pictures and mirrors; and whatever stands somewhere along the walls."""

from collections.abc import Sequence

from reibench.household.furnishing.common import Cramped
from reibench.household.geometry import bottom, footprint, top
from reibench.household.homes.site import Site, overlap
from reibench.household.layout import Wall
from reibench.scene import SceneObject, Vector

DOOR = Vector(0.9, 2.05, 0.9)
"""Width and height of the doorway, and how much floor before it stays free."""
SWITCH = Vector(0.12, 0.15, 0.03)
LOOSE = {
    "GarbageBag": Vector(0.45, 0.55, 0.42),
    "HousePlant": Vector(0.4, 0.9, 0.4),
    "VacuumCleaner": Vector(0.4, 1.0, 0.4),
}
"""Sizes where the boxes of turned instances say too much."""


def add_door(site: Site, walls: Sequence[Wall] | None = None) -> None:
    """Leave a doorway free, near a corner, with the light switch beside it."""
    choices = site.shuffled(walls if walls is not None else site.walls)
    found = site.along_wall(DOOR, walls=choices, passage=0, gap=0, corner=True)
    if found is None:
        raise Cramped("no doorway")
    wall, along = found
    site.reserve(footprint(wall.box(along, DOOR)))
    site.doorways.append(wall.box(along, DOOR._replace(z=0.3)))
    side = -1 if along > 0 else 1
    for beside in (side * 0.6, -side * 0.6, side * 0.75, side * 0.9, side * 1.2):
        if site.free_wall(wall, along + beside, SWITCH, 1.25):
            site.add("LightSwitch", wall.box(along + beside, SWITCH, low=1.25), wall.yaw)
            # Somebody has to get at the switch.
            site.reserve(footprint(wall.box(along + beside, Vector(0.2, 1, 0.5))))
            return
    raise Cramped("no light switch")


def hang(
    site: Site,
    kind: str,
    extent: Vector,
    low: float,
    *,
    space: Vector | None = None,
    walls: Sequence[Wall] | None = None,
    near: float | None = None,
) -> tuple[Wall, float] | None:
    """Hang something on a free piece of wall; None where there is none.

    Args:
        site: the room.
        kind: its type.
        extent: its width, height and thickness.
        low: height of its lower side.
        space: how much has to be free, from its upper side down, if more than itsite.
        walls: those that come into question; None for all.
        near: the place along the wall it should be close to; None for the middle.
    """
    needed = space or extent
    places = []
    for wall in walls if walls is not None else site.walls:
        room = (wall.length - needed.x) / 2 - 0.06
        for step in range(int(2 * room / 0.1) + 1 if room > 0 else 0):
            along = -room + step * 0.1
            rank = abs(along - (near or 0.0)) / (1.0 if near is None else 0.2)
            places.append((rank + site.random.random(), wall, along))
    for _, wall, along in sorted(places, key=lambda place: place[0]):
        if site.free_wall(wall, along, needed, low + extent.y - needed.y):
            site.add(kind, wall.box(along, extent, low=low), wall.yaw)
            return wall, along
    return None


def add_windows(site: Site, count: int) -> None:
    """Put windows into free pieces of wall."""
    for _ in range(count):
        drawn = site.extent("Window")
        window = Vector(min(1.6, drawn.x), min(1.6, drawn.y), 0.1)
        wide = Vector(window.x + 0.1, window.y, 0.3)
        for low in (0.9, 1.25):
            fits = window._replace(y=min(window.y, 2.4 - low))
            space = wide._replace(y=fits.y)
            if hang(site, "Window", fits, low, space=space) is not None:
                break
        else:
            site.miss("Window")


def cover_windows(site: Site) -> None:
    """Hang blinds and curtains before windows."""
    windows = [thing for thing in site.things.values() if thing.type == "Window"]
    for kind in ("Blinds", "Curtains"):
        for window in site.shuffled(windows)[: site.count(kind)]:
            _cover(site, kind, window)


def _cover(site: Site, kind: str, window: SceneObject) -> None:
    wall = next(wall for wall in site.walls if wall.yaw == window.yaw)
    (x, _, z), size = window.box
    along = x if wall.yaw in (0, 180) else z
    wide = max(size.x, size.z)
    if kind == "Blinds":
        extent = Vector(min(wide, site.extent(kind).x), 0.2, 0.03)
        site.add(kind, wall.box(along, extent, low=top(window.box) - 0.15, gap=0.07), wall.yaw)
        return
    # Down to the floor where nothing stands before the window, else to its sill.
    reach = 2 * (wall.length / 2 - abs(along))
    long = Vector(min(max(wide + 0.5, site.extent(kind).x), reach), 2.36, 0.14)
    others = [each.box for each in site.things.values() if each.type == kind]
    if any(overlap(wall.box(along, long), other) for other in others):
        long = long._replace(x=wide)
    free = site.clear_of_bodies(footprint(wall.box(along, long)))
    low = 0.1 if free else bottom(window.box) - 0.1
    extent = long._replace(y=2.46 - low)
    site.add(kind, wall.box(along, extent, low=low, gap=0.07), wall.yaw)


def hang_all(site: Site, kind: str, low: float, *, most: float = 1.4) -> None:
    """Hang all pictures or mirrors of a type."""
    for _ in range(site.count(kind)):
        drawn = site.extent(kind)
        extent = Vector(min(most, drawn.x), min(1.1, drawn.y), 0.07)
        if hang(site, kind, extent, min(low, 2.4 - extent.y)) is None:
            site.miss(kind)


def stand_about(site: Site, kind: str, count: int | None = None, *, passage: float = 0.35) -> None:
    """Stand pieces of furniture along the walls; as many as the room is to have if None."""
    for _ in range(site.count(kind) if count is None else count):
        extent = LOOSE.get(kind) or site.extent(kind)
        corner = site.random.random() < 0.6
        site.against_wall(kind, extent, passage=passage, corner=corner, turned=True)
