"""Short chain of thought (appendix C.2): one step that names referents, then the plan."""

from reibench.backends import Backend
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods
from reibench.methods.reasoning import OPENING, with_thought

PROMPT = f"""\
{OPENING}
Before planning, I will first identify any referring expressions and reason about their intended \
objects based on the context below, and then restate the instruction with the resolved entities.

{{conversation}}

Step: Identify referring expressions → infer their referents → rewrite the instruction with \
explicit object names."""
"""The wording of appendix C.2."""

BEGUN = 'In the human pending instruction, the vague referring expression "'
"""Ours: goes straight to the first expression."""
LONGEST = 80
"""Tokens of the answer."""


@methods.register("short-cot")
class ShortChainOfThought:
    """Let the model think briefly; the planner sees it after the dialogue and instruction."""

    title = "Short CoT"
    summary = "the model thinks briefly about what is meant; the planner reads that too"

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the instruction as it was said, with what the model thought as a note."""
        return with_thought(dialogue, PROMPT, BEGUN, backend, longest=LONGEST)
