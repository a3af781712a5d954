"""Kitchen counters: in a line, round corners, along two walls or as an island; what is in them."""

from dataclasses import dataclass, field, replace
from itertools import pairwise

from reibench.household.furnishing.common import Cramped
from reibench.household.geometry import Footprint, footprint
from reibench.household.homes.site import Site
from reibench.household.layout import Wall
from reibench.scene import Box, Vector

DEPTH, TOP, SLAB = 0.7, 0.92, 0.03
"""Of a counter: how far it stands out, how high its top is, how thick."""
UNIT = 0.47
"""Usual width of a cabinet or a stack of drawers."""
SINK = 0.86
FRONT = 0.75
"""Metres kept free before a counter."""


@dataclass(frozen=True)
class Run:
    """A stretch of a wall with a counter before it."""

    wall: Wall
    begin: float
    end: float
    blind: tuple[bool, bool] = (False, False)
    """Whether another run begins at its ends, so that nobody gets at what is in the corner."""

    @property
    def usable(self) -> tuple[float, float]:
        """From where to where fronts are got at."""
        return self.begin + DEPTH * self.blind[0], self.end - DEPTH * self.blind[1]

    @property
    def length(self) -> float:
        """Metres of fronts."""
        low, high = self.usable
        return high - low


@dataclass(frozen=True)
class Slot:
    """One unit's place in a run."""

    wall: Wall
    along: float
    width: float
    module: str
    """`unit`, `sink` or `range`."""


@dataclass
class Counters:
    """A kitchen's counters while they are built."""

    runs: list[Run]
    island: bool
    split: bool
    """Whether the stove stands between two counters rather than in one."""
    slots: list[Slot] = field(default_factory=list)


ARRANGEMENTS = {
    1: (("line", False, False),),
    2: (("line", False, True), ("corner", False, False), ("line", True, False),
        ("galley", False, False)),
    3: (("corner", False, True), ("horseshoe", False, False), ("corner", True, False),
        ("galley", False, True), ("line", True, True)),
    4: (("horseshoe", False, True), ("corner", True, True), ("horseshoe", True, False)),
}  # fmt: skip
"""By number of counter tops: shape, with an island or not, parted by the stove or not."""
LEAST = {
    "line": (2.7, 1.9),
    "corner": (2.5, 2.5),
    "horseshoe": (3.0, 2.6),
    "galley": (2.4, 2.75),
}
"""Metres a shape takes along its main wall, and across the room."""
ISLAND = Vector(1.4, TOP, 0.75)


def arrange(site: Site) -> Counters:
    """Choose a shape the room is large enough for, and where its counters run."""
    options = []
    wanted = max(1, min(4, site.count("CounterTop")))
    for number in (wanted, *range(wanted - 1, 0, -1)):
        for shape, island, split in ARRANGEMENTS[number]:
            options += [(wall, shape, island, split) for wall in site.walls
                        if _large_enough(site, wall, shape, island)]  # fmt: skip
        if options:
            break
    if not options:
        raise Cramped("counters")
    wall, shape, island, split = site.random.choice(options)
    return Counters(_runs(site, wall, shape), island, split)


def _large_enough(site: Site, wall: Wall, shape: str, island: bool) -> bool:
    along, across = LEAST[shape]
    if island:
        along, across = max(along, 3.0), max(across, DEPTH + 2 * FRONT + ISLAND.z + 0.1)
    return wall.length >= along and site.beside(wall)[0].length >= across


def _runs(site: Site, wall: Wall, shape: str) -> list[Run]:
    half, across = wall.length / 2, site.beside(wall)[0].length
    if shape == "horseshoe":
        arms = [_arm(site, wall, end, across) for end in (0, 1)]
        return [Run(wall, -half, half, (True, True)), *arms]
    if shape == "corner":
        end = site.random.choice((0, 1))
        long = min(wall.length, site.between(3.2, 5.6))
        ends = (-half, -half + long) if end == 0 else (half - long, half)
        return [Run(wall, *ends, (end == 0, end == 1)), _arm(site, wall, end, across)]
    long = min(wall.length, site.between(3.6, 7.0))
    if wall.length - long < 0.7:
        long = wall.length
    shift = site.random.choice((-1, 0, 1)) * (wall.length - long) / 2
    main = Run(wall, shift - long / 2, shift + long / 2)
    if shape == "line":
        return [main]
    other = site.opposite(wall)
    long = min(wall.length - 1.0, site.between(2.0, 4.4))
    shift = site.random.choice((-1, 1)) * (wall.length - long) / 2
    return [main, Run(other, shift - long / 2, shift + long / 2)]


def _arm(site: Site, wall: Wall, end: int, across: float) -> Run:
    """Return the run along the wall at one end of the main one."""
    side = site.beside(wall)[end]
    long = min(across - DEPTH - 0.95, site.between(1.8, 4.2))
    # Places along a wall grow with x or z, and so a run begins where the main wall stands.
    near_low = wall.yaw in (0, 90)
    half = side.length / 2
    if near_low:
        return Run(side, -half + DEPTH, -half + DEPTH + long)
    return Run(side, half - DEPTH - long, half - DEPTH)


