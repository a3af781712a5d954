"""Silhouettes of furniture and appliances, from above.

Each is drawn around the origin as if it faced up the page: AI2-THOR's furniture faces along its
yaw, so the plan only has to turn it.
"""

from collections.abc import Callable

from reibench.scene import SceneObject
from reibench.view.markup import element, number
from reibench.view.plan_geometry import Rect
from reibench.view.plan_parts import circle, line, path, rect

Drawing = list[str]
Silhouette = Callable[[SceneObject, float, float], Drawing]
"""Draws a thing of this width and depth in pixels, centred, facing up."""


def silhouette(object_type: str) -> Silhouette:
    """Return how this type is drawn; a plain table for types without a drawing of their own."""
    return _SILHOUETTES.get(object_type, _table)


def _box(width: float, depth: float, kind: str, corner: float = 4.0, inset: float = 0.0) -> str:
    area = Rect(-width / 2, -depth / 2, width, depth).grown(-inset)
    return rect(area, kind, min(corner, min(area.width, area.height) / 2))


def _door(x: float, y: float, swing_x: float, swing_y: float) -> str:
    return line(x, y, x + swing_x, y + swing_y, "door")


def _table(thing: SceneObject, width: float, depth: float) -> Drawing:
    return [_box(width, depth, "table", 6)]


def _coffee_table(thing: SceneObject, width: float, depth: float) -> Drawing:
    return [_box(width, depth, "table", 9), _box(width, depth, "trim", 7, 4)]


def _desk(thing: SceneObject, width: float, depth: float) -> Drawing:
    bay = Rect(-width * 0.22, -depth / 2, width * 0.44, depth * 0.3)
    return [_box(width, depth, "table", 4), rect(bay, "bay", 2)]


def _shelving(thing: SceneObject, width: float, depth: float) -> Drawing:
    lines = [
        line(width * at, -depth / 2 + 2, width * at, depth / 2 - 2, "trimline")
        for at in (-0.17, 0.17)
    ]
    return [_box(width, depth, "table", 3), *lines]


def _cart(thing: SceneObject, width: float, depth: float) -> Drawing:
    wheels = [
        circle(x * (width / 2 - 4), y * (depth / 2 - 4), 2, "dot") for x in (-1, 1) for y in (-1, 1)
    ]
    return [_box(width, depth, "table", 4), *wheels]


def _seat(thing: SceneObject, width: float, depth: float) -> Drawing:
    back = Rect(-width / 2, depth / 2 - 4.5, width, 4.5)
    return [_box(width, depth, "seat", 7, 1), rect(back, "back", 2.2)]


def _stool(thing: SceneObject, width: float, depth: float) -> Drawing:
    radius = min(width, depth) * 0.42
    return [circle(0, 0, radius, "seat"), circle(0, 0, radius * 0.6, "trim")]


def _cushion(thing: SceneObject, width: float, depth: float) -> Drawing:
    return [_box(width, depth, "seat", 9, 1), circle(0, 0, 2.5, "dot")]


def _sofa(thing: SceneObject, width: float, depth: float) -> Drawing:
    arm, back = min(width * 0.14, 16.0), depth * 0.26
    cushions = max(1, round((width - 2 * arm) / 78))
    seat = (width - 2 * arm) / cushions
    drawn = [_box(width, depth, "back", 9)]
    for index in range(cushions):
        left = -width / 2 + arm + index * seat
        drawn.append(rect(Rect(left + 1, -depth / 2 + 1, seat - 2, depth - back), "seat", 5))
    return drawn


def _bed(thing: SceneObject, width: float, depth: float) -> Drawing:
    pillows = max(1, round(width / 95))
    each = width / pillows
    head = depth * 0.24
    drawn = [_box(width, depth, "table", 7), _box(width, depth, "sheet", 5, 3)]
    for index in range(pillows):
        left = -width / 2 + index * each
        drawn.append(rect(Rect(left + 8, depth / 2 - head, each - 16, head - 8), "cushion", 6))
    fold = Rect(-width / 2 + 3, -depth / 2 + 3, width - 6, depth * 0.62)
    return [
        *drawn,
        rect(fold, "blanket", 5),
        line(-width / 2 + 3, depth * 0.12, width / 2 - 3, depth * 0.12, "trimline"),
    ]


