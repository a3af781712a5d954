"""Finding an episode among thousands: by task type, room, level and words."""

from collections.abc import Sequence
from dataclasses import dataclass

from reibench.dialogue import LEVELS, Vagueness
from reibench.episode import Episode
from reibench.skill import in_words
from reibench.view.catalogue import Catalogue
from reibench.view.markup import element, text
from reibench.view.topbar import room_name

MOST = 60
"""Rows shown at once; more would not be read."""


@dataclass(frozen=True)
class Seek:
    """What is looked for; empty parts let everything through."""

    kind: str = ""
    room: str = ""
    level: str = ""
    words: str = ""


def seek(catalogue: Catalogue, wanted: Seek, current: Vagueness) -> list[Episode]:
    """Return the episodes that fit, one a task, at the level wanted or the one shown now."""
    level = next((each for each in LEVELS if str(each) == wanted.level), current)
    words = wanted.words.lower().split()
    found = []
    for episode in catalogue.episodes:
        goal, room = episode.task.goal, episode.task.setup.room
        if episode.vagueness != level or wanted.room not in ("", room):
            continue
        if wanted.kind not in ("", str(goal.task_type)):
            continue
        if all(word in _searched(episode) for word in words):
            found.append(episode)
    return found


def _searched(episode: Episode) -> str:
    goal = episode.task.goal
    named = f"{in_words(goal.object)} {in_words(goal.destination)} {episode.task.id}"
    return f"{episode.dialogue.instruction.text} {named} {episode.task.setup.room}".lower()


def finder(catalogue: Catalogue) -> str:
    """Return the fields to fill in; they are sent once, so that typing goes on undisturbed."""
    kinds = [("", "All task types"), *((str(kind), kind.label) for kind in catalogue.task_types)]
    rooms = [("", "All rooms"), *((room, room_name(room)) for room in catalogue.rooms)]
    levels = [("", "The level shown"), *((str(e), f"{e.reference} · {e.context}") for e in LEVELS)]
    close = element(
        "button", "×", type="button", class_="btn icon quiet", data_do="close-finder",
        aria_label="Close",
    )  # fmt: skip
    field = element(
        "input", type="search", class_="input", data_seek="words", autocomplete="off",
        placeholder="Words of the instruction, a thing, a place", aria_label="Words",
    )  # fmt: skip
    choices = element(
        "div",
        _select("kind", kinds, "Task type"),
        _select("room", rooms, "Room"),
        _select("level", levels, "Level"),
        class_="seeks",
    )
    heading = element("header", element("h2", "Find an episode"), close)
    return element("div", heading, field, choices, id="seek")


def _select(name: str, options: Sequence[tuple[str, str]], label: str) -> str:
    made = [element("option", text(words), value=value) for value, words in options]
    return element("select", *made, class_="native", data_seek=name, aria_label=label)


def found_list(catalogue: Catalogue, wanted: Seek, current: Episode) -> str:
    """Return what was found as buttons, and how much it is."""
    episodes = seek(catalogue, wanted, current.vagueness)
    rows = [_row(episode, current) for episode in episodes[:MOST]]
    more = len(episodes) - len(rows)
    count = f"{len(episodes)} of {len(catalogue.of_task)} tasks"
    if more > 0:
        count += f", the first {MOST} shown"
    if not episodes:
        count = "Nothing fits all of that; take a word or a choice back."
    summary = element("p", text(count), class_="xs muted num", role="status")
    return element("div", summary, element("ul", *rows, class_="found"), id="found")


def _row(episode: Episode, current: Episode) -> str:
    goal = episode.task.goal
    place = f"{goal.task_type.label} · {room_name(episode.task.setup.room)}"
    button = element(
        "button",
        element("b", text(episode.dialogue.instruction.text)),
        element("small", text(place)),
        type="button",
        class_="opt",
        data_open=episode.task.id,
        data_at=str(episode.vagueness),
        aria_current="true" if episode.id == current.id else None,
    )
    return element("li", button)
