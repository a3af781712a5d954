"""Chain of thought (section 4, appendix C.2): reason step by step, then plan with all of it."""

from reibench.backends import Backend
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods
from reibench.methods.reasoning import OPENING, with_thought

PROMPT = f"""\
{OPENING}
Before planning, I will first identify any referring expressions and reason about their intended \
objects based on the context below, and then restate the instruction with the resolved entities. \
I will think step by step, about one expression of the pending instruction after the other.

{{conversation}}

Step: Identify referring expressions → infer their referents → rewrite the instruction with \
explicit object names."""
"""The wording of appendix C.2, but for its third sentence, which asks for the full chain."""

BEGUN = 'Referring expressions of the human pending instruction: "'
"""Ours: begins the chain where the prompt says it begins."""
LONGEST = 160
"""Tokens of the answer."""


@methods.register("cot")
class ChainOfThought:
    """Let the model reason freely; the planner sees it after the dialogue and instruction."""

    title = "CoT"
    summary = "the model reasons step by step about what is meant; the planner reads that too"

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the instruction as it was said, with the model's reasoning as a note."""
        return with_thought(dialogue, PROMPT, BEGUN, backend, longest=LONGEST)
