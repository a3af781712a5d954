"""No method: the planner is shown what the human said, as it was said.

As in the published code, the robot's own turns are left out.
"""

from reibench.backends import Backend
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods


def human_turns(dialogue: Dialogue) -> tuple[str, ...]:
    """Return what the human said before the pending instruction."""
    return tuple(turn.text for turn in dialogue.context if turn.speaker == "human")


@methods.register("none")
class NoMethod:
    """Pass dialogue and instruction on unchanged; asks the model nothing."""

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the instruction with the human's earlier turns as its context."""
        said = dialogue.instruction.text
        return Instruction(said, said, context=human_turns(dialogue))
