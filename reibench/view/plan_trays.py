"""Trays with what open containers hold, and names beside things, wherever there is room."""

import math

from reibench.scene import Scene, SceneObject
from reibench.view.containment import container, is_hidden
from reibench.view.icons import appearance
from reibench.view.markup import element
from reibench.view.plan_geometry import Canvas, Rect
from reibench.view.plan_layout import Layout
from reibench.view.plan_parts import badge, hotspot, label, line, rect
from reibench.view.plan_things import picture
from reibench.view.words import name, states

SHOWN = 5
"""A fuller tray shows this many and counts the rest."""
_ITEM, _TALL = 26.0, 46.0
"""Pixels an item is wide and a tray tall, where icons are 25 pixels."""


def trays(scene: Scene, layout: Layout) -> tuple[str, list[Rect]]:
    """Return a tray beside each open container that holds something, and where they are."""
    canvas = layout.canvas
    held: dict[str, list[SceneObject]] = {}
    for thing in scene.objects:
        outer = container(thing, scene)
        if outer and outer.open and not thing.held and not is_hidden(thing, scene):
            held.setdefault(outer.id, []).append(thing)
    drawn, taken = [], [_robot_area(scene, canvas)]
    for key, items in held.items():
        owner = scene.by_id[key]
        anchor = _anchor(owner, layout)
        area = _free_place(owner, anchor, len(items), layout, taken, scene)
        taken.append(area)
        drawn.append(_tray(owner, items, anchor, area, scene))
    return "".join(drawn), taken


def _robot_area(scene: Scene, canvas: Canvas) -> Rect:
    x, y = canvas.point(scene.agent.position.x, scene.agent.position.z)
    return Rect(x - 20, y - 20, 54 if scene.held else 40, 52 if scene.held else 40)


def _anchor(owner: SceneObject, layout: Layout) -> tuple[float, float]:
    if owner.id in layout.spots:
        spot = layout.spots[owner.id]
        return spot.x, spot.y
    area = layout.canvas.rect(owner.box)
    return area.cx, area.cy


def _free_place(
    owner: SceneObject,
    anchor: tuple[float, float],
    count: int,
    layout: Layout,
    taken: list[Rect],
    scene: Scene,
) -> Rect:
    """Return where a tray hides least, as near as may be to what it belongs to."""
    canvas = layout.canvas
    grown = canvas.size.icon / 25
    tall = _TALL * grown
    shown = min(count, SHOWN) + (1 if count > SHOWN else 0)
    title = f"in the {name(owner.type)}"
    width = (max(_ITEM * shown, 5.9 * len(title)) + 20) * grown
    things = [
        Rect(spot.x - spot.radius, spot.y - spot.radius, 2 * spot.radius, 2 * spot.radius)
        for spot in layout.spots.values()
    ]
    solid = [
        canvas.rect(thing.box)
        for thing in scene.objects
        if appearance(thing).drawn_as == "silhouette" and thing.type != "Floor"
    ]
    floor = canvas.floor.grown(-3)
    best, least = Rect(floor.x, floor.y, width, tall), math.inf
    for distance in range(40, 240, 16):
        for step in range(24):
            angle = step * math.pi / 12
            x = anchor[0] + distance * math.cos(angle) - width / 2
            y = anchor[1] + distance * math.sin(angle) - tall / 2
            area = Rect(x, y, width, tall)
            if not area.lies_in(floor):
                continue
            cost = 0.35 * distance
            cost += sum(2.0 * area.overlap(other) for other in taken)
            cost += sum(0.4 * area.overlap(other) for other in things)
            cost += sum(0.012 * area.overlap(other) for other in solid)
            if cost < least:
                best, least = area, cost
    return best


def _tray(
    owner: SceneObject,
    items: list[SceneObject],
    anchor: tuple[float, float],
    area: Rect,
    scene: Scene,
) -> str:
    grown = area.height / _TALL
    drawn = [
        line(anchor[0], anchor[1], area.cx, area.cy, "stem"),
        rect(area, "traybox", 8),
        label(
            area.x + 8 * grown, area.y + 14 * grown, f"in the {name(owner.type)}", "strong", "start"
        ),
    ]
    shown = items if len(items) <= SHOWN else items[:SHOWN]
    for index, thing in enumerate(shown):
        x, y = area.x + 19 + _ITEM * index, area.y + 30
        hit = rect(Rect(x - 13, y - 12, _ITEM, 25), "hit", 6)
        marks = [badge(x + 9, y - 9, state, 6.0) for state in states(thing)[:1]]
        drawn.append(
            hotspot(thing, scene, hit, picture(thing, 22, x, y), *marks, kind="thing kept")
        )
    if len(items) > SHOWN:
        x = area.x + (12 + _ITEM * SHOWN) * grown
        drawn.append(label(x, area.y + 34 * grown, f"+{len(items) - SHOWN}", "strong", "start"))
    return element("g", *drawn, class_="tray")


def names(scene: Scene, layout: Layout, taken: list[Rect]) -> str:
    """Return the names of things and furniture: those that fit, nearest to the robot first."""
    canvas = layout.canvas
    robot = canvas.point(scene.agent.position.x, scene.agent.position.z)
    wanted: list[tuple[float, str, float, float, float]] = []
    for key, spot in layout.spots.items():
        distance = math.dist(robot, (spot.x, spot.y))
        wanted.append((distance, name(scene.by_id[key].type), spot.x, spot.y, spot.radius + 2))
    for thing in scene.objects:
        if appearance(thing).drawn_as == "silhouette" and thing.type not in _UNNAMED:
            area = canvas.rect(thing.box)
            distance = 60 + math.dist(robot, (area.cx, area.cy))
            wanted.append((distance, name(thing.type), area.cx, area.cy, -5))
    discs = [
        Rect(spot.x - spot.radius, spot.y - spot.radius, 2 * spot.radius, 2 * spot.radius)
        for spot in layout.spots.values()
    ]
    blocked, drawn = [*taken, *discs], []
    for _, words, x, y, gap in sorted(wanted):
        width = 5.9 * len(words) + 6
        sides = (
            Rect(x - width / 2, y + gap, width, 13),
            Rect(x - width / 2, y - gap - 13, width, 13),
            Rect(x + gap, y - 6.5, width, 13),
            Rect(x - gap - width, y - 6.5, width, 13),
        )
        for area in sides:
            inside = area.lies_in(canvas.floor)
            if inside and not any(area.overlap(other) > 1 for other in blocked):
                blocked.append(area)
                drawn.append(rect(area, "nametag", 4) + label(area.cx, area.y + 10, words, "name"))
                break
    return element("g", *drawn, class_="names", aria_hidden="true")


_UNNAMED = frozenset(
    "BathtubBasin CoffeeMachine Faucet Floor Fridge GarbageCan LaundryHamper Microwave Safe"
    " SinkBasin StoveBurner StoveKnob".split()
)
"""Furniture that has a label anyway, or is too small for one."""
