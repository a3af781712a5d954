"""Example plans step by step, and how they look before and after something fails."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from reibench.planners.examples import Example, examples
from reibench.skill import Skill, Verb, parse_skill

STEP = re.compile(r"([^,(]+?)(?: \(this action failed: ([^)]*)\))?(?:, |$)")


@dataclass(frozen=True)
class Attempt:
    """A skill that was tried, and why it failed if it did."""

    skill: Skill
    failure: str = ""


@dataclass(frozen=True)
class Setback:
    """A moment when a skill has failed."""

    done: tuple[Skill, ...]
    """What had worked before."""
    failed: Attempt
    expected: tuple[Skill, ...]
    """What was still to follow, the failed skill first, as it was thought before the failure."""


OUTSET = Setback((), Attempt(Skill(Verb.FIND, "")), ())
"""Before anything was done: nothing failed."""


def attempts(example: Example) -> tuple[Attempt, ...]:
    """Return the steps of an example's plan."""
    found = STEP.findall(example.plan)
    return tuple(Attempt(parse_skill(text), failure) for text, failure in found)


def with_shut_place(shown: Sequence[Example]) -> tuple[Example, ...]:
    """Return `shown`, after an example of a place that is shut if none of them has one.

    What fails at the end of a plan is mended otherwise than what fails at its beginning.
    """
    if not any(" put down " in one.plan for one in shown) or any(map(_finds_shut, shown)):
        return tuple(shown)
    return (next(filter(_finds_shut, examples())), *shown)


def _finds_shut(example: Example) -> bool:
    """Whether something cannot be put down because the place for it is closed."""
    return any(each.failure and each.skill.verb is Verb.PUT_DOWN for each in attempts(example))


def foreseen(tried: Sequence[Attempt]) -> tuple[Skill, ...]:
    """Return the plan one would make who expects no failure: without what mends them."""
    skills: list[Skill] = []
    at = 0
    while at < len(tried):
        if tried[at].failure:
            at = _mended(tried, at)
        skills.append(tried[at].skill)
        at += 1
    return tuple(skills)


def setbacks(tried: Sequence[Attempt]) -> Iterator[tuple[Setback, tuple[Skill, ...]]]:
    """Yield each failure in a plan, and what remains then, as far as one knows by it."""
    for at, attempt in enumerate(tried):
        if attempt.failure:
            done = tuple(each.skill for each in tried[:at] if not each.failure)
            mended = _mended(tried, at)
            mending = tuple(each.skill for each in tried[at + 1 : mended])
            expected = foreseen(tried[mended:])
            yield Setback(done, attempt, expected), (*mending, *expected)


def _mended(tried: Sequence[Attempt], at: int) -> int:
    """Return where the skill that fails at `at` is tried again, and works."""
    again = (n for n in range(at + 1, len(tried)) if tried[n].skill == tried[at].skill)
    return next(again)
