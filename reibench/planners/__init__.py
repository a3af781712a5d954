"""Planners: from an instruction to skills, one decision at a time."""

from collections.abc import Generator
from dataclasses import dataclass
from typing import Protocol, TypeAlias

from reibench.artefact import Artefact
from reibench.backends import Alternative, Usage
from reibench.methods import Instruction
from reibench.registry import Registry
from reibench.skill import Skill
from reibench.worlds import Event


@dataclass(frozen=True)
class Decision:
    """The next skill, and what led to it."""

    skill: Skill
    prompt: str = ""
    usage: Usage = Usage()
    alternatives: tuple[Alternative, ...] = ()
    """The runners-up with their probabilities, the chosen one among them."""
    artefacts: tuple[Artefact, ...] = ()
    """What the planner made since the decision before: its graph, memory, PDDL, plan."""


@dataclass(frozen=True)
class Closing:
    """What led a planner to say that it is done; fields as in `Decision`."""

    prompt: str = ""
    usage: Usage = Usage()
    alternatives: tuple[Alternative, ...] = ()
    artefacts: tuple[Artefact, ...] = ()


Plan: TypeAlias = Generator[Decision, Event, Closing | None]
"""Yields a decision, is sent its event, and returns when the planner thinks it is done."""


class Planner(Protocol):
    """A way to choose skills.

    One that asks a model also has a `title`, what pages call it, and a `summary`, what it does in
    a few words.
    """

    def plan(self, instruction: Instruction, start: Event, skills: tuple[Skill, ...]) -> Plan:
        """Start a plan for `instruction` over `skills`.

        `start` is the event of the reset. Planners that read only text ignore its scene; the
        expert reads it, and so may not be compared with the others.
        """
        ...


planners: Registry[Planner] = Registry("planner", __name__)
