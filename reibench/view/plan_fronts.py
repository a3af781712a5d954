"""Cabinets, drawers and shelves: strips at the edge of furniture that faces the room."""

from dataclasses import dataclass

from reibench.scene import Scene, SceneObject
from reibench.view.icons import appearance
from reibench.view.markup import element, number
from reibench.view.plan_geometry import Canvas, Rect, bands
from reibench.view.plan_parts import circle, hotspot, label, path, rect

SIDES = {"up": (0, -1), "right": (1, 0), "down": (0, 1), "left": (-1, 0)}
"""Ways a front can face, as steps on the page; AI2-THOR's yaw runs through them from 0° on."""
_HOSTS = frozenset(
    "CoffeeTable CounterTop Desk DiningTable Dresser SideTable ShelvingUnit Sink TVStand".split()
)
_BLOCKING = _HOSTS | frozenset(
    "ArmChair Bathtub Bed Cabinet Drawer Fridge Safe Sofa Toilet".split()
)


@dataclass(frozen=True)
class Front:
    """Cabinets, drawers or shelves above each other, drawn as one."""

    things: tuple[SceneObject, ...]
    area: Rect
    """Footprint of the first."""
    hanging: bool
    """Whether it hangs on the wall, above the counter."""

    @property
    def shown(self) -> SceneObject:
        """The one the strip stands for: an open one, else the first."""
        return next((thing for thing in self.things if thing.open), self.things[0])


def group_fronts(scene: Scene, canvas: Canvas) -> list[Front]:
    """Return the cabinets, drawers and shelves of `scene`, stacked ones together."""
    groups: list[list[SceneObject]] = []
    for thing in scene.objects:
        if appearance(thing).drawn_as != "front":
            continue
        home = next((group for group in groups if _above_each_other(group[0], thing)), None)
        if home is None:
            groups.append([thing])
        else:
            home.append(thing)
    return [Front(tuple(group), canvas.rect(group[0].box), _hangs(group[0])) for group in groups]


def _hangs(thing: SceneObject) -> bool:
    return thing.box.center.y - thing.box.size.y / 2 > 1.1


def _above_each_other(one: SceneObject, other: SceneObject) -> bool:
    near = (
        abs(one.box.center.x - other.box.center.x) < 0.13
        and abs(one.box.center.z - other.box.center.z) < 0.13
    )
    return one.type == other.type and near and _hangs(one) == _hangs(other)


def draw_fronts(scene: Scene, canvas: Canvas) -> tuple[str, str]:
    """Return all fronts of `scene`: those at the floor, and those that hang on the wall."""
    low, high = [], []
    blocks = _blocks(scene, canvas)
    for front in group_fronts(scene, canvas):
        if front.things[0].type == "Shelf" or front.hanging:
            high.append(_outline(front, scene, canvas, blocks))
        else:
            low.append(_strip(front, scene, canvas, blocks))
    return "".join(low), "".join(high)


Blocks = list[tuple[SceneObject, Rect]]


def _blocks(scene: Scene, canvas: Canvas) -> Blocks:
    return [
        (thing, band)
        for thing in scene.objects
        if thing.type in _BLOCKING and not _hangs(thing)
        for band in bands(thing, scene, canvas)
    ]


def facing(front: Front, canvas: Canvas, blocks: Blocks) -> str:
    """Return the side of `front` that opens into the room.

    Yaw alone won't do: built-in drawers of many iTHOR rooms all report 0°.
    """
    area, floor = front.area, canvas.floor
    reach = 0.35 * canvas.scale
    ids = {thing.id for thing in front.things}
    stated = list(SIDES)[round(front.things[0].yaw / 90) % 4]

    def merit(side: str) -> float:
        dx, dy = SIDES[side]
        x = area.cx + dx * (area.width / 2 + reach)
        y = area.cy + dy * (area.height / 2 + reach)
        free = floor.contains(x, y) and not any(
            block.contains(x, y) for thing, block in blocks if thing.id not in ids
        )
        behind = {
            "up": floor.bottom - area.bottom,
            "down": area.y - floor.y,
            "left": floor.right - area.right,
            "right": area.x - floor.x,
        }[side]
        return 2.0 * free + 1.0 * (side == stated) + 1.5 * (behind < 0.45 * canvas.scale)

    return max(SIDES, key=merit)


