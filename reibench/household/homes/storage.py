"""Storage: drawers, cabinets and shelves, divided among the furniture that has them."""

from dataclasses import dataclass

from reibench.household.furnishing.common import add_drawers
from reibench.household.geometry import bottom, footprint, top
from reibench.household.homes.site import Site, facing
from reibench.household.layout import Wall
from reibench.scene import Box, Vector

DRAWER = 0.36
"""Least width of one of several drawers side by side."""
ROW = 0.13
"""Least height of one of several drawers over each other."""


@dataclass(frozen=True)
class Chest:
    """A piece of furniture that drawers can be let into."""

    box: Box
    yaw: float
    low: float
    high: float
    """Height of its drawers' lower and upper ends."""

    @property
    def most(self) -> tuple[int, int]:
        """How many fit side by side and over each other."""
        (_, _, _), (width, _, depth) = self.box
        breadth = width if self.yaw in (0, 180) else depth
        across = max(1, min(4, int(breadth / DRAWER)))
        return across, max(1, min(5, int((self.high - self.low) / ROW)))


def chest(box: Box, yaw: float, *, legs: float = 0.06) -> Chest:
    """Return what of a piece of furniture drawers fill: all but its legs and its top."""
    return Chest(box, yaw, bottom(box) + legs, top(box) - 0.02)


def add_all_drawers(site: Site, chests: list[Chest], wanted: int) -> None:
    """Divide drawers among chests, and build a further chest for what is left over."""
    left = wanted
    for number, each in enumerate(chests):
        fair = max(1, round(left / (len(chests) - number)))
        left -= _fill(site, each, min(left, fair))
    spare = 4
    while left > 0 and spare:
        spare -= 1
        built = _built_chest(site, left)
        if built is None:
            return
        left -= _fill(site, built, left)


def _fill(site: Site, each: Chest, wanted: int) -> int:
    """Let up to so many drawers into a chest and return how many they were."""
    across, rows = each.most
    options = [(a * r, r, a) for a in range(1, across + 1) for r in range(1, rows + 1)]
    fitting = [option for option in options if option[0] <= wanted]
    if not fitting:
        return 0
    most = max(fitting)[0]
    count, rows, across = site.random.choice([one for one in fitting if one[0] == most])
    # Low rows would make drawers like coffins; leave the rest to doors nobody opens.
    low = max(each.low, each.high - rows * 0.34)
    add_drawers(site, each.box, each.yaw, rows, low=low, high=each.high, across=across)
    return count


def _built_chest(site: Site, drawers: int) -> Chest | None:
    width = 0.5 if drawers <= 3 else 1.0 if drawers <= 8 else 1.5
    extent = Vector(width, site.between(0.7, 1.0), 0.46)
    found = site.along_wall(extent, gap=0.02)
    if found is None:
        site.miss("Drawer")
        return None
    wall, along = found
    box = wall.box(along, extent, gap=0.02)
    site.bodies.append(footprint(box))
    return chest(box, wall.yaw)


def add_shelving(site: Site, wanted: int, units: int) -> None:
    """Put shelves into shelving units, into a bookcase, or hang them on a wall."""
    left = wanted
    for number in range(units):
        left -= _unit(site, max(0, min(6, round(left / (units - number)))))
    while left > 0:
        made = _boards(site, left) if left <= 3 and site.random.random() < 0.7 else 0
        made = made or _bookcase(site, left)
        if not made:
            site.miss("Shelf")
            return
        left -= made


def _unit(site: Site, levels: int) -> int:
    extent = site.extent("ShelvingUnit")
    found = site.against_wall("ShelvingUnit", extent, corner=site.random.random() < 0.6)
    if found is None:
        return 0
    _, wall, along = found
    _levels(site, wall, along, extent, levels)
    return levels


def _levels(site: Site, wall: Wall, along: float, body: Vector, levels: int) -> None:
    for level in range(levels):
        height = body.y / levels
        extent = Vector(body.x - 0.06, min(0.26, height - 0.04), body.z - 0.02)
        box = wall.box(along, extent, low=level * height + 0.03, gap=0.04)
        site.add("Shelf", box, wall.yaw)


