"""Kitchens: counters, a place to eat where there is room for one, and what stands about."""

from reibench.household.furnishing.common import Cramped
from reibench.household.homes.counters import (
    DEPTH,
    TOP,
    Counters,
    Slot,
    arrange,
    build,
)
from reibench.household.homes.site import Site
from reibench.household.homes.storage import add_shelving, seat
from reibench.household.homes.things import put_on
from reibench.household.homes.units import HUNG, fill_units
from reibench.household.homes.walls import (
    add_door,
    add_windows,
    cover_windows,
    hang_all,
    stand_about,
)
from reibench.scene import Box, Vector

APPLIANCES = {"Microwave": (0.6, 0.34, 0.37), "CoffeeMachine": (0.4, 0.42, 0.36),
              "Toaster": (0.34, 0.21, 0.22)}  # fmt: skip
"""Width, height and depth; real boxes of turned ones are larger than they are."""


def furnish_kitchen(site: Site) -> None:
    """Furnish a kitchen."""
    counters = arrange(site)
    build(site, counters)
    add_door(site)
    windows = site.count("Window")
    for slot in counters.slots:
        if slot.module == "sink":
            _sink(site, slot)
            windows -= windows > 0 and _window_above(site, slot)
        elif slot.module == "range":
            _cooker(site, slot)
    mounted = _mount_microwave(site, counters)
    fill_units(site, counters)
    _eating_places(site)
    for kind in ("SideTable", "Safe", "GarbageCan", "GarbageBag"):
        stand_about(site, kind)
    add_shelving(site, site.count("Shelf"), site.count("ShelvingUnit"))
    add_windows(site, windows)
    cover_windows(site)
    hang_all(site, "Mirror", 1.3)
    for kind, extent in APPLIANCES.items():
        if kind != "Microwave" or not mounted:
            _appliance(site, kind, Vector(*extent))
    for _ in range(site.count("HousePlant")):
        put_on(site, "HousePlant", Vector(0.38, 0.6, 0.33), back=True)


def _sink(site: Site, slot: Slot) -> None:
    extent = Vector(site.between(0.66, 0.8), 0.18, 0.46)
    sink = site.add(
        "Sink", slot.wall.box(slot.along, extent, low=TOP - 0.16, gap=0.1), slot.wall.yaw
    )
    inner = Vector(extent.x - 0.12, 0.14, 0.37)
    basin = slot.wall.box(slot.along, inner, low=TOP - 0.14, gap=0.15)
    site.add("SinkBasin", basin, slot.wall.yaw, part_of=sink.id)
    taps = site.count("Faucet")
    for number in range(taps):
        off = (number - (taps - 1) / 2) * 0.3
        box = slot.wall.box(slot.along + off, Vector(0.18, 0.26, 0.2), low=TOP, gap=0.02)
        site.add("Faucet", box, slot.wall.yaw)


def _window_above(site: Site, slot: Slot) -> bool:
    drawn = site.extent("Window")
    window = Vector(min(1.2, drawn.x), min(1.15, drawn.y), 0.06)
    if site.random.random() > 0.7 or not site.free_wall(slot.wall, slot.along, window, 1.25):
        return False
    site.add("Window", slot.wall.box(slot.along, window, low=1.25), slot.wall.yaw)
    return True


def _cooker(site: Site, slot: Slot) -> None:
    """Put burners into the cooker's top, two deep, and a knob for each along its front."""
    number = max(4, site.count("StoveBurner"))
    across = -(-number // 2)
    for each in range(number):
        off = (each % across - (across - 1) / 2) * 0.29
        gap = 0.36 if each < across else 0.08
        extent = Vector(0.22, 0.02, 0.22)
        burner = slot.wall.box(slot.along + off, extent, low=TOP, gap=gap)
        named = site.add("StoveBurner", burner, slot.wall.yaw).id
        turn = (each - (number - 1) / 2) * 0.13
        box = slot.wall.box(slot.along + turn, Vector(0.06, 0.06, 0.04), low=TOP - 0.1, gap=DEPTH)
        site.controls[site.add("StoveKnob", box, slot.wall.yaw).id] = (named,)


def _mount_microwave(site: Site, counters: Counters) -> bool:
    """Hang the microwave over the stove, as often as real ones stand on nothing."""
    if site.random.random() > site.chance("Microwave", ""):
        return False
    slot = next(slot for slot in counters.slots if slot.module == "range")
    extent = Vector(0.6, 0.36, 0.38)
    if not site.free_wall(slot.wall, slot.along, extent, HUNG - 0.05):
        return False
    site.add("Microwave", slot.wall.box(slot.along, extent, low=HUNG - 0.05), slot.wall.yaw)
    return True


def _appliance(site: Site, kind: str, extent: Vector) -> None:
    if not put_on(site, kind, extent, back=True):
        raise Cramped(kind)


def _eating_places(site: Site) -> None:
    """Put in the tables, chairs round them, and stools at what one can sit at."""
    chairs, stools = site.count("Chair"), site.count("Stool")
    site.keep_passages()
    tables: list[Box] = []
    for _ in range(site.count("DiningTable")):
        drawn = site.extent("DiningTable")
        extent = Vector(min(1.8, drawn.x), 0.78, min(0.95, drawn.z))
        sizes = site.shuffled((extent, Vector(extent.z, extent.y, extent.x)))
        box = next(filter(None, (site.in_the_open(size, 0.6) for size in sizes)), None)
        if box is not None and site.random.random() < 0.75:
            site.stand("DiningTable", box)
            tables.append(box)
        elif (
            found := site.against_wall("DiningTable", extent, passage=0.6, turned=True)
        ) is not None:
            tables.append(found[0].box)
    for box in tables:
        chairs -= seat(site, "Chair", box, chairs)
    islands = [
        Box(Vector(x, y / 2, z), Vector(width, y, depth))
        for (x, y, z), (width, _, depth) in (
            t.box for t in site.things.values() if t.type == "CounterTop"
        )
        if min(site.width / 2 - abs(x), site.depth / 2 - abs(z)) > 0.8
    ]
    for box in (*islands, *tables):
        stools -= seat(site, "Stool", box, stools, tucked=0.12)
    for kind, left in (("Chair", chairs), ("Stool", stools)):
        stand_about(site, kind, left, passage=0.3)
