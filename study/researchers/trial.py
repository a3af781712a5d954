"""A task that somebody played or plays, step by step."""

from reibench.explanation import explain
from reibench.rollout import Record, Step
from reibench.view.dialogue import conversation
from reibench.view.markup import classes, element, text
from reibench.view.outcome import goal_conditions
from reibench.view.room_panel import room_panel
from reibench.view.steps import step_list
from study.config import Study
from study.people import Person
from study.researchers.frame import link, page, pill

LATEST = -1
"""The step that stands for the latest there is, however many are to come."""


def trial(about: Study, one: Person, record: Record, status: str | None, step: int) -> str:
    """Return a task as it was after one of its steps; one in progress is followed at its latest."""
    steps = record.steps
    at = len(steps) if step == LATEST else min(max(step, 0), len(steps))
    above = [
        ("/admin/", "Studies"),
        (f"/admin/{about.name}", about.title),
        (f"/admin/{about.name}/people/{one.code}", one.code),
    ]
    here = f"/admin/{about.name}/people/{one.code}/{record.id}"
    title = element("h1", text(record.episode.id), " ", pill(status or "in progress"))
    if record.start is None:
        nothing = element("p", "Nothing was kept of this task.", class_="note")
        return page(record.episode.id, above, title, nothing)
    more = link(f"/admin/-/cases?runs={record.id}", "Open as a case", "btn") if status else ""
    scenes = [record.start.scene, *(each.event.scene for each in steps[:at])]
    said = element("section", conversation(record.episode.dialogue), class_="part talking show-re")
    room = element("div", room_panel(scenes, live=False), class_="part")
    done = step_list(steps[:at], empty="Nothing done yet.")
    acted = element("section", done, goal_conditions(record.start, steps[:at]), class_="part act")
    shown = element(
        "div",
        _ways(here, steps, at, over=status is not None),
        element("div", said, room, acted, class_="replay"),
        id="now",
        data_live="true" if status is None and step == LATEST else None,
    )
    head = element("div", element("div", title, _facts(record, status)), more, class_="headline")
    return page(record.episode.id, above, head, shown)


def _facts(record: Record, status: str | None) -> str:
    if status is None:
        words = "Being played now; the page follows while it shows the latest step."
    else:
        ended = "said done" if record.said_done else "did not say done"
        why = "" if status == "success" else f" {explain(record)}"
        words = f"{len(record.steps)} steps, {ended}.{why}"
    return element("p", text(words), class_="muted")


def _ways(here: str, steps: tuple[Step, ...], at: int, *, over: bool) -> str:
    """Return the steps as a row to choose from, and the ways to walk along it."""
    last = len(steps)

    def way(key: str, to: int, words: str, label: str) -> str:
        return element(
            "a", words, href=f"{here}?step={to}", class_="btn sm", data_key=key, aria_label=label,
            title=f"{label} ({key.replace('Arrow', '')})",
        )  # fmt: skip

    marks = [
        element(
            "a",
            str(each.number),
            href=f"{here}?step={each.number}",
            title=str(each.decision.skill),
            class_=classes("mark", no=not each.event.success),
            aria_current="step" if each.number == at else None,
        )
        for each in steps
    ]
    return element(
        "div",
        way("Home", 0, "Start", "To the start"),
        way("ArrowLeft", max(at - 1, 0), "◀", "A step back"),
        way("ArrowRight", min(at + 1, last), "▶", "A step on"),
        way("End", LATEST, "End" if over else "Latest", "To the latest step"),
        element("button", "Play", type="button", class_="btn sm", data_do="play"),
        element("b", f"After step {at} of {last}", class_="num"),
        element("span", *marks, class_="marks"),
        class_="walk",
        data_at=at,
        data_last=last,
    )
