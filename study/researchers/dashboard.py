"""A study as it stands: its state, who is where, how full its cells are."""

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from statistics import median
from typing import Any

from reibench.dialogue import CONTEXTS, REFERENCES
from reibench.view.markup import classes, element, text
from study.config import Study
from study.people import Person
from study.researchers.frame import ago, lasting, link, page, pill, section, table, tile

STAGES = {
    "consent": "Consent", "tutorial": "Instructions", "practice": "Practice", "quiz": "Quiz",
    "trial": "Task", "after": "Task", "outcome": "Task", "end": "Questions", "over": "–",
}  # fmt: skip


def study(
    about: Study,
    status: Mapping[str, Any],
    people: Sequence[Person],
    token: str,
    *,
    simulated: bool,
) -> str:
    """Return the page of one study.

    Args:
        about: the study.
        status: of its real or simulated people, from `status_of`.
        people: all of them.
        token: what proves that a form is of this page.
        simulated: which of the two are shown.
    """
    shown = [one for one in people if one.simulated == simulated]
    cells = section("Trials held at each level", _cells(about, status["cells"]))
    live = element(
        "div",
        _which(about.name, people, simulated=simulated),
        element("div", *_tiles(about, shown), class_="tiles"),
        cells,
        section("People", _people(about, shown)),
        id="now",
        data_live=True,
    )
    return page(
        about.title,
        [("/admin/", "Studies")],
        _head(about, str(status["state"]), token),
        live,
        section("What came out", _results(about.name)),
    )


def _head(about: Study, state: str, token: str) -> str:
    title = element("h1", text(about.title))
    facts = element(
        "p",
        pill(state),
        link(f"/s/{about.name}", f"/s/{about.name}"),
        element(
            "span",
            text(
                f"{about.trials} tasks each of {about.tasks or 'all'}, {about.design},"
                f" {about.shows}, version {about.version}"
            ),
            class_="muted",
        ),
        class_="facts",
    )
    labels = {
        "open": ("Start", "Take people in"),
        "paused": ("Pause", "Take nobody in; who has begun goes on"),
        "stopped": ("Stop", "Nobody goes on; what was done is kept"),
    }
    buttons = [
        element(
            "button", words, name="state", value=value, class_="btn", title=means,
            disabled=value == state,
        )
        for value, (words, means) in labels.items()
    ]  # fmt: skip
    why = element("input", name="reason", placeholder="Reason (kept)", aria_label="Reason")
    hidden = element("input", type="hidden", name="token", value=token)
    action = f"/admin/{about.name}/state"
    form = element("form", why, *buttons, hidden, method="post", action=action, class_="row")
    return element("div", element("div", title, facts), form, class_="headline")


def _which(name: str, people: Sequence[Person], *, simulated: bool) -> str:
    number = sum(one.simulated for one in people)
    if not number:
        return ""
    ways = (("real", "Real people", len(people) - number), ("simulated", "Simulated", number))
    tabs = [
        element(
            "a",
            text(f"{words} "),
            element("small", str(count)),
            href=f"/admin/{name}?who={who}",
            aria_current="true" if (who == "simulated") == simulated else None,
        )
        for who, words, count in ways
    ]
    return element("nav", *tabs, class_="seg which", aria_label="Whose")


def state_of(one: Person, recent: float) -> str:
    """Return what became of somebody; who has done nothing for `recent` minutes is away."""
    since = datetime.now(UTC) - datetime.fromisoformat(one.seen)
    away = one.state == "active" and since.total_seconds() > 60 * recent
    return "away" if away else one.state


def _tiles(about: Study, people: Sequence[Person]) -> list[str]:
    states = [state_of(one, about.recent_minutes) for one in people]
    finished = [one for one in people if one.state == "finished"]
    planned = f" of {about.people} planned" if about.people else ""
    times = [_minutes(one) for one in finished if one.ended]
    gone = sum(state in ("withdrawn", "no_consent", "failed_check") for state in states)
    return [
        tile(str(states.count("active")), "taking part now"),
        tile(
            str(len(finished)),
            f"finished{planned}",
            len(finished) / about.people if about.people else None,
        ),
        tile(str(states.count("away")), f"away for over {about.recent_minutes:g} min"),
        tile(str(gone), "left, declined or failed the quiz"),
        tile(str(states.count("rejected")), "rejected"),
        tile(_median(times), "median time to finish"),
        tile(str(sum(one.inattentive > 0 for one in people)), "missed an attention check"),
    ]


