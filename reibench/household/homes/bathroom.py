"""Bathrooms: one or two wash basins, a toilet, a tub or a shower or both, towels on the walls."""

from typing import NamedTuple

from reibench.household.furnishing.common import Cramped
from reibench.household.geometry import footprint
from reibench.household.homes.site import Site
from reibench.household.homes.storage import Chest, add_all_drawers, add_cupboards, add_shelving
from reibench.household.homes.things import put_on
from reibench.household.homes.walls import (
    add_door,
    add_windows,
    cover_windows,
    hang,
    hang_all,
    stand_about,
)
from reibench.household.layout import Wall
from reibench.scene import Vector

TOP, DEPTH = 0.84, 0.56
"""Of the counter around a basin."""
BASIN = 0.66
"""Metres of counter a wash basin takes."""


class Bathing(NamedTuple):
    """What a bathroom has to bathe in."""

    tub: int
    curtain: int
    door: int
    glass: int
    head: int


WAYS = (
    *[Bathing(0, 0, 1, 0, 1)] * 2,
    *[Bathing(0, 0, 1, 1, 1)] * 6,
    *[Bathing(1, 0, 1, 1, 1)] * 4,
    *[Bathing(1, 1, 1, 1, 1)] * 2,
    *[Bathing(1, 0, 1, 0, 1)] * 2,
    *[Bathing(1, 0, 0, 0, 0)] * 2,
    *[Bathing(1, 1, 0, 0, 0)] * 4,
    *[Bathing(1, 1, 0, 0, 1)] * 7,
)
"""How tubs and showers go together in the real bathrooms, as often as they do."""
TUB_TAPS = 0.76
"""The share of tubs with taps of their own."""


def furnish_bathroom(site: Site) -> None:
    """Furnish a bathroom."""
    way = WAYS[int(site.inventory.levels["Bathtub"] * len(WAYS))]
    if way.door:
        _shower(site, way)
    if way.tub:
        _tub(site, way)
    chests = _wash_basins(site)
    add_door(site)
    _toilet(site)
    for kind in ("Dresser", "SideTable", "Footstool", "GarbageCan"):
        stand_about(site, kind, passage=0.3)
    left = site.count("Drawer")
    add_all_drawers(site, chests, left)
    _towels(site)
    add_shelving(site, site.count("Shelf"), 0)
    add_windows(site, site.count("Window"))
    cover_windows(site)
    hang_all(site, "Painting", 1.4)
    for _ in range(site.count("HousePlant")):
        put_on(site, "HousePlant", Vector(0.3, 0.6, 0.3), back=True)


def _tub(site: Site, way: Bathing) -> None:
    extent = Vector(site.between(1.75, 2.2), 0.6, site.between(0.85, 1.2))
    found = site.along_wall(extent, passage=0.55, gap=0.02, corner=site.random.random() < 0.85)
    if found is None:
        raise Cramped("tub")
    wall, along = found
    tub = site.stand("Bathtub", wall.box(along, extent, gap=0.02), wall.yaw)
    inner = Vector(extent.x - 0.22, 0.42, extent.z - 0.22)
    box = wall.box(along, inner, low=0.13, gap=0.13)
    site.add("BathtubBasin", box, wall.yaw, part_of=tub.id)
    end = (1 if along > 0 else -1) * (extent.x / 2 - 0.1)
    if site.random.random() < TUB_TAPS:
        tap = wall.box(along + end, Vector(0.14, 0.2, 0.2), low=0.58, gap=0.35)
        site.add("Faucet", tap, wall.yaw)
    if way.head and not way.door:
        head = wall.box(along + end, Vector(0.2, 1.2, 0.25), low=0.95, gap=0.28)
        site.add("ShowerHead", head, wall.yaw)
    if way.curtain:
        # Drawn aside, at the far end of the tub's front.
        cloth = Vector(0.42, 1.92, 0.12)
        box = wall.box(along - end * 0.75, cloth, low=0.15, gap=extent.z - 0.1)
        site.add("ShowerCurtain", box, wall.yaw)


def _shower(site: Site, way: Bathing) -> None:
    side = site.between(0.9, 1.4)
    extent = Vector(side, 0.1, site.between(0.9, 1.4))
    found = site.along_wall(extent, passage=0.6, gap=0.0, corner=True)
    if found is None:
        raise Cramped("shower")
    wall, along = found
    site.bodies.append(footprint(wall.box(along, extent)))
    door = wall.box(along, Vector(side - 0.04, 1.95, 0.05), low=0.03, gap=extent.z - 0.03)
    site.add("ShowerDoor", door, wall.yaw)
    if way.glass:
        inward = -1 if along > 0 else 1
        pane = Vector(0.05, 1.95, extent.z - 0.06)
        box = wall.box(along + inward * (side / 2 - 0.025), pane, low=0.03, gap=0.02)
        site.add("ShowerGlass", box, wall.yaw)
    head = wall.box(along, Vector(0.2, 1.2, 0.28), low=0.95, gap=0.02)
    site.add("ShowerHead", head, wall.yaw)


