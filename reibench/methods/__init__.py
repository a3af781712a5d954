"""Prompting methods: from what the human says to what the planner is told."""

from dataclasses import dataclass
from typing import Protocol

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
    prompt: str = ""
    """What the model was asked in order to restate it, if it was asked."""
    answer: str = ""
    """What it answered, raw."""
    usage: Usage = Usage()

    @property
    def rewritten(self) -> bool:
        """Whether the planner is told something other than what was said."""
        return self.text != self.original


class Method(Protocol):
    """One way to deal with vague dialogue before planning."""

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Turn `dialogue` into an instruction, asking `backend` if need be."""
        ...


methods: Registry[Method] = Registry("method", __name__)
