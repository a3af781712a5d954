"""Somebody who takes part: what they did and answered, and what can be decided."""

from collections.abc import Mapping, Sequence
from typing import Any

from reibench.view.markup import element, text
from study.config import Study
from study.people import GONE, Person
from study.researchers.dashboard import at, state_of
from study.researchers.frame import ago, lasting, link, page, pill, section, table

Row = Mapping[str, Any]


def person(
    about: Study,
    one: Person,
    trials: Sequence[Row],
    answers: Sequence[Row],
    history: Sequence[Row],
    token: str,
) -> str:
    """Return the page of somebody.

    Args:
        about: the study, in their version.
        one: who it is.
        trials: from `trials_of`.
        answers: from `answers_of`.
        history: from `history_of`.
        token: what proves that a form is of this page.
    """
    simulated = element("span", "simulated", class_="pill") if one.simulated else ""
    accepted = element("span", "accepted", class_="pill good") if one.accepted else ""
    title = element("h1", text(one.code), " ", pill(state_of(one, about.recent_minutes)))
    head = element(
        "div",
        element("div", title, element("p", accepted, simulated, class_="facts")),
        _decisions(about.name, one, token),
        class_="headline",
    )
    done = section("Tasks", _trials(about.name, one, trials))
    return page(
        one.code,
        [("/admin/", "Studies"), (f"/admin/{about.name}", about.title)],
        head,
        _facts(one),
        element("div", done, id="now", data_live=True),
        section("Answers", _answers(about, answers)),
        section("What happened", _history(history)),
    )


def _facts(one: Person) -> str:
    facts = (
        ("at", text(at(one))),
        ("arrived", ago(one.arrived)),
        ("last seen", ago(one.seen)),
        ("time", text(lasting(one.arrived, one.ended or one.seen))),
        ("out of sight", f"{one.hidden:.0f} s"),
        ("a step", f"{one.seconds:.1f} s" if one.seconds is not None else "–"),
        ("quiz tries", str(one.quiz_tries)),
        ("checks missed", str(one.inattentive)),
        ("slot", str(one.slot)),
        ("version", element("code", text(one.version))),
        *((name, element("code", text(value))) for name, value in one.parameters.items()),
    )
    pairs = [element("div", element("dt", text(name)), element("dd", said)) for name, said in facts]
    return element("dl", *pairs, class_="panel")


def _trials(name: str, one: Person, trials: Sequence[Row]) -> str:
    if not trials:
        return element("p", "No task has been begun, or all was deleted.", class_="note")
    rows = [
        [
            text(f"{'Practice' if trial['kind'] == 'practice' else 'Task'} {trial['place'] + 1}"),
            link(f"/admin/{name}/people/{one.code}/{trial['record']}", trial["episode"]),
            pill(trial["status"] or "in progress"),
            text(trial["reason"] or ""),
            str(trial["steps"]),
            f"{trial['seconds'] or 0:.0f} s",
        ]
        for trial in trials
    ]
    heads = ("", "episode", "outcome", "why", "steps #", "time #")
    return table(heads, rows, "Tasks")


def _answers(about: Study, answers: Sequence[Row]) -> str:
    if not answers:
        return element("p", "Nothing has been answered.", class_="note")
    asked = {one.name: one.text for one in (*about.quiz, *about.after_trial, *about.at_end)}
    where = {"quiz": "Quiz, try {attempt}", "after": "After task {place}", "end": "At the end"}
    rows = [
        [
            text(where[row["stage"]].format(attempt=row["attempt"], place=row["place"] + 1)),
            text(asked.get(row["question"], row["question"])),
            text(row["answer"]),
            {1: pill("right"), 0: pill("wrong")}.get(row["right"], ""),
        ]
        for row in answers
    ]
    return table(("", "question", "answer", ""), rows, "Answers")


def _history(history: Sequence[Row]) -> str:
    if not history:
        return element("p", "Nothing was decided yet.", class_="note")
    rows = [[ago(row["created"]), text(row["what"]), text(row["reason"])] for row in history]
    return table(("when", "what", "reason"), rows, "What happened")


def _decisions(name: str, one: Person, token: str) -> str:
    if one.state in GONE:
        return element("p", text(f"{one.code} {GONE[one.state]}."), class_="muted")
    offered = ("restore",) if one.state == "rejected" else ("accept", "reject")
    buttons = [
        element("button", what.capitalize(), name="judgement", value=what, class_="btn")
        for what in offered
    ]
    hidden = element("input", type="hidden", name="token", value=token)
    why = element(
        "input", name="reason", placeholder="Reason (kept)", required=True, aria_label="Reason"
    )
    action = f"/admin/{name}/people/{one.code}"
    return element("form", why, *buttons, hidden, method="post", action=action, class_="row")
