"""What was done, and what can be done now: the right column for a person and for a model."""

import json
from collections.abc import Sequence

from reibench.rollout import Record
from reibench.skill import Skill
from reibench.view.artefacts import made_panel
from reibench.view.likely import last_found, likely
from reibench.view.markup import element, text
from reibench.view.outcome import goal_conditions, person_verdict, verdict, verdict_box
from reibench.view.steps import announcement, budget, step_list
from reibench.watching import Sitting

WAITING = {
    "loading model": "loading the model",
    "restating": "restating the instruction",
    "planning": "thinking about the next step",
}


def record_of(sitting: Sitting) -> Record:
    """Return the record a sitting stands for, with the status it would end in now."""
    return Record(
        id=sitting.id,
        episode=sitting.episode,
        actor=sitting.actor,
        status=sitting.status or "failure",
        start=sitting.start,
        steps=sitting.steps,
        instruction=sitting.instruction,
        closing=sitting.closing,
        error=sitting.error,
    )


def person_panel(sitting: Sitting, *, notice: str = "", solution: Sequence[Skill] = ()) -> str:
    """Return a person's steps, the goal conditions and what can be done besides acting.

    Args:
        sitting: the episode in progress, or just over.
        notice: something to tell, such as that another tab has moved on.
        solution: the expert's skills, if they were asked for.
    """
    over = sitting.status is not None
    parts = [budget(len(sitting.steps), sitting.max_steps)]
    empty = "Nothing done yet. Type an action, or choose a thing in the room."
    parts.append(step_list(sitting.steps, empty=empty))
    if notice:
        parts.append(element("p", text(notice), class_="notice", role="status"))
    if solution:
        parts.append(_solution(solution))
    parts.append(goal_conditions(sitting.start, sitting.steps))
    if sitting.status is not None:
        found = person_verdict(sitting.status, record_of(sitting), sitting.max_steps)
        parts.append(verdict_box(found))
    parts.append(_person_buttons(over=over))
    return _panel(sitting, parts, actor="me", skills=likely(sitting.event.scene, sitting.steps))


def _solution(solution: Sequence[Skill]) -> str:
    items = [element("li", text(skill.text)) for skill in solution]
    title = element("h3", f"The expert's {len(solution)} steps", class_="label")
    return element("section", title, element("ol", *items), class_="solution")


def _person_buttons(*, over: bool) -> str:
    again = element("button", "Start over", type="button", class_="btn quiet", data_do="again")
    solution = element("button", "Solution", type="button", class_="btn", data_do="solution")
    if over:
        last = element(
            "button", "Next episode", type="button", class_="btn primary", data_do="shuffle"
        )
    else:
        last = element(
            "button",
            "Done",
            element("kbd", "Ctrl ↵", class_="hide-m"),
            type="button",
            class_="btn primary done",
            data_do="done",
        )
    gap = element("span", class_="grow")
    return element("div", again, gap, solution, last, class_="row buttons")


def model_panel(
    title: str, model: str, sitting: Sitting | None, *, ready: bool, notice: str = ""
) -> str:
    """Return what a planner did or is doing.

    Args:
        title: what the planner is called, e.g. `SayCan + TOCC`.
        model: name of the language model it asks.
        sitting: its run; None before it was asked to act.
        ready: whether the model is loaded.
        notice: something that went wrong.
    """
    header = element(
        "header",
        element("h2", text(title)),
        element("span", class_="grow"),
        element("span", text(model), class_="xs muted"),
    )
    parts = [header]
    if notice:
        parts.append(element("p", text(notice), class_="notice bad", role="alert"))
    if sitting is None:
        parts.append(_invitation(title, ready=ready))
        return element("section", *parts, class_="act", id="act", aria_label="Actor")
    running = sitting.status is None
    active = WAITING.get(sitting.phase, "") if running else ""
    parts.append(budget(len(sitting.steps), sitting.max_steps))
    parts.append(step_list(sitting.steps, active=active, empty="It did nothing."))
    parts.append(made_panel(sitting.steps, sitting.closing))
    parts.append(goal_conditions(sitting.start, sitting.steps))
    if not running:
        parts.append(verdict_box(verdict(record_of(sitting), budget=sitting.max_steps)))
    parts.append(_model_buttons(running=running))
    return _panel(sitting, parts, actor="model", skills=())


def trouble_panel(words: str) -> str:
    """Return what stands in place of the steps when the page could not be made."""
    notice = element("p", text(words), class_="notice bad", role="alert")
    again = element("button", "Try again", type="button", class_="btn", data_do="retry")
    return element(
        "section", notice, element("div", again, class_="row buttons"), class_="act", id="act"
    )


def _invitation(title: str, *, ready: bool) -> str:
    wait = "" if ready else " The model loads first, which takes a few seconds."
    words = f"{title} reads the dialogue and acts in this room, one step at a time.{wait}"
    start = element("button", "Watch it act", type="button", class_="btn primary", data_do="watch")
    return element("div", element("p", text(words), class_="small"), start, class_="invite")


def _model_buttons(*, running: bool) -> str:
    gap = element("span", class_="grow")
    if running:
        stop = element("button", "Stop", type="button", class_="btn stop", data_do="stop")
        return element("div", gap, stop, class_="row buttons")
    again = element("button", "Watch again", type="button", class_="btn", data_do="watch")
    aside = element(
        "button", "Compare side by side", type="button", class_="btn primary", data_do="compare"
    )
    return element("div", again, gap, aside, class_="row buttons")


def _panel(sitting: Sitting, parts: Sequence[str], *, actor: str, skills: Sequence[Skill]) -> str:
    over = sitting.status is not None
    said = announcement(sitting.steps[-1]) if sitting.steps else ""
    held = sitting.event.scene.held
    return element(
        "section",
        *parts,
        class_="act",
        id="act",
        aria_label="Steps",
        data_sitting=sitting.id,
        data_expected=len(sitting.steps) + 1,
        data_over="true" if over else "false",
        data_running="true" if actor == "model" and not over else "false",
        data_announce=said,
        data_likely=json.dumps([skill.text for skill in skills]),
        data_held=held.type if held else "",
        data_near=last_found(sitting.steps),
    )