def _dog_bed(thing: SceneObject, width: float, depth: float) -> Drawing:
    return [
        element("ellipse", class_="back", cx=0, cy=0, rx=width / 2, ry=depth / 2),
        element("ellipse", class_="seat", cx=0, cy=0, rx=width * 0.36, ry=depth * 0.34),
    ]


def _fridge(thing: SceneObject, width: float, depth: float) -> Drawing:
    drawn = [
        _box(width, depth, "appliance", 4),
        _box(width, depth, "cavity" if thing.open else "inset", 3, 5),
    ]
    if thing.open:
        return [*drawn, _door(width / 2, -depth / 2, width * 0.3, -width * 0.62)]
    left, top = number(-width / 2 + 8), number(-depth / 2 + 2.5)
    return [*drawn, path(f"M{left} {top}h{number(width * 0.28)}", "handle")]


def _microwave(thing: SceneObject, width: float, depth: float) -> Drawing:
    inside = "cavity" if thing.open else "lit" if thing.on else "inset"
    window = Rect(-width / 2 + 4, -depth / 2 + 4, width * 0.7, depth - 8)
    dots = [circle(width / 2 - 7, -depth / 4 + at * depth / 4, 1.8, "dot") for at in (0, 1, 2)]
    drawn = [_box(width, depth, "appliance", 4), rect(window, inside, 3), *dots]
    if thing.open:
        drawn.append(_door(-width / 2 + 2, -depth / 2, -width * 0.12, -width * 0.5))
    return drawn


def _coffee(thing: SceneObject, width: float, depth: float) -> Drawing:
    radius = min(width, depth) * 0.2
    spout = circle(0, -depth * 0.2, radius, "lit" if thing.on else "inset")
    return [_box(width, depth, "appliance", 5, 2), spout]


def _toaster(thing: SceneObject, width: float, depth: float) -> Drawing:
    kind = "slot hot" if thing.on else "slot"
    long = width * 0.3
    slots = [line(-long, depth * at, long, depth * at, kind) for at in (-0.17, 0.17)]
    return [_box(width, depth, "appliance", 5), *slots]


def _bin(thing: SceneObject, width: float, depth: float) -> Drawing:
    radius = min(width, depth) * 0.46
    return [circle(0, 0, radius, "appliance"), circle(0, 0, radius * 0.74, "inset")]


def _hamper(thing: SceneObject, width: float, depth: float) -> Drawing:
    radius = min(width, depth) * 0.47
    weave = [
        line(-radius * 0.6, at * radius, radius * 0.6, at * radius, "trimline")
        for at in (-0.4, 0, 0.4)
    ]
    return [
        circle(0, 0, radius, "table"),
        circle(0, 0, radius * 0.76, "cavity" if thing.open else "trim"),
        *weave,
    ]


def _safe(thing: SceneObject, width: float, depth: float) -> Drawing:
    drawn = [
        _box(width, depth, "appliance", 3),
        _box(width, depth, "cavity" if thing.open else "inset", 2, 4),
    ]
    if thing.open:
        drawn.append(_door(width / 2, -depth / 2, width * 0.25, -width * 0.5))
        return drawn
    return [*drawn, circle(0, -depth * 0.1, min(width, depth) * 0.14, "knob")]


def _television(thing: SceneObject, width: float, depth: float) -> Drawing:
    thin = min(depth, max(8.0, depth * 0.3))
    screen = Rect(-width / 2, -thin / 2, width, thin)
    glow = Rect(-width / 2 + 3, -thin / 2 - 2, width - 6, 3.5)
    return [rect(screen, "screen", 2.5), rect(glow, "lit" if thing.on else "inset", 1.5)]


def _desktop(thing: SceneObject, width: float, depth: float) -> Drawing:
    screen = Rect(-width * 0.45, depth * 0.1, width * 0.9, 6)
    keys = Rect(-width * 0.35, -depth * 0.4, width * 0.7, depth * 0.3)
    return [rect(screen, "lit" if thing.on else "screen", 2), rect(keys, "appliance", 2)]


def _sink(thing: SceneObject, width: float, depth: float) -> Drawing:
    return [_box(width, depth, "sink", 8)]


def _basin(thing: SceneObject, width: float, depth: float) -> Drawing:
    kind = "basin water" if thing.filled else "basin"
    return [_box(width, depth, kind, 7, 2), circle(0, 0, 2.6, "drain")]


