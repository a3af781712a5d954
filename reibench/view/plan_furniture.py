"""Furniture and appliances of a floor plan, drawn to scale from above."""

import math

from reibench.scene import Scene, SceneObject
from reibench.view.icons import appearance
from reibench.view.markup import element, number
from reibench.view.plan_geometry import Canvas, Rect, bands, turned
from reibench.view.plan_parts import badge, hotspot, label, rect
from reibench.view.plan_silhouettes import Drawing, silhouette
from reibench.view.words import states

LABELS = {
    "CoffeeMachine": "coffee",
    "Fridge": "fridge",
    "GarbageCan": "bin",
    "LaundryHamper": "hamper",
    "Microwave": "microwave",
    "Safe": "safe",
}
_ABOVE_HEAD = 1.45
"""Metres: what hangs higher is drawn over the rest, and lightly, so that both can be seen."""
_INLAID = {"Sink": 1, "StoveKnob": 2, "SinkBasin": 2, "BathtubBasin": 2, "StoveBurner": 2}


def furniture(scene: Scene, canvas: Canvas) -> tuple[str, str]:
    """Return all furniture of `scene`: what stands, and what hangs above it."""
    standing: Drawing = []
    hanging: Drawing = []
    stove = _stove(scene, canvas)
    for thing in sorted(scene.objects, key=_cover):
        if appearance(thing).drawn_as != "silhouette" or thing.type == "Floor":
            continue
        if stove and thing.type in ("StoveBurner", "StoveKnob"):
            standing.append(stove)
            stove = ""
        bottom = thing.box.center.y - thing.box.size.y / 2
        above = bottom > _ABOVE_HEAD
        (hanging if above else standing).append(_draw(thing, scene, canvas, above=above))
    return "".join(standing), "".join(hanging)


def _cover(thing: SceneObject) -> float:
    """Return the height that decides what covers what; taps and burners lie on what holds them."""
    if thing.type == "Chair":
        return 0.45  # its seat: pushed in, it is under the table
    top = thing.box.center.y + thing.box.size.y / 2
    return top + _INLAID.get(thing.type, 3 if thing.type == "Faucet" else 0)


def _draw(thing: SceneObject, scene: Scene, canvas: Canvas, *, above: bool) -> str:
    area = canvas.rect(thing.box)
    if thing.type == "CounterTop":
        surface = bands(thing, scene, canvas)
        corner = 6.0 if _free_standing(area, canvas) else 2.0
        outline = [rect(band, "counter", corner) for band in surface]
        joint = [rect(band.grown(-0.5), "counter nostroke", 1) for band in surface[:-1]]
        return hotspot(thing, scene, *outline, *joint)
    shape = turned(thing, canvas)
    body = "".join(silhouette(thing.type)(thing, shape.width, shape.depth))
    turn = f"rotate({number(shape.yaw % 360)})"
    group = element("g", body, transform=f"translate({number(shape.cx)} {number(shape.cy)}) {turn}")
    kind = "fix above" if above else "fix"
    return hotspot(thing, scene, group, *_label(thing, area), *_badges(thing, area), kind=kind)


def _free_standing(area: Rect, canvas: Canvas) -> bool:
    return area.lies_in(canvas.floor.grown(-0.25 * canvas.scale))


def _label(thing: SceneObject, area: Rect) -> Drawing:
    words = LABELS.get(thing.type)
    if not words or area.height < 14:
        return []
    if words == "microwave" and 34 <= area.width < 80 and area.height >= 34:
        return [
            label(area.cx, area.cy - 2, "micro-", "sm"),
            label(area.cx, area.cy + 9, "wave", "sm"),
        ]
    if area.width < 6.4 * len(words):
        return []
    return [label(area.cx, area.cy + 4, words, "sm" if area.width < 50 else "")]


def _badges(thing: SceneObject, area: Rect) -> Drawing:
    if thing.type in ("StoveBurner", "StoveKnob"):
        return []
    shown = [state for state in states(thing) if state not in ("hot", "cold", "filled")]
    return [badge(area.x + 4 + 15 * index, area.y + 4, state) for index, state in enumerate(shown)]


def _stove(scene: Scene, canvas: Canvas) -> str:
    """Return the hob under the burners, at their angle."""
    burners = scene.of_type("StoveBurner")
    if not burners:
        return ""
    turn = math.radians(burners[0].yaw % 90)
    cos, sin = math.cos(turn), math.sin(turn)
    points = [canvas.point(burner.box.center.x, burner.box.center.z) for burner in burners]
    along = [x * cos + y * sin for x, y in points]
    across = [y * cos - x * sin for x, y in points]
    margin = 0.14 * canvas.scale
    width, depth = max(along) - min(along) + 2 * margin, max(across) - min(across) + 2 * margin
    middle, level = (max(along) + min(along)) / 2, (max(across) + min(across)) / 2
    cx, cy = middle * cos - level * sin, middle * sin + level * cos
    plate = rect(Rect(-width / 2, -depth / 2, width, depth), "appliance", 5)
    place = f"translate({number(cx)} {number(cy)}) rotate({number(math.degrees(turn))})"
    return element("g", plate, transform=place, class_="stove")
