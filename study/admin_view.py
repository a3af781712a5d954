"""What researchers see."""

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from typing import Any

from reibench.pages.head import STYLES, THEME
from reibench.rollout import Record
from reibench.view.dialogue import conversation
from reibench.view.icons import sprite
from reibench.view.markup import element, text
from reibench.view.outcome import goal_conditions
from reibench.view.room_panel import room_panel
from reibench.view.steps import step_list
from study.config import Study
from study.people import Person

REFRESH = 20
"""Seconds after which the list is loaded anew."""


def _page(title: str, *parts: str, refresh: bool = False) -> str:
    links = [f'<link rel="stylesheet" href="/web/css/{name}.css">' for name in (*STYLES, "admin")]
    again = f'<meta http-equiv="refresh" content="{REFRESH}">' if refresh else ""
    head = (
        '<meta charset="utf-8"><meta name="viewport" content="width=device-width">'
        f"<title>{text(title)}</title>{again}{THEME}{''.join(links)}"
    )
    return f'<!doctype html><html lang="en" data-page="admin"><head>{head}</head><body>' + (
        element("main", element("h1", text(title)), *parts, class_="admin") + "</body></html>"
    )


def trouble(words: str) -> str:
    """Return a page that says what is wrong."""
    return _page("That did not work", element("p", text(words), role="alert"), _link("/admin/"))


def _link(href: str, words: str = "All studies") -> str:
    return element("a", text(words), href=href)


def _table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    head = element("tr", *(element("th", text(name), scope="col") for name in heads))
    body = [element("tr", *(element("td", cell) for cell in row)) for row in rows]
    table = element("table", element("thead", head), element("tbody", *body))
    return element("div", table, class_="scrolls", tabindex="0")


def studies(found: Sequence[Mapping[str, Any]]) -> str:
    """Return the list of studies."""
    rows = [
        [_link(f"/admin/{one['name']}", one["name"]), text(one["state"]), text(one["version"])]
        for one in found
    ]
    if not rows:
        how = "There is no study yet. Make one with: python -m study create assets/study/study.toml"
        return _page("Studies", element("p", text(how)))
    cases = element("p", _link("/admin/-/cases", "Cases, with what participants did"))
    return _page("Studies", _table(("study", "state", "version"), rows), cases)


def study(
    about: Study,
    real: Mapping[str, Any],
    simulated: Mapping[str, Any],
    people: Sequence[Person],
    token: str,
) -> str:
    """Return the page of one study: its state, its cells, its people."""
    name = about.name
    planned = f" of {about.people} planned" if about.people else ""
    holding = sum(real["people"].get(state, 0) for state in ("active", "finished"))
    facts = element(
        "p",
        text(
            f"{real['state']}, version {about.version}; {holding} people take part or have"
            f" finished{planned}; {sum(simulated['people'].values())} simulated"
        ),
    )
    return _page(
        about.title,
        _link("/admin/"),
        facts,
        _states(name, str(real["state"]), token),
        element("h2", "People"),
        _people(name, people, about.recent_minutes),
        element("h2", "Trials held at each level"),
        _cells(about, real["cells"]),
        element("h2", "What came out"),
        element("p", _link(f"/admin/{name}/analysis", "Analysis: people by level, and planners")),
        element("h2", "Download"),
        element(
            "p",
            _link(f"/admin/{name}/export.zip", "Everything, as CSV and JSONL with a codebook"),
            " · ",
            _link(f"/admin/{name}/export.zip?everybody=true", "simulated and rejected people too"),
        ),
        refresh=True,
    )


def analysis(name: str, lines: Sequence[str], picture: str, *, everybody: bool) -> str:
    """Return the page with an analysis and its figure, an SVG document of our own."""
    drawn = picture[picture.index("<svg") :]
    other = "" if everybody else "?everybody=true"
    words = "without simulated people" if everybody else "simulated and rejected people too"
    return _page(
        f"Analysis of {name}",
        _link(f"/admin/{name}", "Back to the study"),
        element("p", _link(f"/admin/{name}/analysis{other}", words)),
        element("div", drawn, class_="figure"),
        element("pre", text("\n".join(lines)), class_="scrolls", tabindex="0"),
    )


def _states(name: str, now: str, token: str) -> str:
    labels = {"open": "Start", "paused": "Pause", "stopped": "Stop"}
    buttons = [
        element(
            "button", words, name="state", value=state, class_="btn", disabled=state == now,
        )
        for state, words in labels.items()
    ]  # fmt: skip
    hidden = element("input", type="hidden", name="token", value=token)
    why = element("input", name="reason", placeholder="reason (kept)", aria_label="Reason")
    return element(
        "form", *buttons, why, hidden, method="post", action=f"/admin/{name}/state", class_="row"
    )


