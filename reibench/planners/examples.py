"""Solved examples for prompts, and a rule of thumb for which ones suit an instruction."""

import re
import tomllib
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from reibench.episode import TaskType

PLANS = Path(__file__).parents[2] / "assets" / "examples" / "plans.toml"

CUES = (
    (TaskType.EXAMINE, r"lamp|the light|examine|look at"),
    (TaskType.CLEAN, r"clean\w*|wash\w*|rins\w+|scrub\w*"),
    (TaskType.HEAT, r"heat\w*|hot|warm\w*|microwaved?|cook\w*|bak\w+|toast\w*"),
    (TaskType.COOL, r"cool\w*|cold|chill\w*|refrigerat\w+|ic[ey]d?"),
    (
        TaskType.STACK,
        r"(?:in|on|into|onto) .+ (?:and|then) .+ (?:in|on|into|onto|to) |with .+ in it",
    ),
)
"""Words that give a task type away, the first match counting; none of them means Pick & Place."""


@dataclass(frozen=True)
class Example:
    """An instruction and a plan that carries it out."""

    task_type: TaskType
    instruction: str
    plan: str
    """Skills in words, separated by commas."""


@lru_cache(maxsize=1)
def examples() -> tuple[Example, ...]:
    """Return all examples, those of one task type together."""
    entries = tomllib.loads(PLANS.read_text(encoding="utf-8"))["example"]
    return tuple(
        Example(TaskType[entry["task_type"].upper()], entry["instruction"], entry["plan"])
        for entry in entries
    )


def nearest_type(instruction: str) -> TaskType:
    """Guess the task type from verb cues: a keyword rule (`typ3`), and no understanding."""
    for task_type, cue in CUES:
        if re.search(rf"\b(?:{cue})\b", instruction, re.IGNORECASE):
            return task_type
    return TaskType.PICK


def nearest(instruction: str) -> tuple[Example, ...]:
    """Return the examples of the task type that `instruction` looks like."""
    wanted = nearest_type(instruction)
    return tuple(example for example in examples() if example.task_type is wanted)


def fixed_set() -> tuple[Example, ...]:
    """Return the first two examples of every task type."""
    return tuple(
        example
        for task_type in TaskType
        for example in [one for one in examples() if one.task_type is task_type][:2]
    )
