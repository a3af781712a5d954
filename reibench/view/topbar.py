"""The top of the page: which episode, who acts, which model."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, get_args

from reibench.dialogue import CONTEXTS, REFERENCES, Vagueness
from reibench.episode import Episode
from reibench.scene import Scene
from reibench.view.catalogue import Catalogue
from reibench.view.logo import LOGO
from reibench.view.markup import classes, element, text

Actor = Literal["me", "model", "tocc", "side"]
ACTORS: tuple[Actor, ...] = get_args(Actor)
ACTOR_NAMES: dict[Actor, str] = {
    "me": "Me",
    "model": "Model",
    "tocc": "Model + {method}",
    "side": "Side by side",
}
"""`{method}` is the one a visitor chose."""

_SHUFFLE = (
    '<svg width="16" height="16" viewBox="0 0 16 16" fill="none" stroke="currentColor"'
    ' stroke-width="1.600" stroke-linecap="round" stroke-linejoin="round" aria-hidden="true">'
    '<path d="M1.500 4.500h2.700l6.300 7h4M1.500 11.500h2.700l1.600-1.800M8.600 6.500l1.900-2h4'
    'M12.300 2.300l2.200 2.200-2.200 2.200M12.300 9.300l2.200 2.200-2.200 2.200"/></svg>'
)

_FIND = (
    '<svg width="16" height="16" viewBox="0 0 16 16" fill="none" stroke="currentColor"'
    ' stroke-width="1.600" stroke-linecap="round" aria-hidden="true">'
    '<circle cx="7" cy="7" r="4.500"/><path d="M10.400 10.400l3.800 3.800"/></svg>'
)


@dataclass(frozen=True)
class ModelStatus:
    """The model in use, in a few words."""

    name: str
    words: str
    """E.g. `ready · 0.7 s a step`."""
    tone: Literal["good", "warn", "bad", "busy"] = "good"


def topbar(
    catalogue: Catalogue,
    episode: Episode,
    scene: Scene,
    actor: Actor,
    model: ModelStatus,
    links: Sequence[tuple[str, str]],
    *,
    method: str = "method",
) -> str:
    """Return the pages' bar and the choice of episode and actor under it.

    `method` is what the page calls the prompting method that one actor uses.
    """
    setup = element(
        "div",
        _task_type(catalogue, episode),
        _level_grid(catalogue, episode),
        _room(catalogue, episode, scene),
        element("span", class_="grow"),
        _actors(actor, method),
        class_="setup",
        id="setup",
    )
    top = element(
        "header", _pages(model, links), _folded(episode, actor, method), setup, class_="top"
    )
    return element("div", top, data_episode=episode.id, data_actor=actor, id="choice")


def _pages(model: ModelStatus, links: Sequence[tuple[str, str]]) -> str:
    brand = element("a", LOGO, "REI-Bench", class_="brand", href="/")
    tabs = [
        element("a", text(title), class_="tab", href=href, aria_current="page" if not at else None)
        for at, (title, href) in enumerate(links)
    ]
    pill = element(
        "button",
        element("span", class_=f"dotst {model.tone}"),
        element("span", text(model.name), class_="pill-name"),
        element("span", text(f"· {model.words}"), class_="hide-m"),
        type="button",
        class_="chip pill",
        data_do="shelf",
        title="Models and settings",
        aria_haspopup="dialog",
    )
    theme = element(
        "button",
        "◐",
        type="button",
        class_="btn sm quiet icon",
        data_do="theme",
        aria_label="Light or dark",
        title="Light or dark",
    )
    gear = element(
        "button",
        "⚙",
        type="button",
        class_="btn sm quiet icon",
        data_do="shelf",
        aria_label="Models and settings",
        title="Models and settings",
    )
    return element(
        "nav", brand, element("div", *tabs, class_="tabs"), element("span", class_="grow"),
        pill, gear, theme, class_="nav", aria_label="Pages",
    )  # fmt: skip


def _folded(episode: Episode, actor: Actor, method: str) -> str:
    """Return what a phone shows instead of the whole choice."""
    level = f"{episode.vagueness.reference}, {episode.vagueness.context}"
    words = f"{episode.task.goal.task_type.label} · {level}"
    unfold = element(
        "button",
        element("span", text(words)),
        type="button",
        class_="select grow",
        data_do="setup",
        aria_expanded="false",
        aria_controls="setup",
    )
    options = [
        element("option", _actor_name(each, method), value=each, selected=each == actor)
        for each in ACTORS
    ]
    choice = element(
        "select", *options, class_="native", data_choose="actor", aria_label="Who acts"
    )
    return element("div", unfold, choice, class_="setup-m")


def _task_type(catalogue: Catalogue, episode: Episode) -> str:
    current = episode.task.goal.task_type
    options = [
        element("option", text(kind.label), value=str(kind), selected=kind is current)
        for kind in catalogue.task_types
    ]
    count = f"{len(catalogue.task_types)} types · {len(catalogue.episodes)} episodes"
    return element(
        "div",
        element("label", "Task type", class_="label", for_="task-type"),
        element("select", *options, class_="native wide", id="task-type", data_choose="kind"),
        element("span", count, class_="xs muted"),
        class_="field",
    )


def _level_grid(catalogue: Catalogue, episode: Episode) -> str:
    """Return the nine levels as one radio group: rows of expressions, columns of contexts."""
    offered = catalogue.levels(episode.task.id)
    cells = [element("span"), *(element("span", context, class_="h") for context in CONTEXTS)]
    for reference in REFERENCES:
        cells.append(element("span", reference, class_="v"))
        for context in CONTEXTS:
            level = Vagueness(reference, context)
            chosen = level == episode.vagueness
            cells.append(
                element(
                    "button",
                    type="button",
                    role="radio",
                    aria_checked="true" if chosen else "false",
                    aria_label=f"{reference}, {context}",
                    title=f"{reference}, {context}",
                    tabindex=0 if chosen else -1,
                    disabled=level not in offered,
                    data_level=str(level),
                )
            )
    grid = element(
        "div",
        *cells,
        class_="lv",
        role="radiogroup",
        aria_label="Vagueness: expressions by context",
    )
    return element("div", grid, class_="field")


def _room(catalogue: Catalogue, episode: Episode, scene: Scene) -> str:
    tasks = catalogue.tasks(episode.task.goal.task_type)
    rooms = [room for _, room in tasks]
    options = []
    if episode.task.id not in dict(tasks):  # one that a visitor worded
        here = f"{room_name(episode.task.setup.room)} · own words"
        options.append(element("option", text(here), value=episode.task.id, selected=True))
    for at, (task, room) in enumerate(tasks):
        words = room_name(room)
        if rooms.count(room) > 1:
            words += f" · task {rooms[: at + 1].count(room)}"
        options.append(element("option", text(words), value=task, selected=task == episode.task.id))
    shuffle = element(
        "button",
        _SHUFFLE,
        type="button",
        class_="btn icon",
        data_do="shuffle",
        aria_label="Shuffle: another episode of this level",
        title="Another episode of this level",
    )
    find = element(
        "button",
        _FIND,
        type="button",
        class_="btn icon",
        data_do="find",
        aria_label="Find an episode",
        title="Find an episode",
        aria_haspopup="dialog",
    )
    select = element("select", *options, class_="native room", id="room", data_choose="task")
    return element(
        "div",
        element("label", "Room", class_="label", for_="room"),
        element("span", select, shuffle, find, class_="row"),
        element("span", text(room_size(scene)), class_="xs muted num"),
        class_="field",
    )


def _actors(actor: Actor, method: str) -> str:
    buttons = [
        element(
            "button",
            _actor_name(each, method),
            type="button",
            role="radio",
            aria_checked="true" if each == actor else "false",
            tabindex=0 if each == actor else -1,
            data_actor=each,
        )
        for each in ACTORS
    ]
    group = element("div", *buttons, class_="seg", role="radiogroup", aria_label="Who acts")
    note = element("span", "Same skills, budget and feedback for everyone", class_="xs muted")
    return element("div", element("span", "Who acts", class_="label"), group, note, class_="field")


def _actor_name(actor: Actor, method: str) -> str:
    return text(ACTOR_NAMES[actor].format(method=method))


def room_name(room: str) -> str:
    """Return how a page calls a room: `living-room-1` is `Living room 1`."""
    words = room.replace("-", " ").replace("_", " ")
    return words[:1].upper() + words[1:]


def room_size(scene: Scene) -> str:
    """Return width, depth and number of objects of a room."""
    size = scene.bounds.size
    count = f"{len(scene.objects)} objects"
    if size.x <= 0 or size.z <= 0:
        return count
    return f"{size.x:.1f} × {size.z:.1f} m · {count}"


def episode_chips(episode: Episode) -> str:
    """Return task type, level and room as chips."""
    level = f"{episode.vagueness.reference} · {episode.vagueness.context}"
    words = (episode.task.goal.task_type.label, level, room_name(episode.task.setup.room))
    return "".join(element("span", text(each), class_=classes("chip")) for each in words)