def _median(minutes: Sequence[float]) -> str:
    if not minutes:
        return "–"
    middle = median(minutes)
    return f"{middle:.0f} min" if middle >= 1.5 else f"{60 * middle:.0f} s"


def _minutes(one: Person) -> float:
    start, end = datetime.fromisoformat(one.arrived), datetime.fromisoformat(one.ended or one.seen)
    return (end - start).total_seconds() / 60


def _cells(about: Study, cells: Mapping[str, int]) -> str:
    """Return the levels as a grid, each as full as it is."""
    planned = about.people * about.trials / max(len(cells), 1)
    most = max([planned, *cells.values(), 1])
    parts = [element("span"), *(element("span", name, class_="hd") for name in CONTEXTS)]
    for reference in REFERENCES:
        parts.append(element("span", reference, class_="hd"))
        for context in CONTEXTS:
            held = cells.get(f"{reference}-{context}")
            if held is None:
                parts.append(element("span", "–", class_="cell none"))
                continue
            words = [element("b", str(held))]
            if planned:
                words.append(element("small", text(f" of {planned:g}")))
            label = f"{reference}, {context}: {held} held"
            parts.append(
                element(
                    "span", *words, class_="cell", style=f"--p:{100 * held / most:.0f}%",
                    role="img", aria_label=label,
                )
            )  # fmt: skip
    return element("div", *parts, class_="levels panel")


def _people(about: Study, people: Sequence[Person]) -> str:
    if not people:
        return element("p", "Nobody has come yet.", class_="note")
    heads = (
        "code", "state", "at", "tasks done", "time #", "mean s a step #", "quiz tries #",
        "checks missed #", "out of sight #", "arrived", "last seen",
    )  # fmt: skip
    return table(heads, [_row(about, one) for one in people], "People")


def _row(about: Study, one: Person) -> list[str]:
    accepted = element("span", "accepted", class_="pill good") if one.accepted else ""
    return [
        link(f"/admin/{about.name}/people/{one.code}", one.code, "code"),
        pill(state_of(one, about.recent_minutes)) + accepted,
        text(at(one)),
        _done(one.trials, about.trials),
        text(lasting(one.arrived, one.ended or one.seen)),
        f"{one.seconds:.1f}" if one.seconds is not None else "–",
        str(one.quiz_tries),
        element("b", str(one.inattentive), class_=classes("", warn=one.inattentive > 0)),
        f"{one.hidden:.0f} s",
        ago(one.arrived),
        ago(one.seen),
    ]


def at(one: Person) -> str:
    """Say where somebody is."""
    words = STAGES.get(one.stage, one.stage)
    return f"{words} {one.place + 1}" if words == "Task" else words


def _done(done: int, all_of_them: int) -> str:
    filled = element("i", style=f"width:{100 * done / all_of_them:.0f}%")
    return element("span", filled, class_="bar wide", aria_hidden="true") + element(
        "span", f" {done} of {all_of_them}", class_="num"
    )


def _results(name: str) -> str:
    ways = (
        (
            f"/admin/{name}/analysis",
            "Analysis",
            "people by level, and beside planners; of finished tasks, also of who is still there",
        ),
        (f"/admin/{name}/analysis?everybody=true", "… with simulated and rejected people", ""),
        (
            f"/admin/{name}/export.zip",
            "Download",
            "as CSV and JSONL with a codebook, without simulated, rejected and withdrawn people",
        ),
        (f"/admin/{name}/export.zip?everybody=true", "… of everybody", ""),
    )
    items = [
        element("li", link(href, words), element("span", text(f" {more}"), class_="muted"))
        for href, words, more in ways
    ]
    return element("ul", *items, class_="ways panel")
