"""Prompting methods: from what the human says to what the planner is told."""

from dataclasses import dataclass
from typing import ClassVar, Protocol

from reibench.artefact import Artefact
from reibench.backends import Backend, Usage
from reibench.dialogue import Dialogue
from reibench.registry import Registry


@dataclass(frozen=True)
class Instruction:
    """What the planner is told."""

    text: str
    original: str
    """The pending instruction as it was said."""
    context: tuple[str, ...] = ()
    """Earlier human utterances the planner is shown; empty where a method keeps them from it."""
    demonstrations: str = ""
    """Solved examples the planner is shown before the dialogue (in-context learning)."""
    notes: str = ""
    """What the robot tells itself between the instruction and the plan (aware prompt, chain of
    thought)."""
    prompt: str = ""
    """What the model was asked in order to restate it, if it was asked."""
    answer: str = ""
    """What it answered, raw."""
    usage: Usage = Usage()
    artefacts: tuple[Artefact, ...] = ()
    """What else was made on the way, e.g. the patterns that opened a gate."""

    @property
    def rewritten(self) -> bool:
        """Whether the planner is told something other than what was said."""
        return self.text != self.original


class Method(Protocol):
    """One way to deal with vague dialogue before planning."""

    title: ClassVar[str]
    """What it is called in menus and on pages."""
    summary: ClassVar[str]
    """What it does, in a line."""

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Turn `dialogue` into an instruction, asking `backend` if need be."""
        ...


methods: Registry[Method] = Registry("method", __name__)