def _state_of(one: Person, recent: float) -> str:
    """Return what became of somebody; who has done nothing for long is away."""
    since = datetime.now(UTC) - datetime.fromisoformat(one.seen)
    away = one.state == "active" and since.total_seconds() > 60 * recent
    return "away" if away else one.state


def _people(name: str, people: Sequence[Person], recent: float) -> str:
    if not people:
        return element("p", "Nobody has come yet.", class_="muted")
    heads = (
        "code", "state", "at", "trials", "s a step", "quiz tries", "checks failed", "arrived",
        "last seen",
    )  # fmt: skip
    rows = [
        [
            _link(f"/admin/{name}/people/{one.code}", one.code)
            + (" (simulated)" if one.simulated else ""),
            text(_state_of(one, recent)),
            text(f"{one.stage} {one.place + 1}" if one.stage in ("trial", "after") else one.stage),
            str(one.trials),
            f"{one.seconds:.1f}" if one.seconds is not None else "–",
            str(one.quiz_tries),
            str(one.inattentive),
            text(_short(one.arrived)),
            text(_short(one.seen)),
        ]
        for one in people
    ]
    return _table(heads, rows)


def _short(moment: str) -> str:
    return moment[:19].replace("T", " ")


def _cells(about: Study, cells: Mapping[str, int]) -> str:
    planned = about.people * about.trials / max(len(cells), 1)
    most = max([planned, *cells.values(), 1])
    rows = [
        [
            text(level),
            element(
                "span", element("i", style=f"width:{100 * held / most:.0f}%"), class_="bar wide"
            ),
            text(f"{held} of {planned:.0f}" if planned else str(held)),
        ]
        for level, held in cells.items()
    ]
    return _table(("level", "", "trials"), rows)


def person(name: str, one: Person, trials: Sequence[Mapping[str, Any]], token: str) -> str:
    """Return the page of somebody: their trials, and what can be decided."""
    facts = (
        f"{one.state}, at {one.stage}, place {one.slot}, version {one.version}; arrived"
        f" {_short(one.arrived)}, last seen {_short(one.seen)}"
    )
    rows = [
        [
            text(trial["kind"]),
            str(trial["place"] + 1),
            _link(f"/admin/{name}/people/{one.code}/{trial['record']}", trial["episode"]),
            text(trial["status"] or "in progress"),
            str(trial["steps"]),
        ]
        for trial in trials
    ]
    reason = element("p", text(f"Reason kept: {one.reason}")) if one.reason else ""
    return _page(
        one.code,
        _link(f"/admin/{name}", "Back to the study"),
        element("p", text(facts)),
        reason,
        _decisions(name, one, token),
        element("h2", "Trials"),
        _table(("kind", "number", "episode", "outcome", "steps"), rows),
    )


def _decisions(name: str, one: Person, token: str) -> str:
    offered = ("restore",) if one.state == "rejected" else ("accept", "reject")
    buttons = [
        element("button", what.capitalize(), name="judgement", value=what, class_="btn")
        for what in offered
    ]
    hidden = element("input", type="hidden", name="token", value=token)
    why = element(
        "input", name="reason", placeholder="reason (kept)", required=True, aria_label="Reason"
    )
    action = f"/admin/{name}/people/{one.code}"
    return element("form", why, *buttons, hidden, method="post", action=action, class_="row")


def replay(name: str, code: str, record: Record, step: int) -> str:
    """Return a trial as it was after one of its steps."""
    steps = record.steps
    at = min(max(step, 0), len(steps))
    here = f"/admin/{name}/people/{code}/{record.id}?step="
    ways = element(
        "p",
        _link(f"{here}0", "start"),
        " · ",
        _link(f"{here}{max(at - 1, 0)}", "step before"),
        " · ",
        element("b", f"after step {at} of {len(steps)}"),
        " · ",
        _link(f"{here}{min(at + 1, len(steps))}", "next step"),
        " · ",
        _link(f"{here}{len(steps)}", "end"),
    )
    if record.start is None:
        return _page(record.episode.id, element("p", "Nothing was kept of this trial."))
    scenes = [record.start.scene, *(one.event.scene for one in steps[:at])]
    said = element("section", conversation(record.episode.dialogue), class_="part talking show-re")
    room = element("div", room_panel(scenes, live=False), class_="part")
    done = step_list(steps[:at], empty="Nothing done yet.")
    goals = goal_conditions(record.start, steps[:at])
    acted = element("section", done, goals, class_="part act")
    return _page(
        f"{code}, {record.episode.id}",
        _link(f"/admin/{name}/people/{code}", "Back"),
        element("p", text(f"{record.status}{', said done' if record.said_done else ''}")),
        ways,
        sprite(),
        element("div", said, room, acted, class_="replay"),
    )
