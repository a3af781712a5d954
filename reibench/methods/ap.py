"""The aware prompt (section 4, appendix C.1): the robot tells itself that words may be vague."""

from reibench.backends import Backend
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods
from reibench.methods.wording import THOUGHT, human_turns

CHECKING = (
    'I will check whether the "Human Pending Instruction" contains implicit or ambiguous '
    "references."
)
RESOLVING = (
    'I understand that "Human Pending Instruction" may include vague referring expressions, and I '
    "can infer their meaning based on context and antecedents in the preceding dialogue."
)
"""Both are the wording of appendix C.1."""


@methods.register("ap")
class AwarePrompt:
    """Put both sentences of the aware prompt into the robot's mouth; asks the model nothing."""

    title = "AP"
    summary = "the robot reminds itself, always, that expressions may be vague"

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the instruction as it was said, with the aware prompt as the robot's note."""
        said = dialogue.instruction.text
        notes = f"{THOUGHT}{CHECKING} {RESOLVING}"
        return Instruction(said, said, context=human_turns(dialogue), notes=notes)
