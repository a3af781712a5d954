"""What every part of a floor plan is made of: hot spots, badges, labels."""

import zlib

from reibench.scene import Scene, SceneObject
from reibench.view.containment import is_empty
from reibench.view.markup import classes, element, number, text
from reibench.view.plan_geometry import Rect
from reibench.view.words import described, name, noun, place, states


def opaque_id(object_id: str) -> str:
    """Return an id for the page that stays the same over a run and tells nothing."""
    return f"o{zlib.crc32(object_id.encode()):08x}"


def hotspot(
    thing: SceneObject, scene: Scene, *drawing: str, kind: str = "fix", more: str = ""
) -> str:
    """Return `drawing` as the part of the plan that stands for `thing`.

    The page reads its data attributes for the name shown on hover and for the menu.
    """
    shown = ", ".join([*states(thing), *(["empty"] if is_empty(thing) else [])])
    return element(
        "g",
        *drawing,
        class_=classes(kind, thing.type.lower()),
        tabindex="-1",
        role="button",
        aria_label=described(thing, scene) + more,
        data_oid=opaque_id(thing.id),
        data_type=thing.type,
        data_noun=noun(thing.type),
        data_name=name(thing.type) + more,
        data_place=place(thing, scene),
        data_states=shown,
    )


def rect(area: Rect, kind: str, corner: float = 4.0, **more: str) -> str:
    """Return a rectangle of class `kind`."""
    x, y, width, height = area
    return element(
        "rect", class_=kind, x=x, y=y, width=width, height=height, rx=float(corner), **more
    )


def circle(x: float, y: float, radius: float, kind: str) -> str:
    """Return a circle of class `kind`."""
    return element("circle", class_=kind, cx=x, cy=y, r=float(radius))


def path(commands: str, kind: str, **more: str) -> str:
    """Return a path of class `kind`."""
    return element("path", class_=kind, d=commands, **more)


def line(x: float, y: float, to_x: float, to_y: float, kind: str) -> str:
    """Return a straight line of class `kind`."""
    return path(f"M{number(x)} {number(y)}L{number(to_x)} {number(to_y)}", kind)


def label(x: float, y: float, words: str, kind: str = "", anchor: str = "middle") -> str:
    """Return a short text; y is its baseline."""
    return element("text", text(words), class_=classes("lbl", kind), x=x, y=y, text_anchor=anchor)


def badge(x: float, y: float, state: str, radius: float = 7.5) -> str:
    """Return the mark of a state on its disc."""
    inner = radius * 0.82
    use = element(
        "use", href=f"#b-{state}", x=x - inner, y=y - inner, width=2 * inner, height=2 * inner
    )
    disc = element("circle", cx=x, cy=y, r=radius)
    return element("g", disc, use, class_=f"badge s-{state}")
