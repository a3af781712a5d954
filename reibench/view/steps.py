"""What was done: steps with their outcome, and how much of the budget is used."""

from collections.abc import Sequence

from reibench.planners import Decision
from reibench.rollout import Step
from reibench.view.artefacts import thoughts
from reibench.view.icons import mark
from reibench.view.markup import classes, element, number, text
from reibench.view.words import sentence

_WORTH_SAYING = 0.01
"""Probability from which on a runner-up is shown."""


def budget(used: int, most: int) -> str:
    """Return the bar that says how many steps of the budget are used."""
    fill = element("i", style=f"width:{number(100 * used / max(most, 1))}%")
    bar = element(
        "span",
        fill,
        class_="bar",
        role="progressbar",
        aria_label="Steps used",
        aria_valuenow=used,
        aria_valuemin=0,
        aria_valuemax=most,
    )
    count = element("span", f"{used} of {most}", class_="xs muted num")
    return element("div", element("h3", "Steps", class_="label"), bar, count, class_="row budget")


def step_list(steps: Sequence[Step], *, active: str = "", empty: str = "") -> str:
    """Return the steps, newest last.

    Args:
        steps: what was done so far.
        active: what is going on now, e.g. `planning`; shown with a pulse.
        empty: what to say while nothing has been done.
    """
    prompts = ["", *(step.decision.prompt for step in steps)]
    rows = [
        _row(step, now=step is steps[-1] and not active, before=before)
        for step, before in zip(steps, prompts, strict=False)
    ]
    if active:
        pulse = element("span", class_="pulse", aria_hidden="true")
        waiting = element("span", text(active), element("span", class_="clock num"))
        rows.append(element("li", element("span", class_="n"), pulse, waiting, class_="step wait"))
    if not rows and empty:
        return element("div", element("p", text(empty), class_="muted small"), class_="stepscroll")
    return element("div", element("ol", *rows, class_="steps"), class_="stepscroll", tabindex="0")


def _row(step: Step, *, now: bool, before: str) -> str:
    done = step.event.success
    sign = element("span", mark("cooked" if done else "no"), class_=classes("mk", no=not done))
    said = element("small", text(sentence(step.event.message))) if step.event.message else ""
    outcome = element("span", "" if done else "refused: ", class_="sr")
    words = element(
        "span",
        element("b", text(step.decision.skill.text)),
        outcome,
        said,
        _alternatives(step.decision),
    )
    return element(
        "li",
        element("span", str(step.number), class_="n"),
        sign,
        words,
        thoughts(step, before),
        class_=classes("step", fail=not done, now=now),
    )


def _alternatives(decision: Decision) -> str:
    """Return how sure a model was, and what it would have done instead."""
    if not decision.alternatives:
        return ""
    chosen, others = "", []
    for option in decision.alternatives:
        share = f"{100 * option.probability:.0f} %"
        if option.text.strip() == decision.skill.text:
            chosen = f"{share} sure"
        elif option.probability >= _WORTH_SAYING:
            others.append(f"{option.text.strip()} {share}")
    words = " · ".join(filter(None, (chosen, *others[:2])))
    return element("small", text(words), class_="odds")


def announcement(step: Step) -> str:
    """Return what a screen reader says of a step."""
    outcome = "done" if step.event.success else "refused"
    said = f"Step {step.number}, {step.decision.skill.text}: {outcome}."
    return f"{said} {sentence(step.event.message)}".strip()
