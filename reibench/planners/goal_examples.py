"""Instructions with the PDDL goals they ask for: the solved examples, and a few with slices."""

import tomllib
from functools import lru_cache
from pathlib import Path

from reibench.planners.examples import examples
from reibench.planners.pddl_goals import Fact
from reibench.planners.pddl_problem import brought_about
from reibench.skill import Skill, parse_skill

GOALS = Path(__file__).parents[2] / "assets" / "examples" / "goals.toml"


@lru_cache(maxsize=1)
def goal_examples() -> tuple[tuple[str, tuple[Fact, ...]], ...]:
    """Return each instruction with its goal, which is what the plan of a solved example does."""
    solved = [(one.instruction, brought_about(_worked(one.plan))) for one in examples()]
    entries = tomllib.loads(GOALS.read_text(encoding="utf-8"))["example"]
    written = [
        (entry["instruction"], tuple(Fact(name, tuple(of)) for name, *of in entry["goal"]))
        for entry in entries
    ]
    return (*solved, *written)


def _worked(plan: str) -> list[Skill]:
    """Return the skills of an example's plan but those that are said to fail."""
    steps = plan.split(", ")
    return [parse_skill(step) for step in _joined(steps) if "(this action failed" not in step]


def _joined(parts: list[str]) -> list[str]:
    """Put together again what a comma inside a failure's message has parted."""
    steps: list[str] = []
    for part in parts:
        if steps and steps[-1].count("(") > steps[-1].count(")"):
            steps[-1] += f", {part}"
        else:
            steps.append(part)
    return steps
