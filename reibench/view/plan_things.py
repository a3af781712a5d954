"""Things and the robot on a floor plan: icons on discs, drawn to be recognised."""

import math
from collections.abc import Collection

from reibench.scene import Scene, SceneObject
from reibench.view.icons import icon
from reibench.view.markup import classes, element, number, text
from reibench.view.plan_geometry import Canvas
from reibench.view.plan_layout import Layout, Spot
from reibench.view.plan_parts import badge, circle, hotspot, label, line, path
from reibench.view.words import name, states

_WEDGE = 76.0
"""Degrees the robot sees at once, as drawn."""


def draw_things(scene: Scene, layout: Layout, focus: Collection[str] = ()) -> str:
    """Return every loose thing, with lines to the true places of those that were pushed far.

    Things whose type is in `focus` are marked.
    """
    leaders, discs = [], []
    for key, spot in layout.spots.items():
        if spot.displaced:
            leaders.append(line(spot.true_x, spot.true_y, spot.x, spot.y, "leader"))
            leaders.append(circle(spot.true_x, spot.true_y, 1.8, "leaderdot"))
        discs.append((bool(spot.carrier), _thing(scene.by_id[key], spot, scene, focus)))
    discs.sort(key=lambda pair: pair[0])
    return "".join(leaders) + "".join(drawn for _, drawn in discs)


def _thing(thing: SceneObject, spot: Spot, scene: Scene, focus: Collection[str]) -> str:
    radius = spot.radius
    drawn = [circle(0, 0, radius + 1.5, "halo"), picture(thing, radius * 1.68)]
    size = 6.5 if radius < 16 else 7.5
    for index, state in enumerate(states(thing)[:2]):
        drawn.append(badge(radius * 0.8 - 13 * index, -radius * 0.8, state, size))
    if spot.pieces > 1:
        drawn.append(circle(radius * 0.75, radius * 0.8, 6.5, "countdot"))
        drawn.append(label(radius * 0.75, radius * 0.8 + 3.2, str(spot.pieces), "count"))
    place = f"translate({number(spot.x)} {number(spot.y)})"
    more = f", {spot.pieces} pieces" if spot.pieces > 1 else ""
    kind = classes("thing", spot=thing.type.removesuffix("Sliced") in focus)
    inner = hotspot(thing, scene, *drawn, kind=kind, more=more)
    return inner.replace("<g ", f'<g transform="{place}" ', 1)


def picture(thing: SceneObject, size: float, x: float = 0.0, y: float = 0.0) -> str:
    """Return the icon of `thing` centred at a point; its initials if there is no icon for it."""
    symbol = icon(thing)
    if not symbol:
        letters = "".join(word[0] for word in name(thing.type).split())[:2].title()
        return label(x, y + 4, letters, "strong")
    return element(
        "use",
        href=f"#{symbol}",
        x=x - size / 2,
        y=y - size / 2,
        width=float(size),
        height=float(size),
    )


def draw_robot(scene: Scene, canvas: Canvas) -> tuple[str, str]:
    """Return what the robot sees, to lie under the things, and the robot itself."""
    pose = scene.agent
    x, y = canvas.point(pose.position.x, pose.position.z)
    turn = math.radians(pose.yaw)
    reach = 0.95 * canvas.scale
    grown = canvas.size.icon / 25
    start, end = turn - math.radians(_WEDGE / 2), turn + math.radians(_WEDGE / 2)
    cone = path(
        f"M0 0L{_polar(reach, start)}A{number(reach)} {number(reach)} 0 0 1 {_polar(reach, end)}Z",
        "cone",
    )
    nose = path(
        f"M{_polar(15 * grown, turn - 0.75)}L{_polar(28 * grown, turn)}"
        f"L{_polar(15 * grown, turn + 0.75)}Z",
        "nose",
    )
    face = element(
        "use",
        href="#g-robot",
        x=-11 * grown,
        y=-11.5 * grown,
        width=22 * grown,
        height=22 * grown,
    )
    place = f"translate({number(x)} {number(y)})"
    body = [nose, circle(0, 0, 16.5 * grown, "body"), face, *_held(scene, grown)]
    holding = f", holding {_held_name(scene)}" if scene.held else ""
    robot = element(
        "g",
        *body,
        class_="robot",
        transform=place,
        data_oid="robot",
        role="img",
        aria_label=f"robot{holding}",
    )
    return element("g", cone, transform=place, data_oid="cone", class_="sight"), robot


def _polar(distance: float, turn: float) -> str:
    return f"{number(distance * math.sin(turn))} {number(-distance * math.cos(turn))}"


def _held_name(scene: Scene) -> str:
    return text(name(scene.held.type)) if scene.held else ""


def _held(scene: Scene, grown: float) -> list[str]:
    if scene.held is None:
        return []
    x, y = 19 * grown, 17 * grown
    drawn = [circle(x, y, 14 * grown, "held"), picture(scene.held, 20 * grown, x, y)]
    shown = states(scene.held)[:2]
    return drawn + [
        badge(x + (11 - 12 * index) * grown, y - 11 * grown, state, 6.0)
        for index, state in enumerate(shown)
    ]
