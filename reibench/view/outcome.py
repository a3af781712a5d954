"""How an episode came out: goal conditions as they come true, and a verdict in a sentence."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from reibench.explanation import explain
from reibench.goals import Condition
from reibench.rollout import Record, Status, Step
from reibench.verdict import error_kind
from reibench.view.icons import mark
from reibench.view.markup import classes, element, text
from reibench.view.words import sentence
from reibench.worlds import Event

Tone = Literal["good", "bad", "warn", "plain"]


@dataclass(frozen=True)
class Verdict:
    """How an episode ended, in a title and a sentence."""

    title: str
    sentence: str
    tone: Tone


def since(condition: Condition, steps: Sequence[Step]) -> int | None:
    """Return the step since which `condition` holds without a break; 0 if it did at the start."""
    number = None
    for step in reversed(steps):
        if not any(goal.text == condition.text and goal.holds for goal in step.event.goals):
            return number
        number = step.number
    return number if steps else (0 if condition.holds else None)


def goal_conditions(start: Event, steps: Sequence[Step]) -> str:
    """Return the goal conditions with whether they hold, and since which step."""
    goals = steps[-1].event.goals if steps else start.goals
    met = sum(goal.holds for goal in goals)
    rows = []
    for goal in goals:
        number = since(goal, steps) if goal.holds else None
        box = element("span", mark("cooked") if goal.holds else "", class_=_box(goal.holds))
        words = element("span", text(goal.text), class_="grow")
        when = element("i", f"step {number}") if number else ""
        state = element("span", "true: " if goal.holds else "not yet: ", class_="sr")
        rows.append(element("li", box, state, words, when))
    heading = element(
        "div",
        element("h3", "Goal conditions", class_="label grow"),
        element("span", f"{met} of {len(goals)}", class_="xs muted num"),
        class_="row",
    )
    return element("section", heading, element("ul", *rows), class_="goals")


def _box(holds: bool) -> str:
    return classes("box", y=holds)


def verdict(record: Record, *, budget: int) -> Verdict:
    """Return how `record` ended; `budget` is how many steps it could have taken."""
    taken = len(record.steps)
    if record.status == "success":
        return Verdict(f"Succeeded in {taken} of {budget} steps", explain(record), "good")
    if record.status == "error":
        broken = "stopped" in record.error or "left before" in record.error
        title = f"Stopped after {taken} steps" if broken else "Something broke"
        return Verdict(
            title, sentence(record.error or "no reason was recorded"), "plain" if broken else "warn"
        )
    title = f"Failed: {str(error_kind(record)).replace('-', ' ')}"
    return Verdict(title, explain(record), "bad")


def verdict_box(found: Verdict, *, wide: bool = False) -> str:
    """Return a verdict as a box, with a mark beside its colour."""
    symbol = {"good": "cooked", "bad": "no", "warn": "no", "plain": "on"}[found.tone]
    badge = element("span", mark(symbol), class_="mk")
    words = element("div", element("strong", text(found.title)), element("p", text(found.sentence)))
    return element("div", badge, words, class_=classes("verdict", found.tone, wide=wide))


def person_verdict(status: Status, record: Record, budget: int) -> Verdict:
    """Return how a person's own episode ended, in words addressed to them."""
    if status == "success":
        return Verdict("Done: the instruction is carried out.", explain(record), "good")
    found = verdict(record, budget=budget)
    if record.expired:
        return Verdict("The time is up.", found.sentence, "bad")
    if status == "truncated":
        return Verdict(f"All {budget} steps are used.", found.sentence, "bad")
    return Verdict("Not carried out.", found.sentence, found.tone)