def build(site: Site, counters: Counters) -> None:
    """Stand the fridge, divide the runs into units, and lay the counter tops."""
    runs = _with_fridge(site, counters)
    cooker = 0.68 if site.count("StoveBurner") <= 4 else 0.94
    order = sorted(range(len(runs)), key=lambda each: -runs[each].length)
    modules: dict[int, list[tuple[str, float]]] = {number: [] for number in order}
    for name, width in site.shuffled([("sink", SINK), ("range", cooker)]):
        free = [
            number
            for number in order
            if runs[number].length - sum(wide for _, wide in modules[number]) > width + 0.35
        ]
        if not free:
            raise Cramped(name)
        modules[site.random.choice(free[:2])].append((name, width))
    for number, run in enumerate(runs):
        _divide(site, counters, run, modules[number])
    if counters.island:
        _island(site, counters)


def _with_fridge(site: Site, counters: Counters) -> list[Run]:
    """Stand the fridge at a free end of a run, and return the runs as they are then."""
    runs = counters.runs
    size = site.extent("Fridge")
    fridge = Vector(min(0.85, max(0.7, size.z)), size.y, min(0.95, max(0.7, size.x)))
    ends = []
    for number, run in enumerate(runs):
        lows = [] if run.blind[0] or _at_corner(site, run, 0, runs) else [0]
        highs = [] if run.blind[1] or _at_corner(site, run, 1, runs) else [1]
        ends += [(number, end) for end in lows + highs if run.length > 2.0]
    if not ends:
        raise Cramped("fridge")
    number, end = site.random.choice(ends)
    run = runs[number]
    wide = fridge.x + 0.04
    along = run.begin + wide / 2 if end == 0 else run.end - wide / 2
    site.stand("Fridge", run.wall.box(along, fridge, gap=0.03), run.wall.yaw)
    before = fridge._replace(z=FRONT)
    site.reserve(footprint(run.wall.box(along, before, gap=fridge.z + 0.03)))
    counters.slots.append(Slot(run.wall, along, wide, "fridge"))
    left = list(runs)
    left[number] = (
        replace(run, begin=run.begin + wide) if end == 0 else replace(run, end=run.end - wide)
    )
    return left


def _at_corner(site: Site, run: Run, end: int, runs: list[Run]) -> bool:
    """Whether an end of a run meets another run."""
    at = (run.begin, run.end)[end]
    corner = run.wall.length / 2 - abs(at) < DEPTH + 0.05
    neighbour = site.beside(run.wall)[0 if at < 0 else 1]
    return corner and any(other.wall == neighbour for other in runs)


def _divide(site: Site, counters: Counters, run: Run, modules: list[tuple[str, float]]) -> None:
    """Divide a run into units of about equal width, with sink and stove among them."""
    low, high = run.usable
    spare = high - low - sum(width for _, width in modules)
    count = max(len(modules), round(spare / UNIT))
    unit = spare / count
    order = _order(site, [*modules, *[("unit", unit)] * count], counters.split)
    at, begin = low, run.begin
    made = []
    for name, width in order:
        made.append(Slot(run.wall, at + width / 2, width, name))
        if name == "range" and counters.split:
            _slab(site, run.wall, begin, at)
            site.bodies.append(_ground(run.wall, at, at + width))
            begin = at + width
        at += width
    _slab(site, run.wall, begin, run.end)
    before = run.wall.box((low + high) / 2, Vector(high - low - 0.1, 1, FRONT), gap=DEPTH)
    site.reserve(footprint(before))
    counters.slots += made


def _order(site: Site, modules: list[tuple[str, float]], split: bool) -> list[tuple[str, float]]:
    """Mix modules and units; sink and stove stand apart, a parting stove not at the end."""
    best: list[tuple[str, float]] = modules
    for _ in range(30):
        best = site.shuffled(modules)
        names = [name for name, _ in best]
        apart = all("unit" in pair for pair in pairwise(names))
        inside = not split or "range" not in (names[0], names[-1])
        if apart and inside:
            return best
    return best


def _ground(wall: Wall, begin: float, end: float) -> Footprint:
    return footprint(wall.box((begin + end) / 2, Vector(end - begin, TOP, DEPTH)))


def _slab(site: Site, wall: Wall, begin: float, end: float) -> None:
    if end - begin < 0.1:
        return
    box = wall.box((begin + end) / 2, Vector(end - begin, SLAB, DEPTH), low=TOP - SLAB)
    site.bodies.append(footprint(box))
    site.add("CounterTop", box, wall.yaw)


def _island(site: Site, counters: Counters) -> None:
    """Build a counter into the open floor, with fronts on one side."""
    extent = ISLAND._replace(x=site.between(1.1, 1.9))
    walls = counters.runs[0].wall
    sizes = [extent, Vector(extent.z, TOP, extent.x)]
    for size in sizes if walls.yaw in (0, 180) else sizes[::-1]:
        box = site.in_the_open(size, FRONT)
        if box is not None:
            break
    else:
        site.miss("CounterTop")
        return
    site.bodies.append(footprint(box))
    (x, _, z), (width, _, depth) = box
    along_x = width > depth
    yaw = site.random.choice((0.0, 180.0) if along_x else (90.0, 270.0))
    site.add("CounterTop", Box(Vector(x, TOP - SLAB / 2, z), Vector(width, SLAB, depth)), yaw)
    # Seen from its front, an island is like a wall that the fronts stand against.
    long, deep = (width, depth) if along_x else (depth, width)
    count = max(2, round(long / UNIT))
    back = {0.0: deep / 2 - z, 180.0: z + deep / 2, 90.0: deep / 2 - x, 270.0: x + deep / 2}[yaw]
    fronts = Wall(yaw, long, back)
    middle = x if along_x else z
    for number in range(count):
        off = ((number + 0.5) / count - 0.5) * long
        counters.slots.append(Slot(fronts, middle + off, long / count, "island"))