def _wash_basins(site: Site) -> list[Chest]:
    """Let the basins into counters, or hang them on the wall; return where drawers may go."""
    basins, counters = site.count("Sink"), site.count("CounterTop")
    mirrors = site.count("Mirror")
    chests: list[Chest] = []
    doors = site.count("Cabinet")
    for number in range(max(1, counters)):
        here = basins if number == max(1, counters) - 1 else 1 if basins > 1 else 0
        if number and not here:
            here = basins
        basins -= here
        wide = here * BASIN + (site.between(0.35, 1.0) if counters else 0.0)
        wide = max(wide, 0.9) if counters else wide
        found = _counter(site, wide, bool(counters))
        if found is None:
            raise Cramped("wash basin")
        wall, along, wide = found
        for each in range(here):
            off = (each - (here - 1) / 2) * max(BASIN, wide / max(here, 1) * 0.8)
            _basin(site, wall, along + (off if here > 1 else 0.0), bool(counters))
        if mirrors and here:
            mirrors -= 1
            mirror = Vector(max(0.5, wide - 0.1), site.between(0.75, 1.0), 0.04)
            site.add("Mirror", wall.box(along, mirror, low=1.12), wall.yaw)
        if counters:
            doors -= _fronts(site, wall, along, wide, doors, chests)
    add_cupboards(site, max(0, doors))
    for _ in range(mirrors):
        hang(site, "Mirror", Vector(0.5, 0.9, 0.04), 1.1)
    return chests


def _counter(site: Site, wide: float, fitted: bool) -> tuple[Wall, float, float] | None:
    extent = Vector(wide, TOP, DEPTH)
    while (found := site.along_wall(extent, passage=0.65, gap=0.0)) is None:
        if extent.x < 0.95 or not fitted:
            return None
        extent = extent._replace(x=extent.x - 0.2)
    wall, along = found
    site.bodies.append(footprint(wall.box(along, extent)))
    if fitted:
        slab = wall.box(along, extent._replace(y=0.03), low=TOP - 0.03)
        site.add("CounterTop", slab, wall.yaw)
    return wall, along, extent.x


def _basin(site: Site, wall: Wall, along: float, fitted: bool) -> None:
    extent = Vector(site.between(0.52, 0.62), 0.18 if fitted else 0.24, 0.44)
    outer = wall.box(along, extent, low=TOP - extent.y + 0.03, gap=0.06)
    sink = site.add("Sink", outer, wall.yaw)
    inner = wall.box(along, Vector(0.46, 0.14, 0.31), low=TOP - 0.12, gap=0.15)
    site.add("SinkBasin", inner, wall.yaw, part_of=sink.id)
    tap = wall.box(along, Vector(0.3, 0.2, 0.16), low=TOP + 0.03, gap=0.02)
    site.add("Faucet", tap, wall.yaw)


def _fronts(
    site: Site, wall: Wall, along: float, wide: float, doors: int, chests: list[Chest]
) -> int:
    """Put doors and drawers under a counter, and return how many doors."""
    count = min(doors, max(1, int(wide / 0.3)), 4)
    drawers = site.count("Drawer") > 0
    share = 0.5 if count and drawers else 1.0
    if drawers:
        body = wall.box(
            along - wide * (0.5 - share / 2) if count else along,
            Vector(wide * share, 0.7, DEPTH - 0.05),
            low=0.1,
        )
        chests.append(Chest(body, wall.yaw, 0.1, 0.66))
    left = along if share == 1.0 else along + wide / 4
    for number in range(count):
        one = wide * share / count
        off = ((number + 0.5) / count - 0.5) * wide * share
        front = Vector(one - 0.02, 0.56, DEPTH - 0.05)
        site.add("Cabinet", wall.box(left + off, front, low=0.1), wall.yaw)
    return count


def _toilet(site: Site) -> None:
    extent = Vector(0.52, 1.03, site.between(0.78, 0.95))
    found = site.along_wall(extent, passage=0.6, gap=0.02)
    if found is None:
        raise Cramped("toilet")
    wall, along = found
    site.stand("Toilet", wall.box(along, extent, gap=0.02), wall.yaw)
    holder = Vector(0.2, 0.1, 0.1)
    for side in site.shuffled((0.42, -0.42, 0.5, -0.5)):
        if site.free_wall(wall, along + side, holder, 0.75):
            box = wall.box(along + side, holder, low=0.75)
            site.add("ToiletPaperHanger", box, wall.yaw)
            site.reserve(footprint(box))
            return
    raise Cramped("paper hanger")


def _towels(site: Site) -> None:
    for kind, extent, low in (
        ("TowelHolder", Vector(0.66, 0.04, 0.1), 1.35),
        ("HandTowelHolder", Vector(0.18, 0.2, 0.06), 1.5),
    ):
        for _ in range(site.count(kind)):
            towel = Vector(extent.x + 0.06, 0.65, 0.14)
            if hang(site, kind, extent, low, space=towel) is None:
                raise Cramped(kind)