def _edge(front: Front, side: str, canvas: Canvas, blocks: Blocks) -> Rect:
    """Return what the strip is at the edge of: the furniture the front is built into, or itself."""
    best, most = front.area, 0.0
    for thing, band in blocks:
        shared = band.overlap(front.area)
        if thing.type in _HOSTS and shared > most:
            best, most = band, shared
    dx, dy = SIDES[side]
    overhang = dx * (
        (best.right if dx > 0 else best.x) - (front.area.right if dx > 0 else front.area.x)
    ) + dy * ((best.bottom if dy > 0 else best.y) - (front.area.bottom if dy > 0 else front.area.y))
    return best if -0.1 * canvas.scale < overhang < 0.35 * canvas.scale else front.area


def _strip(front: Front, scene: Scene, canvas: Canvas, blocks: Blocks) -> str:
    side = facing(front, canvas, blocks)
    edge = _edge(front, side, canvas, blocks)
    thick = 8.5 if canvas.size.icon > 24 else 6.5
    bar = _at_edge(front.area, edge, side, thick)
    drawn = []
    if not any(thing.type in _HOSTS and band.overlap(front.area) for thing, band in blocks):
        drawn.append(rect(front.area, "table", 3))
    if any(thing.open for thing in front.things):
        bar, opening = _opened(front, bar, side, canvas)
        drawn += opening
    drawn += [rect(bar, "frontbox", 2), *_handle(front, bar)]
    count = len(front.things)
    more = f", one of {count} above each other" if count > 1 else ""
    return hotspot(front.shown, scene, *drawn, kind="front", more=more)


def _at_edge(area: Rect, edge: Rect, side: str, thick: float) -> Rect:
    if side == "right":
        return Rect(edge.right + 0.5, area.y + 1.5, thick, max(area.height - 3, 6))
    if side == "left":
        return Rect(edge.x - thick - 0.5, area.y + 1.5, thick, max(area.height - 3, 6))
    if side == "up":
        return Rect(area.x + 1.5, edge.y - thick - 0.5, max(area.width - 3, 6), thick)
    return Rect(area.x + 1.5, edge.bottom + 0.5, max(area.width - 3, 6), thick)


def _opened(front: Front, bar: Rect, side: str, canvas: Canvas) -> tuple[Rect, list[str]]:
    """Return where the strip is now, and the drawer that slid out or the door that swung out."""
    dx, dy = SIDES[side]
    if front.shown.type == "Drawer":
        out = 0.2 * canvas.scale
        tray = Rect(
            bar.x + min(dx, 0) * out,
            bar.y + min(dy, 0) * out,
            bar.width + abs(dx) * out,
            bar.height + abs(dy) * out,
        )
        return Rect(bar.x + dx * out, bar.y + dy * out, bar.width, bar.height), [
            rect(tray, "cavity", 2)
        ]
    swing = 0.3 * canvas.scale
    x = bar.x if dx == 0 else bar.cx
    y = bar.y if dy == 0 else bar.cy
    lean = 0.35 * swing
    to_x, to_y = dx * swing - abs(dy) * lean, dy * swing - abs(dx) * lean
    return bar, [path(f"M{number(x)} {number(y)}l{number(to_x)} {number(to_y)}", "door")]


def _handle(front: Front, bar: Rect) -> list[str]:
    count = len(front.things)
    if count > 1:
        return [
            circle(bar.cx, bar.cy, 7, "countdot"),
            label(bar.cx, bar.cy + 3.3, str(count), "count"),
        ]
    if bar.width > bar.height:
        return [path(f"M{number(bar.cx - 5)} {number(bar.cy)}h10", "handle")]
    return [path(f"M{number(bar.cx)} {number(bar.cy - 5)}v10", "handle")]


def _outline(front: Front, scene: Scene, canvas: Canvas, blocks: Blocks) -> str:
    """Return a dashed outline: what it shows hangs above other things."""
    area = front.area.grown(-1.5)
    drawn = [rect(area, "wallcabbox", 3)]
    if any(thing.open for thing in front.things):
        side = facing(front, canvas, blocks)
        drawn += _opened(front, _at_edge(area, area, side, 0), side, canvas)[1]
    count = len(front.things)
    if count > 1 and canvas.size.icon > 24:
        x, y = area.right - 4, area.y + 4
        drawn += [circle(x, y, 6, "countdot"), label(x, y + 3.2, str(count), "count")]
    more = f", one of {count} above each other" if count > 1 else ""
    return element("g", hotspot(front.shown, scene, *drawn, kind="wallcab", more=more))
