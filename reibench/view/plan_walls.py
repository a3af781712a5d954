"""What is on the walls of a floor plan: windows, mirrors, curtains, holders, switches."""

from reibench.scene import Scene, SceneObject
from reibench.view.icons import appearance
from reibench.view.markup import number
from reibench.view.plan_geometry import Canvas, Rect
from reibench.view.plan_parts import circle, hotspot, path, rect

_IN_THE_WALL = frozenset(("Window", "Mirror", "LightSwitch"))
_GLASS = frozenset(("ShowerDoor", "ShowerGlass"))


def room_shell(canvas: Canvas) -> str:
    """Return walls and floor, with half-metre tiles as a ruler without numbers."""
    floor, step = canvas.floor, canvas.scale / 2
    across = [floor.x + at * step for at in range(1, int(floor.width / step) + 1)]
    down = [floor.y + at * step for at in range(1, int(floor.height / step) + 1)]
    lines = [f"M{number(x)} {number(floor.y)}V{number(floor.bottom)}" for x in across]
    lines += [f"M{number(floor.x)} {number(y)}H{number(floor.right)}" for y in down]
    outer = Rect(0, 0, canvas.width, canvas.height)
    return rect(outer, "wall", 7) + rect(floor, "floor", 2) + path("".join(lines), "tile")


def draw_walls(scene: Scene, canvas: Canvas) -> str:
    """Return everything on the walls of `scene`."""
    return "".join(
        _draw(thing, scene, canvas)
        for thing in scene.objects
        if appearance(thing).drawn_as == "wall"
    )


def _draw(thing: SceneObject, scene: Scene, canvas: Canvas) -> str:
    area = canvas.rect(thing.box)
    wall = _nearest_wall(area, canvas)
    if wall is None:
        return hotspot(thing, scene, rect(_thin(area), _kind(thing), 2), kind="onwall")
    if thing.type in _IN_THE_WALL:
        strip = _strip(area, wall, canvas, inside=False)
        drawn = [rect(strip, _kind(thing), 2)]
        if thing.type == "Window":
            drawn.append(path(_middle(strip), "pane"))
        return hotspot(thing, scene, *drawn, kind="onwall")
    strip = _strip(area, wall, canvas, inside=True)
    if thing.type in ("Curtains", "ShowerCurtain", "Blinds"):
        return hotspot(thing, scene, path(_wave(strip), "curtain"), kind="onwall")
    if thing.type == "ShowerHead":
        return hotspot(thing, scene, circle(strip.cx, strip.cy, 4, "tapbase"), kind="onwall")
    return hotspot(thing, scene, rect(strip, _kind(thing), 1.5), kind="onwall")


def _kind(thing: SceneObject) -> str:
    if thing.type in _GLASS:
        return "window"
    return {"Window": "window", "Mirror": "mirror", "LightSwitch": "switch"}.get(thing.type, "rail")


def _nearest_wall(area: Rect, canvas: Canvas) -> str | None:
    """Return the wall `area` is on: the nearest of those its long side runs along."""
    floor = canvas.floor
    gaps = {
        "left": area.cx - floor.x,
        "right": floor.right - area.cx,
        "top": area.cy - floor.y,
        "bottom": floor.bottom - area.cy,
    }
    if area.width > 1.3 * area.height:
        gaps = {"top": gaps["top"], "bottom": gaps["bottom"]}
    elif area.height > 1.3 * area.width:
        gaps = {"left": gaps["left"], "right": gaps["right"]}
    nearest = min(gaps, key=lambda wall: gaps[wall])
    return nearest if gaps[nearest] < 0.45 * canvas.scale else None


def _strip(area: Rect, wall: str, canvas: Canvas, *, inside: bool) -> Rect:
    floor, thick = canvas.floor, canvas.size.wall
    wide = 4.0 if inside else thick - 3
    if wall in ("left", "right"):
        length = max(area.height, 8.0)
        y = area.cy - length / 2
        if wall == "left":
            return Rect(floor.x if inside else 1.5, y, wide, length)
        return Rect(floor.right - wide if inside else floor.right + 1.5, y, wide, length)
    length = max(area.width, 8.0)
    x = area.cx - length / 2
    if wall == "top":
        return Rect(x, floor.y if inside else 1.5, length, wide)
    return Rect(x, floor.bottom - wide if inside else floor.bottom + 1.5, length, wide)


def _thin(area: Rect) -> Rect:
    if area.width > area.height:
        return Rect(area.x, area.cy - 2, area.width, 4)
    return Rect(area.cx - 2, area.y, 4, area.height)


def _middle(strip: Rect) -> str:
    if strip.height > strip.width:
        return f"M{number(strip.cx)} {number(strip.y + 3)}v{number(strip.height - 6)}"
    return f"M{number(strip.x + 3)} {number(strip.cy)}h{number(strip.width - 6)}"


def _wave(strip: Rect) -> str:
    """Return a wavy line along `strip`."""
    upright = strip.height > strip.width
    count = max(2, round(max(strip.width, strip.height) / 9))
    step = max(strip.width, strip.height) / count
    parts = []
    for index in range(count):
        bulge = 4 if index % 2 else -4
        parts.append(
            f"q{bulge} {number(step / 2)} 0 {number(step)}"
            if upright
            else f"q{number(step / 2)} {bulge} {number(step)} 0"
        )
    start = (strip.cx, strip.y) if upright else (strip.x, strip.cy)
    return f"M{number(start[0])} {number(start[1])}" + "".join(parts)
