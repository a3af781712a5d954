"""Sub-goals: how they are written and read, and those of the example plans."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from reibench.episode import TaskType
from reibench.planners.attempts import Attempt
from reibench.skill import Skill, Verb, in_words

MOST_SUBGOALS = 8
TREATING = {
    TaskType.HEAT: "heat the {thing} in the {place}",
    TaskType.COOL: "cool the {thing} in the {place}",
    TaskType.CLEAN: "wash the {thing} in the {place}",
}
SEPARATOR = re.compile(r"[;\n]")
NUMBER = re.compile(r"^\W*(?:\d+\s*[.:)]?\s*)?")


HOLLOW = frozenset(
    "bathtub bowl box cabinet cup drawer fridge microwave mug pan pot safe sink".split()
)
"""What things are put into, not onto."""


@dataclass(frozen=True)
class Stretch:
    """A sub-goal of an example plan, and the steps that reach it."""

    subgoal: str
    attempts: tuple[Attempt, ...]


def read_subgoals(answer: str) -> tuple[str, ...]:
    """Return the sub-goals in a model's answer: no numbers, nothing without words."""
    parts = (NUMBER.sub("", part).strip(" .,") for part in SEPARATOR.split(answer))
    worded = [part for part in parts if re.search(r"[^\W\d_]{2}", part)]
    return tuple(worded[:MOST_SUBGOALS])


def stretches(task_type: TaskType, tried: Sequence[Attempt]) -> Iterator[Stretch]:
    """Divide an example plan into sub-goals.

    Each ends where the hand takes something up, lays it down for good, or a lamp is lit; what is
    put into a device and taken out of it again is one sub-goal.
    """
    begun: list[Attempt] = []
    for at, attempt in enumerate(tried):
        begun.append(attempt)
        following = tried[at + 1 :]
        subgoal = "" if attempt.failure else _reached(task_type, begun, following)
        if subgoal and not _closes(following):
            yield Stretch(subgoal, tuple(begun))
            begun = []
        elif attempt.skill.verb is Verb.CLOSE and not _treated(begun, following):
            inner = _reached(task_type, begun[:-1], following)
            yield Stretch(inner, tuple(begun))
            begun = []


def _closes(following: Sequence[Attempt]) -> bool:
    """Whether the door is shut right after."""
    return bool(following) and following[0].skill.verb is Verb.CLOSE


def _reached(task_type: TaskType, begun: Sequence[Attempt], following: Sequence[Attempt]) -> str:
    """Return the sub-goal that the last step reaches; empty if it only leads there."""
    verb, thing = begun[-1].skill.verb, in_words(begun[-1].skill.object)
    if verb is Verb.TURN_ON and task_type is TaskType.EXAMINE:
        return f"turn on the {thing}"
    if verb is Verb.PICK_UP:
        treated = any(_worked(each, Verb.PUT_DOWN) for each in begun)
        form = TREATING[task_type] if treated else "get the {thing}"
        return form.format(thing=thing, place=_place(begun))
    if verb is Verb.PUT_DOWN and not _treated(begun, following):
        place = _place(begun)
        preposition = "in" if place in HOLLOW else "on"
        return f"put the {thing} {preposition} the {place}"
    return ""


def _treated(begun: Sequence[Attempt], following: Sequence[Attempt]) -> bool:
    """Whether what was put down last is taken up again, treated by then."""
    put = [each.skill.object for each in begun if _worked(each, Verb.PUT_DOWN)]
    taken = [each.skill.object for each in following if each.skill.verb is Verb.PICK_UP]
    return bool(put) and put[-1] in taken


def _worked(attempt: Attempt, verb: Verb) -> bool:
    return attempt.skill.verb is verb and not attempt.failure


def _place(begun: Sequence[Attempt]) -> str:
    trips: list[Skill] = [each.skill for each in begun if each.skill.verb is Verb.FIND]
    return in_words(trips[-1].object) if trips else ""
