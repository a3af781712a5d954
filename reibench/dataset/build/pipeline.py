"""The three steps in a row, and the report of what they kept and dropped."""

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field

from reibench.backends import Usage
from reibench.dataset.build.asking import Asker, Price, Unfit
from reibench.dataset.build.assembly import assemble
from reibench.dataset.build.generation import generate
from reibench.dataset.build.processing import process
from reibench.dataset.build.replacement import replace_mentions
from reibench.dataset.build.seeding import SeedInstruction
from reibench.dataset.check import problems
from reibench.dataset.check_levels import level_problems
from reibench.dataset.levels import derive
from reibench.dataset.script_check import script_problems
from reibench.dataset.scripts import Script

STEPS = ("generation", "processing", "replacement", "filter")


@dataclass(frozen=True)
class Outcome:
    """What became of a seed."""

    seed: SeedInstruction
    script: Script | None = None
    step: str = ""
    """Where it was dropped."""
    reason: str = ""
    """Why, in the words that the report counts."""
    detail: str = ""
    """Why, about this very seed."""


def build(
    seeds: Iterable[SeedInstruction], asker: Asker, examples: Sequence[Script]
) -> Iterator[Outcome]:
    """Yield what becomes of each seed: a sound script, or the step that dropped it and why."""
    for seed in seeds:
        yield _build(seed, asker, examples)


def _build(seed: SeedInstruction, asker: Asker, examples: Sequence[Script]) -> Outcome:
    step = STEPS[0]
    try:
        turns = generate(seed, asker, examples)
        step = STEPS[1]
        processed = process(seed, turns, asker)
        step = STEPS[2]
        vague = replace_mentions(seed, turns, asker, examples)
        step = STEPS[3]
        script = assemble(seed, processed, vague, f"model:{asker.name}")
        check(script)
    except Unfit as problem:
        return Outcome(seed, None, step, problem.reason, problem.complaint)
    return Outcome(seed, script)


def check(script: Script) -> None:
    """Raise Unfit with the first thing that is wrong with a script or its nine episodes."""
    episodes = derive(script)
    checks: tuple[Callable[[], list[str]], ...] = (
        lambda: script_problems(script),
        lambda: [found for episode in episodes for found in problems(episode)],
        lambda: [found for _, found in level_problems(episodes)],
    )
    for find in checks:
        if found := find():
            raise Unfit(re.sub(r"'[^']*'|\"[^\"]*\"|\d+", "…", found[0]), found[0])


@dataclass
class Report:
    """How many seeds were kept and dropped, at which step and why, and what it cost."""

    seeds: int = 0
    kept: int = 0
    dropped: Counter[tuple[str, str]] = field(default_factory=Counter)
    """By step and reason."""

    def note(self, outcome: Outcome) -> None:
        """Count an outcome."""
        self.seeds += 1
        if outcome.script:
            self.kept += 1
        else:
            self.dropped[outcome.step, outcome.reason] += 1

    def rows(self) -> list[tuple[str, str, int]]:
        """Return step, reason and count of every drop, in the order of the steps."""
        ordered = sorted(self.dropped.items(), key=lambda item: (_place(item[0][0]), -item[1]))
        return [(step, reason, count) for (step, reason), count in ordered]

    def as_json(self, usage: Usage, asked: int, from_cache: int, price: Price) -> dict[str, object]:
        """Return the report with what was asked and spent."""
        return {
            "seeds": self.seeds,
            "kept": self.kept,
            "dropped": [
                {"step": step, "reason": reason, "count": count}
                for step, reason, count in self.rows()
            ],
            "asked": asked,
            "from_cache": from_cache,
            "prompt_tokens": usage.prompt_tokens,
            "completion_tokens": usage.completion_tokens,
            "seconds": round(usage.seconds, 1),
            "cost": round(price.of(usage), 4),
        }


def _place(step: str) -> int:
    return STEPS.index(step) if step in STEPS else len(STEPS)