def _bookcase(site: Site, wanted: int) -> int:
    """Build a bookcase into a wall: columns of shelves that are no object of their own."""
    levels = min(wanted, 5)
    columns = max(1, min(3, wanted // levels))
    for wide in range(columns, 0, -1):
        one = site.extent("Shelf").x
        one = min(0.9, max(0.45, one))
        extent = Vector(wide * one, levels * site.between(0.36, 0.44), 0.34)
        found = site.along_wall(extent, gap=0.02, corner=site.random.random() < 0.5)
        if found is None:
            continue
        wall, along = found
        site.bodies.append(footprint(wall.box(along, extent, gap=0.02)))
        for column in range(wide):
            off = (column - (wide - 1) / 2) * one
            _levels(site, wall, along + off, Vector(one, extent.y, extent.z), levels)
        return wide * levels
    return 0


def _boards(site: Site, wanted: int) -> int:
    """Hang boards over each other."""
    levels = min(3, wanted)
    extent = site.extent("Shelf")
    extent = Vector(min(1.2, extent.x), 0.22, min(0.28, extent.z))
    low = site.between(1.0, 1.3)
    space = Vector(extent.x, levels * 0.4, extent.z)
    for wall in site.shuffled(site.walls):
        room = (wall.length - extent.x) / 2 - 0.1
        for step in site.shuffled(range(int(2 * room / 0.1) + 1 if room > 0 else 0)):
            along = -room + step * 0.1
            if site.free_wall(wall, along, space, low):
                for level in range(levels):
                    box = wall.box(along, extent, low=low + level * 0.4, gap=0.01)
                    site.add("Shelf", box, wall.yaw)
                return levels
    return 0


def add_cupboards(site: Site, wanted: int) -> None:
    """Stand cupboards of one or two doors along the walls, where no counter has them."""
    left = wanted
    while left > 0:
        doors = 2 if left > 1 else 1
        one = min(0.6, max(0.4, site.extent("Cabinet").x))
        height = site.random.choice((0.8, 1.0, 1.8))
        extent = Vector(doors * one, height, site.random.choice((0.45, 0.55)))
        found = site.along_wall(extent, gap=0.02, corner=True)
        if found is None:
            site.miss("Cabinet")
            return
        wall, along = found
        box = wall.box(along, extent, gap=0.02)
        site.bodies.append(footprint(box))
        for door in range(doors):
            off = (door - (doors - 1) / 2) * one
            front = Vector(one - 0.02, extent.y - 0.06, extent.z)
            site.add("Cabinet", wall.box(along + off, front, low=0.04, gap=0.02), wall.yaw)
        left -= doors


def seat(site: Site, kind: str, table: Box, wanted: int, tucked: float = 0.2) -> int:
    """Push seats under the sides of a table, where there is room, and return how many."""
    extent = site.extent(kind)
    side = min(0.58, extent.x)
    (x, _, z), (width, _, depth) = table
    places: list[tuple[float, float, float, float]] = []
    sides = (
        (180.0, width, depth),
        (0.0, width, depth),
        (270.0, depth, width),
        (90.0, depth, width),
    )
    for yaw, length, out in sides:
        count = max(1, int(length / 0.6))
        sign = 1 if yaw in (180, 270) else -1
        away = sign * (out / 2 + side / 2 - tucked)
        for number in range(count):
            off = (number + 0.5) / count * length - length / 2
            at = (x + off, z + away) if yaw in (0, 180) else (x + away, z + off)
            # Long sides are sat at first.
            places.append((-length + site.random.random() * 0.5, *at, yaw))
    made = 0
    for _, a, b, yaw in sorted(places):
        if made == wanted:
            break
        box = Box(Vector(a, extent.y / 2, b), facing(Vector(side, extent.y, side), yaw))
        if site.roomy(box, table):
            site.stand(kind, box, yaw)
            made += 1
    return made
