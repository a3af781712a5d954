"""In-context learning (appendix C.3, 2-shot): solved examples of resolving vague expressions.

Each demonstration identifies and grounds the expressions of a dialogue and rewrites its task
without vagueness. They hold no plan, since each planner has a form of its own for that, and they
were written for this prompt, so that nothing of the data set is in them.
"""

import tomllib
from functools import lru_cache
from pathlib import Path

from reibench.backends import Backend
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods
from reibench.methods.wording import PENDING, PREVIOUS, THOUGHT, human_turns

EXAMPLES = Path(__file__).parents[2] / "assets" / "examples" / "demonstrations.toml"

PROMPT = f"""\
{{before}}{PENDING}{{instruction}}
{THOUGHT}{{meant}} Clear instruction: {{rewritten}}
"""
"""One demonstration; the paper prints none."""
MEANING = 'By "{expression}", the human means the {name}.'


@methods.register("icl")
class InContextLearning:
    """Show the planner two solved examples before the dialogue; asks the model nothing."""

    title = "ICL (2-shot)"
    summary = "two solved examples of finding out what is meant stand before the dialogue"

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the instruction as it was said, with the demonstrations."""
        said = dialogue.instruction.text
        return Instruction(said, said, human_turns(dialogue), demonstrations=demonstrations())


@lru_cache(maxsize=1)
def demonstrations() -> str:
    """Return the solved examples, in the words in which dialogues are told."""
    entries = tomllib.loads(EXAMPLES.read_text(encoding="utf-8"))["example"]
    return "\n".join(
        PROMPT.format(
            before="".join(f"{PREVIOUS}{said}\n" for said in entry["before"]),
            instruction=entry["instruction"],
            meant=" ".join(
                MEANING.format(expression=expression, name=name)
                for expression, name in entry["meant"].items()
            ),
            rewritten=entry["rewritten"],
        )
        for entry in entries
    )
