"""Where things are drawn: at their true place, pushed apart until none hides another.

The layout depends only on the scene it was made from; `follow` then moves only what has moved.
"""

import math
import threading
from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TypeAlias

from reibench.scene import Scene, SceneObject
from reibench.view.containment import container
from reibench.view.icons import appearance
from reibench.view.plan_crowding import Disc, obstacles, relax, settle
from reibench.view.plan_geometry import Canvas, Size

_FAN = tuple(math.radians(angle) for angle in (-60, -120, 0, 180, -90, 60, 120, 90))
"""Directions in which things lie around the one that carries them."""


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
    discs = [
        Disc(thing, scene, canvas) for thing, _ in shown.values() if _carrier(thing, shown) is None
    ]
    relax(discs, obstacles(scene, canvas), canvas)
    spots = {disc.id: _spot(disc, shown[disc.id][1]) for disc in discs}
    layout = Layout(canvas, spots, {disc.id: _place(shown[disc.id][0]) for disc in discs})
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
    blocked = obstacles(scene, canvas)
    for thing, pieces in moved:
        disc = Disc(thing, scene, canvas)
        others = [(spot.x, spot.y, spot.radius) for spot in spots.values()]
        settle(disc, others, blocked, canvas)
        spots[thing.id] = _spot(disc, pieces)
    ordered = {key: spots[key] for key in shown if key in spots}
    placed = {key: _place(shown[key][0]) for key in ordered}
    kept = {key: spot for key, spot in layout.spots.items() if spot.carrier}
    return _carried(Layout(canvas, ordered, placed), scene, shown, kept)


def arrange(scenes: Sequence[Scene], size: Size) -> Layout:
    """Return the layout of the last of `scenes`, followed from the first.

    What was arranged lately is known by the very scenes, so that a further step costs one step.
    """
    if not scenes:
        raise ValueError("a layout needs at least one scene")
    key = (size, *map(id, scenes))
    layout = _arranged.find(key)
    if layout is None:
        before = arrange(scenes[:-1], size) if len(scenes) > 1 else None
        layout = follow(before, scenes[-1]) if before else lay_out(scenes[-1], size)
        _arranged.keep(key, tuple(scenes), layout)
    return layout


class _Arranged:
    """Layouts by the scenes they came of, which are kept too: their ids must stay theirs."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._known: OrderedDict[_Key, tuple[tuple[Scene, ...], Layout]] = OrderedDict()
        self._lock = threading.Lock()

    def find(self, key: "_Key") -> Layout | None:
        with self._lock:
            found = self._known.get(key)
            if found:
                self._known.move_to_end(key)
        return found[1] if found else None

    def keep(self, key: "_Key", scenes: tuple[Scene, ...], layout: Layout) -> None:
        with self._lock:
            self._known[key] = (scenes, layout)
            while len(self._known) > self._most:
                self._known.popitem(last=False)


_Key: TypeAlias = tuple[object, ...]
_arranged = _Arranged(most=512)


def _spot(disc: Disc, pieces: int) -> Spot:
    return Spot(disc.x, disc.y, disc.radius, disc.true_x, disc.true_y, pieces=pieces)


def _place(thing: SceneObject) -> tuple[tuple[str, ...], int, int]:
    centre = thing.box.center
    return thing.parents, round(centre.x * 50), round(centre.z * 50)


def _carrier(thing: SceneObject, shown: dict[str, tuple[SceneObject, int]]) -> str | None:
    return next((parent for parent in thing.parents if parent in shown), None)


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
