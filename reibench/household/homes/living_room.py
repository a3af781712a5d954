"""Living rooms: seats about a coffee table, a television, a table to eat at, shelves, plants."""

from reibench.household.furnishing.common import Cramped
from reibench.household.geometry import footprint, top
from reibench.household.homes.site import Site, facing
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
from reibench.scene import Box, SceneObject, Vector

PLANT = Vector(0.36, 0.62, 0.33)
LAMP = Vector(0.42, 1.75, 0.42)


def furnish_living_room(site: Site) -> None:
    """Furnish a living room."""
    screen_wall, middle, chests = _television(site)
    sofa = _sofa(site, site.opposite(screen_wall), middle)
    table = _coffee_table(site, sofa)
    # Nothing stands between sofa and screen but the coffee table.
    apart = site.beside(screen_wall)[0].length - 3.2
    if apart > 0.2:
        site.reserve(footprint(_before(sofa, Vector(0.8, 1, apart / 2), 1.2)))
    add_door(site)
    _side_tables(site, sofa, chests)
    _lamp(site, sofa)
    _more_seats(site, sofa, table)
    _dining(site)
    for kind in ("Dresser", "Desk"):
        for _ in range(site.count(kind) - _standing(site, kind)):
            found = site.against_wall(kind, _deep(site, kind))
            if found and kind == "Dresser":
                chests.append(chest(found[0].box, found[0].yaw))
            elif found:
                chests.append(Chest(found[0].box, found[0].yaw, 0.56, 0.7))
    add_all_drawers(site, site.shuffled(chests), site.count("Drawer"))
    add_shelving(site, site.count("Shelf"), site.count("ShelvingUnit"))
    add_cupboards(site, site.count("Cabinet"))
    for kind in ("Ottoman", "Safe", "DogBed", "RoomDecor", "Stool", "GarbageCan"):
        stand_about(site, kind)
    add_windows(site, site.count("Window"))
    cover_windows(site)
    hang_all(site, "Painting", 1.35)
    hang_all(site, "Mirror", 1.2)
    for kind, extent in (("DeskLamp", Vector(0.28, 0.5, 0.28)), ("HousePlant", PLANT)):
        for _ in range(site.count(kind)):
            put_on(site, kind, extent, back=True)


def _standing(site: Site, kind: str) -> int:
    return sum(thing.type == kind for thing in site.things.values())


def _deep(site: Site, kind: str) -> Vector:
    drawn = site.extent(kind)
    return drawn._replace(z=min(drawn.z, 0.65))


def _television(site: Site) -> tuple[Wall, float, list[Chest]]:
    """Stand the television on what there is for it, or hang it; return where it is."""
    kind = next((each for each in ("TVStand", "Dresser") if site.count(each)), "")
    walls = sorted(site.walls, key=lambda wall: wall.length + 1.5 * site.random.random())
    wall = walls[-1] if site.random.random() < 0.6 else walls[0]
    middle = round(site.random.uniform(-0.18, 0.18) * wall.length, 1)
    drawn = site.extent("Television")
    screen = Vector(min(1.4, max(0.8, drawn.x)), min(0.85, max(0.6, drawn.y)), 0.14)
    chests = []
    if not kind:
        site.add("Television", wall.box(middle, screen, low=site.between(0.9, 1.2)), wall.yaw)
        site.reserve(footprint(wall.box(middle, Vector(screen.x, 1, 0.6))))
        return wall, middle, []
    for number in range(site.count("TVStand") if kind == "TVStand" else 1):
        extent = _stand_extent(site, kind, screen)
        if number:
            site.against_wall(kind, extent)
            continue
        box = wall.box(middle, extent, gap=0.03)
        stand = site.stand(kind, box, wall.yaw)
        site.reserve(footprint(wall.box(middle, Vector(extent.x, 1, 0.65), gap=extent.z)))
        above = wall.box(middle, screen, low=extent.y, gap=0.06)
        site.add("Television", above, wall.yaw, parent=stand.id)
        chests.append(chest(box, wall.yaw))
    return wall, middle, chests


def _stand_extent(site: Site, kind: str, screen: Vector) -> Vector:
    drawn = site.extent(kind)
    high = min(drawn.y, 0.75) if kind == "TVStand" else min(drawn.y, 1.0)
    return Vector(max(screen.x, min(drawn.x, 2.0)), high, min(0.6, max(0.42, drawn.z)))


def _sofa(site: Site, wall: Wall, middle: float) -> SceneObject:
    """Stand the first sofa so that it faces the screen: at the wall or out in the room."""
    drawn = site.extent("Sofa")
    extent = Vector(min(2.8, max(1.7, drawn.x)), 0.92, 0.95)
    across = site.beside(wall)[0].length
    spare = across - 0.6 - 2.0 - extent.z
    gap = site.between(0.9, min(spare, 3.0)) if spare > 1.4 and site.random.random() < 0.6 else 0.05
    edge = (wall.length - extent.x) / 2 - 0.1
    along = max(-edge, min(edge, middle))
    box = wall.box(along, extent, gap=gap)
    if not site.clear(footprint(box)):
        raise Cramped("sofa")
    return site.stand("Sofa", box, wall.yaw)


