"""Pushing discs apart until none hides another, and finding a free place for one more."""

import math
from collections.abc import Collection
from typing import TypeAlias

from reibench.scene import Scene, SceneObject
from reibench.view.containment import support
from reibench.view.plan_geometry import Canvas, Rect

GAP = 6.0
"""Pixels that stay free between two discs, their rims included."""
LARGE = frozenset(("Bread", "HousePlant", "Pan", "Pillow", "Plate", "Pot", "TeddyBear", "Box"))
OBSTACLES = frozenset(
    "CoffeeMachine Desktop Fridge GarbageCan LaundryHamper Microwave Safe SinkBasin Television"
    " Toaster Toilet".split()
)
_WAYS = tuple(math.radians(30 * index) for index in range(12))
Obstacles: TypeAlias = list[tuple[str, Rect]]
"""Ids and footprints of what discs may not cover."""
Circle: TypeAlias = tuple[float, float, float]
"""Middle and radius of a disc that stays where it is."""


class Disc:
    """A thing on its way to where it is drawn."""

    def __init__(self, thing: SceneObject, scene: Scene, canvas: Canvas) -> None:
        self.id = thing.id
        self.parents = thing.parents
        under = support(thing, scene)
        centre = thing.box.center
        floor = canvas.floor
        x, y = canvas.point(centre.x, centre.z)
        self.true_x = self.x = min(max(x, floor.x), floor.right)
        self.true_y = self.y = min(max(y, floor.y), floor.bottom)
        in_sink = under is not None and under.type in ("Sink", "SinkBasin", "BathtubBasin")
        self.radius = _diameter(thing, canvas) / 2 * (0.84 if in_sink else 1.0)
        on_floor = under is None or under.type == "Floor"
        self.home = floor if on_floor or under is None else canvas.rect(under.box)
        if under is not None and under.type == "StoveBurner":
            self.home = Rect(self.x - 1, self.y - 1, 2, 2)

    def keep_home(self, floor: Rect, slack: float) -> None:
        """Move back onto what holds it, give or take `slack` pixels, and inside the walls."""
        margin = self.radius * 0.8 - slack
        home = self.home
        self.x = _clamp(self.x, home.x + margin, home.right - margin)
        self.y = _clamp(self.y, home.y + margin, home.bottom - margin)
        self.x = _clamp(self.x, floor.x + self.radius, floor.right - self.radius)
        self.y = _clamp(self.y, floor.y + self.radius, floor.bottom - self.radius)


def _clamp(value: float, low: float, high: float) -> float:
    return min(max(value, low), high) if low < high else (low + high) / 2


def _diameter(thing: SceneObject, canvas: Canvas) -> float:
    icon = canvas.size.icon
    true = max(thing.box.size.x, thing.box.size.z) * canvas.scale * 0.92
    return min(max(icon, true), icon * (1.7 if thing.type in LARGE else 1.25))


def obstacles(scene: Scene, canvas: Canvas) -> Obstacles:
    """Return what stands in the way of things."""
    return [
        (thing.id, canvas.rect(thing.box).grown(-3))
        for thing in scene.objects
        if thing.type in OBSTACLES
    ]


def relax(discs: list[Disc], blocked: Obstacles, canvas: Canvas) -> None:
    """Push `discs` apart, first on what holds them, then a little beyond where that is too full."""
    for slack in (0.0, 0.0, 6.0, 14.0, 24.0, 40.0, 70.0):
        for turn in range(60):
            worst = _push_apart(discs)
            for disc in discs:
                _push_out(disc, blocked)
                pull = 0.02 if turn < 25 and slack == 0 else 0.0
                disc.x += (disc.true_x - disc.x) * pull
                disc.y += (disc.true_y - disc.y) * pull
                disc.keep_home(canvas.floor, slack)
            if worst < 0.4 and turn > 8:
                break
        if worst < 0.8 and slack:
            break


def _push_apart(discs: list[Disc]) -> float:
    """Move every two that are too close apart; return the worst overlap there was."""
    worst = 0.0
    for index, one in enumerate(discs):
        for other in discs[index + 1 :]:
            dx, dy = other.x - one.x, other.y - one.y
            need = one.radius + other.radius + GAP
            if abs(dx) >= need or abs(dy) >= need:
                continue
            distance = math.hypot(dx, dy) or 0.01
            missing = need - distance
            if missing > 0:
                worst = max(worst, missing)
                dx, dy = _slanted(dx, dy, index)
                share = missing * 0.32 / math.hypot(dx, dy)
                one.x -= dx * share
                one.y -= dy * share
                other.x += dx * share
                other.y += dy * share
    return worst


def _slanted(dx: float, dy: float, turn: int) -> tuple[float, float]:
    """Return a direction that is never quite level or upright, so that rows can give way."""
    side = 1.0 if turn % 2 else -1.0
    if abs(dx) < 0.1 and abs(dy) < 0.1:
        return 0.1 * (1 + turn % 3), 0.1 * side
    if abs(dy) < 0.08 * abs(dx):
        return dx, 0.12 * side * abs(dx)
    if abs(dx) < 0.08 * abs(dy):
        return 0.12 * side * abs(dy), dy
    return dx, dy


def _push_out(disc: Disc, obstacles: Obstacles) -> None:
    for owner, rect in obstacles:
        if owner in disc.parents:
            continue
        block = rect.grown(disc.radius)
        if block.contains(disc.x, disc.y):
            ways = {
                "x": (block.x - disc.x, block.right - disc.x),
                "y": (block.y - disc.y, block.bottom - disc.y),
            }
            axis, way = min(
                ((axis, way) for axis, both in ways.items() for way in both),
                key=lambda pair: abs(pair[1]),
            )
            setattr(disc, axis, getattr(disc, axis) + way * 0.5)


def settle(disc: Disc, others: Collection[Circle], blocked: Obstacles, canvas: Canvas) -> None:
    """Put `disc` at the free place nearest to its true one; nothing else moves."""
    walls = [rect for owner, rect in blocked if owner not in disc.parents]
    best = (math.inf, disc.x, disc.y)
    for slack in (0.0, 10.0, 24.0, 44.0):
        for distance in range(0, 90, 5):
            for angle in _WAYS if distance else (0.0,):
                disc.x = disc.true_x + distance * math.cos(angle)
                disc.y = disc.true_y + distance * math.sin(angle)
                disc.keep_home(canvas.floor, slack)
                crowding = _crowding(disc, others, walls)
                if crowding <= 0:
                    return
                best = min(best, (crowding, disc.x, disc.y))
    _, disc.x, disc.y = best


def _crowding(disc: Disc, others: Collection[Circle], walls: Collection[Rect]) -> float:
    """Return by how many pixels `disc` is too close to anything, all in all."""
    total = 0.0
    for x, y, radius in others:
        total += max(0.0, disc.radius + radius + GAP - math.dist((disc.x, disc.y), (x, y)))
    return total + sum(
        disc.radius for wall in walls if wall.grown(disc.radius - 2).contains(disc.x, disc.y)
    )
