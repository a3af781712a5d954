"""The instruction alone ("- Context" in the paper's table): the planner sees no dialogue."""

from reibench.backends import Backend
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods


@methods.register("no-context")
class NoContext:
    """Pass on the pending instruction and nothing before it; asks the model nothing."""

    title = "No context"
    summary = "the planner reads the instruction alone, without the dialogue"

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the instruction as it was said, with no context."""
        said = dialogue.instruction.text
        return Instruction(said, said)
