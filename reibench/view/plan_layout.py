"""Where things are drawn: at their true place, pushed apart until none hides another.

The layout depends only on the scene it was made from; `follow` then moves only what has moved.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import lru_cache

from reibench.scene import Scene, SceneObject
from reibench.view.containment import container, support
from reibench.view.icons import appearance
from reibench.view.plan_geometry import Canvas, Rect, Size

GAP = 3.0
"""Pixels that stay free between two things."""
LARGE = frozenset(("Bread", "HousePlant", "Pan", "Pillow", "Plate", "Pot", "TeddyBear", "Box"))
OBSTACLES = frozenset(
    "CoffeeMachine Desktop Fridge GarbageCan LaundryHamper Microwave Safe SinkBasin Television"
    " Toaster Toilet".split()
)
_FREE_ANGLES = tuple(math.radians(30 * index) for index in range(12))
_FAN = tuple(math.radians(angle) for angle in (-60, -120, 0, 180, -90, 60, 120, 90))


@dataclass(frozen=True)
class Spot:
    """Where one thing is drawn."""

    x: float
    y: float
    radius: float
    true_x: float
    true_y: float
    carrier: str = ""
    """Id of the thing it lies in or on, if that is drawn as an icon too: it is fanned around it."""
    slot: int = 0
    """Its place in that fan."""
    pieces: int = 1
    """How many slices of one kind are drawn as this one."""

    @property
    def displaced(self) -> bool:
        """Whether it is drawn so far from its true place that a line should lead there."""
        return not self.carrier and math.dist((self.x, self.y), (self.true_x, self.true_y)) > 10


@dataclass(frozen=True)
class Layout:
    """Where everything small is drawn in one scene."""

    canvas: Canvas
    spots: dict[str, Spot]
    """By object id, in scene order; what is held or inside a container has none."""
    placed: dict[str, tuple[tuple[str, ...], int, int]]
    """What each spot was made for: parents and position in centimetres."""


def loose(scene: Scene) -> dict[str, tuple[SceneObject, int]]:
    """Return what is drawn as an icon of its own, with how many slices each stands for."""
    shown: dict[str, tuple[SceneObject, int]] = {}
    first_piece: dict[tuple[str, tuple[str, ...]], str] = {}
    cut = {thing.id for thing in scene.objects if thing.sliced} & {
        "|".join(thing.id.split("|")[:4]) for thing in scene.objects if thing.id.count("|") > 3
    }
    for thing in scene.objects:
        if appearance(thing).drawn_as != "icon" or thing.held or thing.id in cut:
            continue
        if container(thing, scene) is not None:
            continue
        key = (thing.type, thing.parents)
        if thing.type.endswith("Sliced") and key in first_piece:
            kept, count = shown[first_piece[key]]
            shown[first_piece[key]] = (kept, count + 1)
            continue
        first_piece.setdefault(key, thing.id)
        shown[thing.id] = (thing, 1)
    return shown


@lru_cache(maxsize=256)
def lay_out(scene: Scene, size: Size) -> Layout:
    """Return where to draw the things of `scene`."""
    canvas = Canvas.fit(scene, size)
    shown = loose(scene)
    nodes = [
        _Node(thing, scene, canvas) for thing, _ in shown.values() if _carrier(thing, shown) is None
    ]
    _relax(nodes, _obstacles(scene, canvas), canvas)
    spots = {node.id: node.spot(shown[node.id][1]) for node in nodes}
    layout = Layout(canvas, spots, {node.id: _place(shown[node.id][0]) for node in nodes})
    return _carried(layout, scene, shown)


def follow(layout: Layout, scene: Scene) -> Layout:
    """Return the layout for a later `scene` of the same room: what stayed, stays where it was."""
    shown = loose(scene)
    canvas, spots = layout.canvas, {}
    moved = []
    for thing, pieces in shown.values():
        if _carrier(thing, shown) is not None:
            continue
        if layout.placed.get(thing.id) == _place(thing) and not layout.spots[thing.id].carrier:
            spots[thing.id] = replace(layout.spots[thing.id], pieces=pieces)
        else:
            moved.append((thing, pieces))
    obstacles = _obstacles(scene, canvas)
    for thing, pieces in moved:
        node = _Node(thing, scene, canvas)
        _settle(node, spots, obstacles, canvas)
        spots[thing.id] = node.spot(pieces)
    ordered = {key: spots[key] for key in shown if key in spots}
    placed = {key: _place(shown[key][0]) for key in ordered}
    kept = {key: spot for key, spot in layout.spots.items() if spot.carrier}
    return _carried(Layout(canvas, ordered, placed), scene, shown, kept)


def arrange(scenes: Iterable[Scene], size: Size) -> Layout:
    """Return the layout of the last of `scenes`, followed from the first."""
    layout = None
    for scene in scenes:
        layout = lay_out(scene, size) if layout is None else follow(layout, scene)
    if layout is None:
        raise ValueError("a layout needs at least one scene")
    return layout


class _Node:
    """A thing on its way to its spot."""

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

    def spot(self, pieces: int) -> Spot:
        return Spot(self.x, self.y, self.radius, self.true_x, self.true_y, pieces=pieces)


def _clamp(value: float, low: float, high: float) -> float:
    return min(max(value, low), high) if low < high else (low + high) / 2


def _diameter(thing: SceneObject, canvas: Canvas) -> float:
    icon = canvas.size.icon
    true = max(thing.box.size.x, thing.box.size.z) * canvas.scale * 0.92
    return min(max(icon, true), icon * (1.7 if thing.type in LARGE else 1.25))


def _place(thing: SceneObject) -> tuple[tuple[str, ...], int, int]:
    centre = thing.box.center
    return thing.parents, round(centre.x * 50), round(centre.z * 50)


def _carrier(thing: SceneObject, shown: dict[str, tuple[SceneObject, int]]) -> str | None:
    return next((parent for parent in thing.parents if parent in shown), None)


def _obstacles(scene: Scene, canvas: Canvas) -> list[tuple[str, Rect]]:
    return [
        (thing.id, canvas.rect(thing.box).grown(-3))
        for thing in scene.objects
        if thing.type in OBSTACLES
    ]


def _relax(nodes: list[_Node], obstacles: list[tuple[str, Rect]], canvas: Canvas) -> None:
    """Push `nodes` apart, first on what holds them, then a little beyond where that is too full."""
    for slack in (0.0, 0.0, 6.0, 14.0, 24.0, 40.0, 70.0):
        for turn in range(60):
            worst = _push_apart(nodes)
            for node in nodes:
                _push_out(node, obstacles)
                pull = 0.02 if turn < 25 and slack == 0 else 0.0
                node.x += (node.true_x - node.x) * pull
                node.y += (node.true_y - node.y) * pull
                node.keep_home(canvas.floor, slack)
            if worst < 0.4 and turn > 8:
                break
        if worst < 0.8 and slack:
            break


def _push_apart(nodes: list[_Node]) -> float:
    """Move every two that are too close apart; return the worst overlap there was."""
    worst = 0.0
    for index, one in enumerate(nodes):
        for other in nodes[index + 1 :]:
            dx, dy = other.x - one.x, other.y - one.y
            need = one.radius + other.radius + 2 * 1.5 + GAP
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


def _push_out(node: _Node, obstacles: list[tuple[str, Rect]]) -> None:
    for owner, rect in obstacles:
        if owner in node.parents:
            continue
        block = rect.grown(node.radius)
        if block.contains(node.x, node.y):
            ways = {
                "x": (block.x - node.x, block.right - node.x),
                "y": (block.y - node.y, block.bottom - node.y),
            }
            axis, way = min(
                ((axis, way) for axis, both in ways.items() for way in both),
                key=lambda pair: abs(pair[1]),
            )
            setattr(node, axis, getattr(node, axis) + way * 0.5)


def _settle(
    node: _Node, spots: dict[str, Spot], obstacles: list[tuple[str, Rect]], canvas: Canvas
) -> None:
    """Put `node` at the free place nearest to its true one; nothing else moves."""
    blocked = [rect for owner, rect in obstacles if owner not in node.parents]
    best = (math.inf, node.x, node.y)
    for slack in (0.0, 10.0, 24.0, 44.0):
        for distance in range(0, 90, 5):
            for angle in _FREE_ANGLES if distance else (0.0,):
                node.x = node.true_x + distance * math.cos(angle)
                node.y = node.true_y + distance * math.sin(angle)
                node.keep_home(canvas.floor, slack)
                crowding = _crowding(node, spots, blocked)
                if crowding <= 0:
                    return
                best = min(best, (crowding, node.x, node.y))
    _, node.x, node.y = best


def _crowding(node: _Node, spots: dict[str, Spot], blocked: list[Rect]) -> float:
    total = 0.0
    for spot in spots.values():
        need = node.radius + spot.radius + 2 * 1.5 + GAP
        total += max(0.0, need - math.dist((node.x, node.y), (spot.x, spot.y)))
    return total + sum(
        node.radius for rect in blocked if rect.grown(node.radius - 2).contains(node.x, node.y)
    )


def _carried(
    layout: Layout,
    scene: Scene,
    shown: dict[str, tuple[SceneObject, int]],
    before: dict[str, Spot] | None = None,
) -> Layout:
    """Add the spots of what lies in or on other things, fanned around the upper edge of those."""
    before = before or {}
    spots, placed = dict(layout.spots), dict(layout.placed)
    taken: dict[str, set[int]] = {}
    waiting = [(thing, _carrier(thing, shown)) for thing, _ in shown.values()]
    waiting = [(thing, carrier) for thing, carrier in waiting if carrier is not None]
    for thing, carrier in waiting:
        old = before.get(thing.id)
        if old and old.carrier == carrier:
            taken.setdefault(carrier, set()).add(old.slot)
    for thing, carrier in sorted(waiting, key=lambda pair: len(pair[0].parents)):
        base = spots.get(carrier or "")
        if carrier is None or base is None:
            continue
        old = before.get(thing.id)
        slots = taken.setdefault(carrier, set())
        slot = old.slot if old and old.carrier == carrier else _first_free(slots)
        slots.add(slot)
        radius = layout.canvas.size.icon * 0.42
        angle = _FAN[slot % len(_FAN)]
        reach = base.radius * 0.92
        x, y = base.x + reach * math.cos(angle), base.y + reach * math.sin(angle)
        pieces = shown[thing.id][1]
        spots[thing.id] = Spot(x, y, radius, x, y, carrier, slot, pieces)
        placed[thing.id] = _place(thing)
    return Layout(layout.canvas, spots, placed)


def _first_free(taken: set[int]) -> int:
    return next(slot for slot in range(len(taken) + 1) if slot not in taken)
