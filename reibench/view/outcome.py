"""How an episode came out: goal conditions as they come true, and a verdict in a sentence."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from reibench.goals import Condition
from reibench.rollout import Record, Status, Step
from reibench.skill import Verb
from reibench.verdict import ErrorKind, error_kind, omitted
from reibench.view.icons import mark
from reibench.view.markup import classes, element, text
from reibench.view.words import a, name, sentence
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
        return Verdict(f"Succeeded in {taken} of {budget} steps", _success(record), "good")
    if record.status == "error":
        broken = "stopped" in record.error or "left before" in record.error
        title = f"Stopped after {taken} steps" if broken else "Something broke"
        return Verdict(
            title, sentence(record.error or "no reason was recorded"), "plain" if broken else "warn"
        )
    kind = error_kind(record)
    spent = f"All {budget} steps are used. " if record.status == "truncated" else ""
    if kind is ErrorKind.OMISSION:
        return Verdict("Failed: object omission", spent + _omission(record), "bad")
    return Verdict("Failed: execution error", spent + _execution(record), "bad")


def _success(record: Record) -> str:
    goals = record.steps[-1].event.goals if record.steps else ()
    return sentence(goals[-1].text) if goals else "The instruction is carried out."


def _omission(record: Record) -> str:
    missing = omitted(record)
    goal = record.episode.task.goal
    lamp = [each for each in missing if each == goal.destination]
    things = [each for each in missing if each not in lamp]
    parts = []
    taken = _first_taken(record)
    if taken and things and taken[0] not in things:
        parts.append(f"{_capital(a(taken[0]))} was picked up at step {taken[1]}.")
    if things:
        parts.append(f"No {' and no '.join(name(each) for each in things)} was ever picked up.")
    if lamp:
        parts.append(f"No {name(lamp[0])} was ever turned on.")
    return " ".join(parts)


def _first_taken(record: Record) -> tuple[str, int] | None:
    for step in record.steps:
        if step.event.success and step.decision.skill.verb is Verb.PICK_UP:
            return step.decision.skill.object, step.number
    return None


def _execution(record: Record) -> str:
    last = record.steps[-1].event.goals if record.steps else ()
    for goal in last:
        if goal.holds:
            continue
        held = any(
            each.text == goal.text and each.holds
            for step in record.steps
            for each in step.event.goals
        )
        ending = "came true, but not for good" if held else "never came true"
        return f"Every object was identified, but “{goal.text}” {ending}."
    return "Every object was identified, but the goal does not hold."


def _capital(words: str) -> str:
    return words[:1].upper() + words[1:]


def verdict_box(found: Verdict, *, wide: bool = False) -> str:
    """Return a verdict as a box, with a mark beside its colour."""
    symbol = {"good": "cooked", "bad": "no", "warn": "no", "plain": "on"}[found.tone]
    badge = element("span", mark(symbol), class_="mk")
    words = element("div", element("strong", text(found.title)), element("p", text(found.sentence)))
    return element("div", badge, words, class_=classes("verdict", found.tone, wide=wide))


def person_verdict(status: Status, record: Record, budget: int) -> Verdict:
    """Return how a person's own episode ended, in words addressed to them."""
    if status == "success":
        return Verdict("Done: the instruction is carried out.", _success(record), "good")
    found = verdict(record, budget=budget)
    if status == "truncated":
        return Verdict(f"All {budget} steps are used.", found.sentence, "bad")
    return Verdict("Not carried out.", found.sentence, found.tone)
