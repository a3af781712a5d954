"""The words that sentences about failures are made of."""

from reibench.dataset.forms import names
from reibench.faults import STUCK
from reibench.goals import Condition
from reibench.rollout import Record, Step
from reibench.skill import Verb, in_words, with_article


def holds(conditions: tuple[Condition, ...], name: str) -> bool:
    """Return whether the condition of that name holds."""
    return any(one.name == name and one.holds for one in conditions)


def does(step: Step, verb: Verb) -> bool:
    """Return whether a step uses this verb."""
    return step.decision.skill.verb is verb


def is_skill(step: Step, verb: Verb, name: str) -> bool:
    """Return whether a step is this verb with this object."""
    return does(step, verb) and step.decision.skill.object == name


def base(object_type: str) -> str:
    """Return the type of what a slice or a basin is part of."""
    return object_type.removesuffix("Sliced").removesuffix("Cracked").removesuffix("Basin")


def word(object_type: str) -> str:
    """Return what a thing is called."""
    return in_words(base(object_type))


def a(object_type: str) -> str:
    """Return what a thing is called, with its article if it is counted."""
    known = names().get(base(object_type))
    mass = known is not None and known.number == "mass"
    return word(object_type) if mass else with_article(word(object_type))


def times(count: int) -> str:
    """Return `once`, `twice` or `3 times`."""
    return {1: "once", 2: "twice"}.get(count, f"{count} times")


def sentence(words: str) -> str:
    """Return words with a capital letter and a full stop."""
    return words[:1].upper() + words[1:] + ("" if words.endswith((".", "!", "?")) else ".")


def stuck_on(record: Record) -> tuple[str, list[Step]] | None:
    """Return the skill that was refused most often without ever working again, and those steps."""
    refused: dict[str, list[Step]] = {}
    for step in record.steps:
        skill = f"“{step.decision.skill.text}”"
        refused[skill] = [] if step.event.success else [*refused.get(skill, []), step]
    meant = record.episode.task.goal.objects

    def telling(item: tuple[str, list[Step]]) -> tuple[int, bool]:
        return len(item[1]), bool(item[1]) and item[1][0].decision.skill.object in meant

    skill, steps = max(refused.items(), key=telling, default=("", []))
    return (skill, steps) if len(steps) >= STUCK else None


def refused(what: str, steps: list[Step]) -> str:
    """Return that something was refused, how often, from which step on and why at last."""
    why = f": {steps[-1].event.message}" if steps[-1].event.message else ""
    if len(steps) == 1:
        return f"{what} was refused at step {steps[0].number}{why}"
    return f"{what} was refused {times(len(steps))}, from step {steps[0].number} on{why}"
