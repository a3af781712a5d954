"""The floor plan: a room from above, furniture to scale, things to be recognised."""

from collections.abc import Collection

from reibench.scene import Scene
from reibench.view.containment import is_hidden
from reibench.view.icons import appearance, mark
from reibench.view.markup import classes, element
from reibench.view.plan_fronts import draw_fronts, group_fronts
from reibench.view.plan_furniture import furniture
from reibench.view.plan_geometry import WIDE, Size
from reibench.view.plan_layout import Layout, lay_out
from reibench.view.plan_things import draw_robot, draw_things
from reibench.view.plan_trays import names, trays
from reibench.view.plan_walls import draw_walls, room_shell
from reibench.view.words import STATES, states

__all__ = ["floor_plan", "legend"]


def floor_plan(
    scene: Scene,
    layout: Layout | None = None,
    *,
    size: Size = WIDE,
    label: str = "The room from above",
    focus: Collection[str] = (),
) -> str:
    """Return the room as an SVG drawing.

    Args:
        scene: the room at one moment.
        layout: where things are drawn, as `arrange` follows them over a run, so that a step moves
            only what it moved; worked out from `scene` alone if None.
        size: how large the drawing is; ignored when there is a layout.
        label: what a screen reader calls it.
        focus: object types that stand out, all others pale; none means all alike.
    """
    layout = layout or lay_out(scene, size)
    canvas = layout.canvas
    standing, hanging = furniture(scene, canvas)
    low, high = draw_fronts(scene, canvas)
    sight, robot = draw_robot(scene, canvas)
    boxes, taken = trays(scene, layout)
    layers = [
        room_shell(canvas),
        draw_walls(scene, canvas),
        standing,
        low,
        hanging,
        high,
        sight,
        draw_things(scene, layout, focus),
        robot,
        boxes,
    ]
    if canvas.size == WIDE:
        layers.append(names(scene, layout, taken))
    return element(
        "svg",
        *layers,
        class_=classes("plan", canvas.size.name, focused=bool(focus)),
        viewbox=f"0 0 {canvas.width:.0f} {canvas.height:.0f}",
        width=round(canvas.width),
        height=round(canvas.height),
        role="group",
        aria_label=label,
    )


def legend(scene: Scene, layout: Layout) -> str:
    """Return what the marks and shapes mean, only those that are there now."""
    shown = {
        state
        for thing in scene.objects
        if appearance(thing).drawn_as not in ("wall", "hidden") and not is_hidden(thing, scene)
        for state in states(thing)
    }
    entries = [
        element("span", _disc(state), state, class_=f"s-{state}")
        for state in STATES
        if state in shown
    ]
    fronts = group_fronts(scene, layout.canvas)
    low = [front for front in fronts if not front.hanging and front.things[0].type != "Shelf"]
    if any(front.hanging and front.things[0].type == "Cabinet" for front in fronts):
        entries.append(_shape("wallcabbox", "wall cabinet"))
    if any(front.things[0].type == "Shelf" for front in fronts):
        entries.append(_shape("wallcabbox", "shelf"))
    if low:
        entries.append(_shape("frontbox", "doors, drawers"))
    if any(len(front.things) > 1 for front in low):
        count = element("span", "4", class_="stackmark", aria_hidden="true")
        entries.append(element("span", count, "stacked"))
    return element("div", *entries, class_="legend", aria_label="Legend")


def _disc(state: str) -> str:
    return element("i", mark(state), class_="statemark")


def _shape(kind: str, words: str) -> str:
    box = element("rect", x=1, y=2, width=14, height=8, rx=2, class_=kind)
    picture = element("svg", box, viewbox="0 0 16 12", width=18, aria_hidden="true")
    return element("span", picture, words)
