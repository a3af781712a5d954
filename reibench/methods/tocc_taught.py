"""Task-oriented context cognition by a model that was taught to restate.

The idea is the paper's, the teaching ours. The paper asks any model to restate the instruction in
its own words, without having been shown how; that is `tocc`. This asks an adapter of a small model
that was taught it on made-up dialogues (`reibench/tuning`), and takes one of six forms of clear
instruction for an answer.
"""

from typing import ClassVar

from reibench.backends import Backend, Prompt, check_adapter
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods
from reibench.methods.restating import grammar, question

LONGEST = 40
"""Tokens of the answer."""


@methods.register("tocc-taught")
class TaughtContextCognition:
    """Let the model's adapter restate the instruction; the planner sees no dialogue."""

    title = "TOCC-taught"
    summary = "the paper's idea, by a small model that was taught to restate"
    adapter: ClassVar[str] = "resolver"

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the clear instruction; raises ModelUnavailable where the model has no adapter."""
        check_adapter(self.adapter, backend)
        original = dialogue.instruction.text
        prompt = Prompt(question(dialogue), adapter=self.adapter)
        answer = backend.generate(prompt, max_tokens=LONGEST, stop=("\n",), grammar=grammar())
        text = answer.text.strip() or original
        sent = answer.prompt or prompt.text
        return Instruction(text, original, prompt=sent, answer=answer.text, usage=answer.usage)
