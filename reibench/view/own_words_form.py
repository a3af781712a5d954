"""The form in which visitors word an episode of their own."""

from collections.abc import Sequence

from reibench.episode import TaskType
from reibench.household import load_room, room_names
from reibench.household.controller import Controller
from reibench.household.objects import ROOM_KINDS
from reibench.own_words import Choices, Wording
from reibench.skill import in_words
from reibench.view.markup import element, text
from reibench.view.plan import floor_plan
from reibench.view.plan_geometry import WIDE
from reibench.view.site import select
from reibench.view.topbar import room_name

EXAMPLES = (
    "Human: I have been on my feet since five.\n"
    "Robot: Then sit down. Something fresh would do you good.\n"
    "Human: I could eat that round red thing, if it were warm."
)
"""Shown in the empty field, to say how it is meant."""


def own_words_form(said: Wording, there: Choices, *, trouble: str = "") -> str:
    """Return the page's content.

    Args:
        said: what is filled in.
        there: what a goal can be made of in the room.
        trouble: what is wrong with it.
    """
    parts = (_said(said, trouble), _goal(said, there))
    return element(
        "main",
        element("form", *parts, method="post", action="/own", class_="ownform", id="own"),
        _plan(said.room),
        class_="own",
        id="content",
    )


def _said(said: Wording, trouble: str) -> str:
    """Return the fields for the room and what is said in it."""
    before = element(
        "textarea", text(said.before), name="before", rows=7, placeholder=EXAMPLES, id="before"
    )
    request = element(
        "textarea", text(said.request), name="request", rows=2, id="request",
        placeholder="Put the heated one in there, please.",
    )  # fmt: skip
    return element(
        "div",
        element("h1", "Your own words"),
        element(
            "p",
            "Write what somebody says to a robot, as vaguely as you like. Then see two planners"
            " try: one takes the words as they are, the other first restates them clearly.",
            class_="muted",
        ),
        element("p", text(trouble), class_="notice bad", role="alert") if trouble else "",
        _labelled("Room", _rooms(said.room)),
        _labelled(
            "Said before",
            before,
            "A turn a line. Begin a line with Human: or Robot:, or they take turns.",
        ),
        _labelled("Asked in the end", request),
        class_="words",
    )


def _goal(said: Wording, there: Choices) -> str:
    """Return the fields for what would count as done."""
    kinds = [(str(kind), kind.label) for kind in there.kinds]
    holder = _things("movable", there.holders, said.movable)
    vague = element(
        "input", type="text", name="vague", value=said.vague, maxlength=300,
        placeholder="the heated one, it",
    )  # fmt: skip
    private = (
        "The planners see only the words. What you write, and what they did with it, can"
        " afterwards be read by everybody who opens these pages."
    )
    return element(
        "div",
        element("h2", "What would count as done"),
        element("p", private, class_="muted small"),
        _labelled("Kind of task", select("task_type", "Kind of task", kinds, said.task_type)),
        _labelled("Object that is meant", _things("object", there.objects, said.object)),
        _labelled("… put into first", holder, class_="movable"),
        _labelled("Where it should end", _places(said, there)),
        _labelled(
            "Words that mean the object",
            vague,
            "With commas, as they are above. They are marked on the page; you may leave this out.",
        ),
        element("button", "See both planners try", class_="btn primary big"),
        class_="goal",
    )


def _labelled(words: str, field: str, hint: str = "", *, class_: str = "") -> str:
    told = element("small", text(hint), class_="muted") if hint else ""
    name = element("span", text(words), class_="label")
    return element("label", name, field, told, class_=f"field {class_}".strip())


def _rooms(chosen: str) -> str:
    groups = []
    names = room_names()
    known = {kind.replace(" ", "-"): kind for kind in ROOM_KINDS}
    for stem, kind in known.items():
        mine = [name for name in names if name.rpartition("-")[0] == stem]
        groups.append(_group(f"{kind.capitalize()}s", mine, chosen))
    others = [name for name in names if name.rpartition("-")[0] not in known]
    if others:
        groups.append(_group("Imported", others, chosen))
    return element("select", *groups, name="room", class_="native", id="room")


def _group(label: str, rooms: Sequence[str], chosen: str) -> str:
    options = [
        element("option", text(room_name(name)), value=name, selected=name == chosen)
        for name in rooms
    ]
    return element("optgroup", *options, label=label)


def _things(name: str, types: Sequence[str], chosen: str) -> str:
    options = [("", "choose …"), *((each, in_words(each)) for each in types)]
    return select(name, name, options, chosen)


def _places(said: Wording, there: Choices) -> str:
    """Return places, or lamps; the page's script offers what the kind of task needs."""

    def options(types: Sequence[str]) -> list[str]:
        return [
            element("option", text(in_words(each)), value=each, selected=each == said.destination)
            for each in types
        ]

    first = element("option", "choose …", value="")
    places = element("optgroup", *options(there.places), label="Places")
    lamps = element("optgroup", *options(there.lamps), label="Lamps") if there.lamps else ""
    return element(
        "select",
        first,
        places,
        lamps,
        name="destination",
        class_="native",
        data_lamps_for=str(TaskType.EXAMINE),
    )


def _plan(room: str) -> str:
    scene = Controller(load_room(room)).snapshot()
    plan = floor_plan(scene, size=WIDE, label=f"{room_name(room)}, seen from above")
    caption = element("figcaption", text(f"{room_name(room)}, {len(scene.objects)} objects"))
    return element("figure", plan, caption, class_="ownplan show-names")