def _before(thing: SceneObject, extent: Vector, gap: float, off: float = 0.0) -> Box:
    """Return a box in front of a thing, `off` metres to a side, as broad as said along it."""
    (x, _, z), (width, _, depth) = thing.box
    size = facing(extent, thing.yaw)
    deep = depth if thing.yaw in (0, 180) else width
    out = deep / 2 + gap + extent.z / 2
    shift = {0: (off, out), 180: (off, -out), 90: (out, off), 270: (-out, off)}[int(thing.yaw)]
    return Box(Vector(x + shift[0], extent.y / 2, z + shift[1]), size)


def _coffee_table(site: Site, sofa: SceneObject) -> SceneObject | None:
    first = None
    for number in range(site.count("CoffeeTable")):
        drawn = site.extent("CoffeeTable")
        extent = Vector(min(1.3, drawn.x), drawn.y, min(0.7, drawn.z))
        if number:
            site.against_wall("CoffeeTable", extent, passage=0.5)
            continue
        box = _before(sofa, extent, site.between(0.35, 0.5), site.between(-0.2, 0.2))
        first = site.stand_at("CoffeeTable", box, sofa.yaw)
        if first is None:
            raise Cramped("coffee table")
    return first


def _side_tables(site: Site, sofa: SceneObject, chests: list[Chest]) -> None:
    """Stand small tables at the ends of the sofa, and what is left along the walls."""
    long = max(sofa.box.size.x, sofa.box.size.z)
    left = site.count("SideTable")
    for side in site.shuffled((-1, 1)):
        if not left or site.random.random() < 0.2:
            continue
        drawn = site.extent("SideTable")
        wide = min(0.55, drawn.x)
        extent = Vector(wide, min(0.7, drawn.y), min(0.5, drawn.z))
        deep = sofa.box.size.z if sofa.yaw in (0, 180) else sofa.box.size.x
        off = side * (long / 2 + 0.05 + wide / 2)
        box = _before(sofa, extent, -deep * 0.75, off)
        table = site.stand_at("SideTable", box, sofa.yaw)
        if table is not None:
            left -= 1
            site.reserve(footprint(_before(table, Vector(wide, 1, 0.4), 0.02)))
            chests.append(Chest(table.box, table.yaw, top(table.box) - 0.35, top(table.box) - 0.03))
    for _ in range(left):
        extent = site.extent("SideTable")
        found = site.against_wall("SideTable", extent, corner=site.random.random() < 0.4)
        if found is not None:
            chests.append(chest(found[0].box, found[0].yaw, legs=0.2))


def _lamp(site: Site, sofa: SceneObject) -> None:
    """Stand a floor lamp beside the sofa, or in a corner."""
    long = max(sofa.box.size.x, sofa.box.size.z)
    beside = site.random.random() < 0.8
    for side in site.shuffled((-1, 1)):
        # Farther off there is a small table between.
        for off in (0.26, 0.85):
            box = _before(sofa, LAMP, -0.9, side * (long / 2 + off))
            if beside and site.stand_at("FloorLamp", box, sofa.yaw):
                return
    if site.against_wall("FloorLamp", LAMP, passage=0.2, corner=True) is None:
        raise Cramped("floor lamp")


def _more_seats(site: Site, sofa: SceneObject, table: SceneObject | None) -> None:
    """Stand further sofas and the arm chairs about the coffee table, or along the walls."""
    places = []
    center = table.box if table else _before(sofa, Vector(1.0, 0.4, 0.6), 0.4)
    long = 0 if sofa.yaw in (0, 180) else 2
    for side in (-1, 1):
        reach = center.size[long] / 2 + 0.4
        turn = {0: 90.0, 2: 0.0}[long] if side < 0 else {0: 270.0, 2: 180.0}[long]
        places.append((side, reach, turn))
    kinds = ["Sofa"] * (site.count("Sofa") - 1) + ["ArmChair"] * site.count("ArmChair")
    free = site.shuffled(places)
    for kind in kinds:
        drawn = site.extent(kind)
        extent = (
            Vector(min(2.0, drawn.x), 0.9, 0.92)
            if kind == "Sofa"
            else Vector(min(0.95, drawn.x), drawn.y, min(0.9, drawn.z))
        )
        if free and site.random.random() < 0.85:
            side, reach, turn = free.pop()
            at = list(center.center)
            at[long] += side * (reach + extent.z / 2)
            at[1] = extent.y / 2
            if site.stand_at(kind, Box(Vector(*at), facing(extent, turn)), turn, spare=0.04):
                continue
        site.against_wall(kind, extent, passage=0.45, corner=site.random.random() < 0.5)


def _dining(site: Site) -> None:
    """Stand tables to eat at where there is room, with the chairs; the rest along the walls."""
    chairs = site.count("Chair")
    site.keep_passages()
    for _ in range(site.count("DiningTable")):
        drawn = site.extent("DiningTable")
        extent = Vector(min(2.0, drawn.x), min(0.8, drawn.y), min(1.0, drawn.z))
        for size in site.shuffled((extent, Vector(extent.z, extent.y, extent.x))):
            box = site.in_the_open(size, 0.65)
            if box is not None:
                site.stand("DiningTable", box)
                break
        else:
            found = site.against_wall("DiningTable", extent, passage=0.7, turned=True)
            box = found[0].box if found else None
        if box is not None:
            chairs -= seat(site, "Chair", box, chairs)
    for desk in [each for each in site.things.values() if each.type == "Desk"]:
        chairs -= seat(site, "Chair", desk.box, min(1, chairs))
    stand_about(site, "Chair", chairs, passage=0.3)
