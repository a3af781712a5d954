"""Windows, curtains, pictures and mirrors; and whatever stands somewhere along the walls."""

from reibench.household.geometry import bottom, footprint, top
from reibench.household.homes.site import Site
from reibench.scene import SceneObject, Vector

LOOSE = {
    "GarbageBag": Vector(0.45, 0.55, 0.42),
    "HousePlant": Vector(0.4, 0.9, 0.4),
    "VacuumCleaner": Vector(0.4, 1.0, 0.4),
}
"""Sizes where the boxes of turned instances say too much."""


def add_windows(site: Site, count: int) -> None:
    """Put windows into free pieces of wall."""
    for _ in range(count):
        drawn = site.extent("Window")
        window = Vector(min(1.6, drawn.x), min(1.6, drawn.y), 0.1)
        wide = Vector(window.x + 0.1, window.y, 0.3)
        for low in (0.9, 1.25):
            fits = window._replace(y=min(window.y, 2.4 - low))
            space = wide._replace(y=fits.y)
            if site.hang("Window", fits, low, space=space) is not None:
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
    free = site.clear_of_bodies(footprint(wall.box(along, long)))
    low = 0.1 if free else bottom(window.box) - 0.1
    extent = long._replace(y=2.46 - low)
    site.add(kind, wall.box(along, extent, low=low, gap=0.07), wall.yaw)


def hang_all(site: Site, kind: str, low: float, *, most: float = 1.4) -> None:
    """Hang all pictures or mirrors of a type."""
    for _ in range(site.count(kind)):
        drawn = site.extent(kind)
        extent = Vector(min(most, drawn.x), min(1.1, drawn.y), 0.07)
        if site.hang(kind, extent, min(low, 2.4 - extent.y)) is None:
            site.miss(kind)


def stand_about(site: Site, kind: str, count: int | None = None, *, passage: float = 0.35) -> None:
    """Stand pieces of furniture along the walls; as many as the room is to have if None."""
    for _ in range(site.count(kind) if count is None else count):
        extent = LOOSE.get(kind) or site.extent(kind)
        corner = site.random.random() < 0.6
        site.against_wall(kind, extent, passage=passage, corner=corner, turned=True)