def _bathtub(thing: SceneObject, width: float, depth: float) -> Drawing:
    inner = _box(width, depth, "basin water" if thing.filled else "basin", 14, 7)
    return [_box(width, depth, "sink", 10), inner, circle(0, -depth / 2 + 18, 2.6, "drain")]


def _tub_basin(thing: SceneObject, width: float, depth: float) -> Drawing:
    return [_box(width, depth, "basin water" if thing.filled else "basin", 12)]


def _faucet(thing: SceneObject, width: float, depth: float) -> Drawing:
    arm = path(f"M0 {number(depth * 0.3)}V{number(-max(depth * 0.45, 10))}", "tap")
    drops = [path(f"M{x} {number(-max(depth * 0.45, 10) - 4)}v-5", "drops") for x in (-3, 3)]
    return [arm, circle(0, depth * 0.3, 4.4, "tapbase"), *(drops if thing.on else [])]


def _toilet(thing: SceneObject, width: float, depth: float) -> Drawing:
    width = min(width, 0.68 * depth)  # some real boxes take in what hangs beside it
    tank = Rect(-width / 2, depth / 2 - depth * 0.26, width, depth * 0.26)
    seat = element(
        "ellipse", class_="sink", cx=0, cy=-depth * 0.12, rx=width * 0.4, ry=depth * 0.37
    )
    bowl = element(
        "ellipse", class_="basin", cx=0, cy=-depth * 0.14, rx=width * 0.26, ry=depth * 0.24
    )
    lid = (
        []
        if thing.open
        else [
            element(
                "ellipse", class_="lid", cx=0, cy=-depth * 0.12, rx=width * 0.34, ry=depth * 0.31
            )
        ]
    )
    return [rect(tank, "sink", 4), seat, bowl, *lid]


def _burner(thing: SceneObject, width: float, depth: float) -> Drawing:
    hot = thing.on or thing.temperature == "Hot"
    kind = "burner on" if hot else "burner"
    radius = min(width, depth) * 0.44
    return [circle(0, 0, radius, f"{kind} plate"), circle(0, 0, radius * 0.5, kind)]


def _knob(thing: SceneObject, width: float, depth: float) -> Drawing:
    notch = line(0, 0, 3 if thing.on else 0, 0 if thing.on else -3, "notch")
    return [circle(0, 0, 3.4, "knob hot" if thing.on else "knob"), notch]


def _lamp(thing: SceneObject, width: float, depth: float) -> Drawing:
    radius = min(width, depth) * 0.4
    far, near = radius * 1.1 + 5, radius * 1.1
    rays = [
        line(x * near, y * near, x * far, y * far, "rays")
        for x, y in ((0, 1), (0, -1), (1, 0), (-1, 0))
    ]
    lit = "lit" if thing.on else "trim"
    return [
        circle(0, 0, radius, "seat"),
        circle(0, 0, radius * 0.5, lit),
        *(rays if thing.on else []),
    ]


def _vacuum(thing: SceneObject, width: float, depth: float) -> Drawing:
    radius = min(width, depth) * 0.4
    hose = path(
        f"M0 {number(-radius)}q{number(radius)} {number(-radius)} {number(radius * 1.2)} 0",
        "trimline",
    )
    return [circle(0, 0, radius, "appliance"), circle(0, 0, radius * 0.4, "inset"), hose]


_SILHOUETTES: dict[str, Silhouette] = {
    "ArmChair": _sofa,
    "Bathtub": _bathtub,
    "BathtubBasin": _tub_basin,
    "Bed": _bed,
    "Cart": _cart,
    "Chair": _seat,
    "CoffeeMachine": _coffee,
    "CoffeeTable": _coffee_table,
    "Desk": _desk,
    "Desktop": _desktop,
    "DogBed": _dog_bed,
    "Faucet": _faucet,
    "FloorLamp": _lamp,
    "Footstool": _cushion,
    "Fridge": _fridge,
    "GarbageCan": _bin,
    "LaundryHamper": _hamper,
    "Microwave": _microwave,
    "Ottoman": _cushion,
    "Safe": _safe,
    "ShelvingUnit": _shelving,
    "Sink": _sink,
    "SinkBasin": _basin,
    "Sofa": _sofa,
    "Stool": _stool,
    "StoveBurner": _burner,
    "StoveKnob": _knob,
    "Television": _television,
    "Toaster": _toaster,
    "Toilet": _toilet,
    "VacuumCleaner": _vacuum,
}
