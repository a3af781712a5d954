"""The room as a tree in words: places, what is there, in which state."""

from collections.abc import Iterator
from dataclasses import dataclass

from reibench.scene import Scene, SceneObject
from reibench.view.containment import around, is_hidden, support
from reibench.view.icons import appearance, icon, inline
from reibench.view.markup import element, text
from reibench.view.plan_parts import opaque_id
from reibench.view.words import described, name, noun, place, states

_FLOOR = "on the floor"


@dataclass(frozen=True)
class _Branch:
    """A thing, how many alike it stands for, and what is in or on it."""

    thing: SceneObject
    count: int
    inside: tuple["_Branch", ...]


def room_list(scene: Scene) -> str:
    """Return the room as nested lists of buttons, without what is in something closed."""
    roots = _branches(None, scene, set())
    places = [branch for branch in roots if branch.inside or not branch.thing.pickupable]
    floor = [branch for branch in roots if branch not in places]
    rows = [_row(branch, scene) for branch in places]
    if floor:
        heading = element("span", _FLOOR, class_="spot-name")
        rows.append(element("li", heading, element("ul", *(_row(each, scene) for each in floor))))
    hand = _in_hand(scene)
    return element("ul", *hand, *rows, class_="tree", aria_label="The room as a list")


def _in_hand(scene: Scene) -> list[str]:
    if scene.held is None:
        return []
    held = element("ul", _row(_Branch(scene.held, 1, ()), scene))
    return [element("li", element("span", "in the robot's hand", class_="spot-name"), held)]


def _branches(parent: SceneObject | None, scene: Scene, seen: set[str]) -> tuple[_Branch, ...]:
    """Return what lies directly in or on `parent` (the room itself if None), by name."""
    found = []
    for thing in _lying(parent, scene):
        if thing.id in seen:
            continue
        seen.add(thing.id)
        found.append(_Branch(thing, 1, _branches(thing, scene, seen)))
    return tuple(_alike(sorted(found, key=lambda branch: name(branch.thing.type))))


def _lying(parent: SceneObject | None, scene: Scene) -> Iterator[SceneObject]:
    for thing in scene.objects:
        if thing.held or thing.type == "Floor" or appearance(thing).drawn_as == "hidden":
            continue
        if is_hidden(thing, scene):
            continue
        under = support(thing, scene)
        if under is not None and under.type == "Floor":
            under = None
        if under is not None and thing in around(under, scene):
            under = None
        if (under.id if under else "") == (parent.id if parent else ""):
            yield thing


def _alike(branches: list[_Branch]) -> Iterator[_Branch]:
    """Merge neighbours of one type and state that hold nothing, like a row of closed drawers."""
    waiting: _Branch | None = None
    for branch in branches:
        same = (
            waiting is not None
            and not waiting.inside
            and not branch.inside
            and waiting.thing.type == branch.thing.type
            and states(waiting.thing) == states(branch.thing)
        )
        if same and waiting is not None:
            waiting = _Branch(waiting.thing, waiting.count + 1, ())
            continue
        if waiting is not None:
            yield waiting
        waiting = branch
    if waiting is not None:
        yield waiting


def _row(branch: _Branch, scene: Scene) -> str:
    thing = branch.thing
    count = f" × {branch.count}" if branch.count > 1 else ""
    shown = list(states(thing))
    if thing.openable and not thing.open and thing.contents is not None:
        shown.append("closed")
    details = element("span", ", ".join(shown), class_="muted") if shown else ""
    button = element(
        "button",
        inline(icon(thing), 18),
        element("span", text(name(thing.type)) + count),
        details,
        type="button",
        aria_label=described(thing, scene) + count,
        data_oid=opaque_id(thing.id),
        data_type=thing.type,
        data_noun=noun(thing.type),
        data_name=name(thing.type),
        data_place=place(thing, scene),
        data_states=", ".join(states(thing)),
    )
    inner = element("ul", *(_row(each, scene) for each in branch.inside)) if branch.inside else ""
    return element("li", button, inner)
