"""Task-oriented context cognition (section 3.3, appendix C.4): restate the instruction, then plan.

The model rewrites the vague instruction once, before the first step (reading note 6), and the
planner is told the rewriting only.
"""

import re

from reibench.backends import Backend, Prompt
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods
from reibench.methods.wording import conversation

PROMPT = """\
Human pending instruction may contain vague referring expressions, such as "electronic devices", \
"beverages", "fruits", and "containers", which are not specific items.
Use the previous context below to resolve the referring expressions:

{conversation}

Do not add extra commentary or conversation to the whole plan; only output the \
clear instructions."""
"""The wording of appendix C; the lines of the dialogue are the published code's."""

LONGEST = 60
"""Tokens of the answer."""
LABEL = re.compile(
    r"^(?:\d+[.)]\s*|[-*]\s+)?(?:(?:[\w ]*instructions?|human|robot|answer)\s*:\s*)?", re.IGNORECASE
)
"""What a model likes to write before the instruction itself."""


@methods.register("tocc")
class TaskOrientedContextCognition:
    """Let the model restate the instruction in its own words; the planner sees no dialogue."""

    title = "TOCC"
    summary = "the paper's: the model restates the instruction freely, the planner reads only that"

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the rewriting, or the instruction itself where the model says nothing."""
        original = dialogue.instruction.text
        prompt = PROMPT.format(conversation=conversation(dialogue))
        answer = backend.generate(Prompt(prompt, chat=True), max_tokens=LONGEST)
        text = restated(answer.text) or original
        sent = answer.prompt or prompt
        return Instruction(text, original, prompt=sent, answer=answer.text, usage=answer.usage)


def restated(answer: str) -> str:
    """Return the instruction in the model's answer: no announcement, numbers, labels or quotes."""
    lines = (line.strip() for line in answer.splitlines())
    said = (LABEL.sub("", line).strip("\"'`* ") for line in lines if not line.endswith(":"))
    text = " ".join(filter(None, said))
    return text if re.search(r"[^\W\d_]{2}", text) else ""
