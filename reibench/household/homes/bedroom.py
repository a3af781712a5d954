"""Bedrooms: beds with night stands, a desk, places for clothes, shelves and pictures."""

from reibench.household.furnishing.common import Cramped
from reibench.household.geometry import footprint, top
from reibench.household.homes.site import Site
from reibench.household.homes.storage import (
    Chest,
    add_all_drawers,
    add_cupboards,
    add_shelving,
    chest,
    seat,
)
from reibench.household.homes.things import put_on
from reibench.household.homes.walls import (
    add_door,
    add_windows,
    cover_windows,
    hang_all,
    stand_about,
)
from reibench.household.layout import Wall
from reibench.scene import Vector

LOOSE = (
    "ArmChair LaundryHamper Safe GarbageBag VacuumCleaner DogBed Footstool Stool Sofa CoffeeTable"
    " GarbageCan"
).split()
"""What stands somewhere along the walls."""


def furnish_bedroom(site: Site) -> None:
    """Furnish a bedroom."""
    chests: list[Chest] = []
    _beds(site, chests)
    add_door(site)
    _desks(site, chests)
    for _ in range(site.count("Dresser")):
        drawn = site.extent("Dresser")
        extent = drawn._replace(z=min(drawn.z, 0.6))
        found = site.against_wall("Dresser", extent)
        if found is not None:
            chests.append(chest(found[0].box, found[0].yaw))
    _counter(site)
    add_all_drawers(site, site.shuffled(chests), site.count("Drawer"))
    add_shelving(site, site.count("Shelf"), site.count("ShelvingUnit"))
    add_cupboards(site, site.count("Cabinet"))
    for kind in LOOSE:
        stand_about(site, kind)
    _adorn(site)


def _adorn(site: Site) -> None:
    add_windows(site, site.count("Window"))
    cover_windows(site)
    hang_all(site, "Mirror", 1.1)
    hang_all(site, "Painting", 1.4)
    hang_all(site, "Poster", 1.3, most=0.8)
    for kind, extent in (
        ("Television", Vector(0.95, 0.65, 0.16)),
        ("Desktop", Vector(0.6, 0.5, 0.24)),
        ("DeskLamp", Vector(0.26, 0.42, 0.26)),
        ("HousePlant", Vector(0.32, 0.6, 0.3)),
    ):
        placed = [put_on(site, kind, extent, back=True) for _ in range(site.count(kind))]
        if kind == "DeskLamp" and not any(placed):
            # Things are to be looked at in its light.
            raise Cramped(kind)


def _beds(site: Site, chests: list[Chest]) -> None:
    """Stand the beds with their heads at a wall, in its middle or in a corner, side by side."""
    count, stands = site.count("Bed"), site.count("SideTable")
    drawn = site.extent("Bed")
    wide = min(drawn.z, 1.1) if count > 1 else max(0.95, min(drawn.z, 1.9))
    extent = Vector(wide, drawn.y, min(2.25, drawn.x))
    together = count * wide + (count - 1) * 0.75
    walls = [
        wall
        for wall in site.walls
        if wall.length > together + 0.2 and site.beside(wall)[0].length > extent.z + 0.9
    ]
    if not walls:
        raise Cramped("bed")
    wall = site.random.choice(walls)
    edge = (wall.length - together) / 2 - 0.05
    cornered = count == 1 and wide < 1.5 and site.random.random() < 0.5
    middle = site.random.choice((-edge, edge)) if cornered else edge * site.between(-0.4, 0.4)
    for number in range(count):
        along = middle - together / 2 + wide / 2 + number * (wide + 0.75)
        site.stand("Bed", wall.box(along, extent, gap=0.03), wall.yaw)
    ends = [middle - together / 2, middle + together / 2]
    if count > 1:
        ends = [middle, *ends]
    _night_stands(site, wall, ends, middle, stands, chests)
    # Getting out of it on one side is enough.
    side = -1 if middle > 0 else 1
    free = Vector(0.6, 1, extent.z - 0.5)
    aside = middle + side * (together / 2 + 0.3)
    site.reserve(footprint(wall.box(aside, free, gap=0.5)))


def _night_stands(
    site: Site, wall: Wall, ends: list[float], middle: float, count: int, chests: list[Chest]
) -> None:
    for end in ends if len(ends) > 2 else site.shuffled(ends):
        if not count:
            return
        drawn = site.extent("SideTable")
        wide = min(0.6, drawn.x)
        extent = Vector(wide, min(0.75, drawn.y), min(0.48, drawn.z))
        side = 0.0 if end == middle else 1.0 if end > middle else -1.0
        box = wall.box(end + side * (0.05 + wide / 2), extent, gap=0.03)
        stand = site.stand_at("SideTable", box, wall.yaw)
        if stand is not None:
            count -= 1
            chests.append(Chest(box, wall.yaw, 0.12, top(box) - 0.03))
    for _ in range(count):
        found = site.against_wall("SideTable", site.extent("SideTable"), corner=True)
        if found is not None:
            chests.append(chest(found[0].box, found[0].yaw, legs=0.2))


def _desks(site: Site, chests: list[Chest]) -> None:
    chairs = site.count("Chair")
    site.keep_passages()
    for _ in range(site.count("Desk")):
        drawn = site.extent("Desk")
        extent = Vector(min(1.9, drawn.x), 0.77, min(0.75, drawn.z))
        found = site.against_wall("Desk", extent, passage=0.75, corner=site.random.random() < 0.4)
        if found is None:
            continue
        desk, wall, along = found
        side = site.random.choice((-1, 1))
        if site.random.random() < 0.6:
            off = along + side * (extent.x / 2 - 0.22)
            pedestal = wall.box(off, Vector(0.4, 0.72, extent.z - 0.05), gap=0.04)
            chests.append(Chest(pedestal, wall.yaw, 0.08, 0.72))
        else:
            chests.append(Chest(desk.box, wall.yaw, 0.58, 0.74))
        chairs -= seat(site, "Chair", desk.box, min(chairs, 1))
    stand_about(site, "Chair", chairs, passage=0.3)


def _counter(site: Site) -> None:
    """Build a counter into the few bedrooms that have one."""
    for _ in range(site.count("CounterTop")):
        extent = Vector(1.5, 0.86, 0.6)
        found = site.along_wall(extent, gap=0.0)
        if found is None:
            site.miss("CounterTop")
            return
        wall, along = found
        site.bodies.append(footprint(wall.box(along, extent)))
        site.add("CounterTop", wall.box(along, extent._replace(y=0.03), low=0.83), wall.yaw)
