"""The gated aware prompt (appendix C.1): aware of vagueness only where patterns suggest it.

The robot always says that it will check. That expressions may be vague and can be inferred it says
only when the instruction holds a pattern of implicit referring expressions; which rules look for
them is in `patterns.py`.
"""

from reibench.artefact import Artefact
from reibench.backends import Backend
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods
from reibench.methods.ap import CHECKING, RESOLVING
from reibench.methods.patterns import implicit_patterns
from reibench.methods.wording import THOUGHT, human_turns

OPEN = "It opened: {patterns}."
SHUT = "It stayed shut: no pattern of an implicit referring expression was found."


@methods.register("gated-ap")
class GatedAwarePrompt:
    """Let rules decide whether the aware prompt's second sentence is said; asks no model."""

    title = "Gated AP"
    summary = "the same reminder, but only where rules find a vague expression"

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the instruction as it was said; the artefact `gate` tells which rules fired."""
        said = dialogue.instruction.text
        found = implicit_patterns(said)
        notes = THOUGHT + (f"{CHECKING} {RESOLVING}" if found else CHECKING)
        gate = OPEN.format(patterns=", ".join(map(str, found))) if found else SHUT
        return Instruction(
            said,
            said,
            context=human_turns(dialogue),
            notes=notes,
            artefacts=(Artefact("note", "gate", gate),),
        )
