"""The words in which dialogues and the robot's own thoughts stand in prompts."""

from reibench.dialogue import Dialogue

PREVIOUS = "Human previous inquiry (not required to execute): "
PENDING = "Human pending instruction: "
"""Both are the published code's."""
THOUGHT = "Robot thinks: "
"""Begins what the robot tells itself; `Robot:` alone begins a plan."""


def human_turns(dialogue: Dialogue) -> tuple[str, ...]:
    """Return what the human said before the pending instruction.

    As in the published code, the robot's own turns are left out.
    """
    return tuple(turn.text for turn in dialogue.context if turn.speaker == "human")


def conversation(dialogue: Dialogue) -> str:
    """Return context memory and instruction, a line each, as the prompts of appendix C quote."""
    before = "".join(f"{PREVIOUS}{said}\n" for said in human_turns(dialogue))
    return f"{before}{PENDING}{dialogue.instruction.text}"
