"""No method: the planner is shown what the human said, as it was said."""

from reibench.backends import Backend
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods
from reibench.methods.wording import human_turns


@methods.register("none")
class NoMethod:
    """Pass dialogue and instruction on unchanged; asks the model nothing."""

    title = "No method"
    summary = "the planner reads what was said, as it was said"

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the instruction with the human's earlier turns as its context."""
        said = dialogue.instruction.text
        return Instruction(said, said, context=human_turns(dialogue))
