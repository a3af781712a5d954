"""Segmented chain of thought (section 4): the steps of appendix C.2 as three short questions.

Each question shows only what it needs: the instruction to find expressions in; the dialogue to
find what they stand for; those referents and the instruction, but no dialogue, to rewrite it.
"""

import re
from collections.abc import Mapping

from reibench.artefact import Artefact
from reibench.backends import Backend, Generation, Usage
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods
from reibench.methods.expressions import LONGEST as WORDS
from reibench.methods.expressions import SUBJECTS
from reibench.methods.reasoning import OPENING, ask, reasoned, thought
from reibench.methods.tocc import restated
from reibench.methods.wording import PENDING, conversation, human_turns

IDENTIFY = f"""\
{OPENING}

{PENDING}{{instruction}}

Step: Identify referring expressions."""
INFER = f"""\
{OPENING}

{{conversation}}

Referring expressions: {{expressions}}

Step: Infer their referents."""
REWRITE = f"""\
{PENDING}{{instruction}}

{{referents}}

Step: Rewrite the instruction with explicit object names."""
"""The three steps and the opening are the wording of appendix C.2."""

EXPRESSIONS = 'The referring expressions are "'
REFERENTS = 'By "{first}", the human means'
REWRITTEN = "Clear instruction:"
"""How the answers begin: ours."""
LONGEST = 48
"""Tokens of each answer."""
LINE = ("\n",)


@methods.register("segmented-cot")
class SegmentedChainOfThought:
    """Let the model identify, infer and rewrite in three calls; the planner reads the outcome."""

    title = "Segmented CoT"
    summary = "three short questions: which expressions, what they mean, the instruction again"

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the instruction as it was said, with referents and rewriting as a note.

        The last question is the instruction's prompt; those before it are artefacts. The chain
        ends where a step finds nothing.
        """
        said = dialogue.instruction.text
        question = IDENTIFY.format(instruction=said)
        asked = {"identify": ask(question, EXPRESSIONS, backend, longest=LONGEST, stop=LINE)}
        expressions = quoted(asked["identify"].text, said)
        referents = rewritten = ""
        if expressions:
            listed = ", ".join(f'"{one}"' for one in expressions)
            question = INFER.format(conversation=conversation(dialogue), expressions=listed)
            begun = REFERENTS.format(first=expressions[0])
            asked["infer"] = ask(question, begun, backend, longest=LONGEST)
            referents = reasoned(question, begun, asked["infer"], LONGEST)
        if referents:
            question = REWRITE.format(instruction=said, referents=referents)
            asked["rewrite"] = ask(question, REWRITTEN, backend, longest=LONGEST, stop=LINE)
            rewritten = restated(asked["rewrite"].text)
        notes = f"{referents} {REWRITTEN} {rewritten}" if rewritten else referents
        return _told(dialogue, thought(notes), asked)


def quoted(answer: str, instruction: str) -> list[str]:
    """Return the expressions that `answer` quotes, its first quote being open already.

    What is no part of the instruction, stands for a person or is a whole clause is left out.
    """
    found = dict.fromkeys(re.findall(r'"([^"]+)"', f'"{answer}'))
    said = instruction.lower()
    return [
        one
        for one in found
        if one.lower() in said and one.lower() not in SUBJECTS and len(one.split()) <= WORDS
    ]


def _told(dialogue: Dialogue, notes: str, asked: Mapping[str, Generation]) -> Instruction:
    *before, last = asked
    artefacts: list[Artefact] = []
    for step in before:
        artefacts.append(Artefact("prompt", f"{step}: asked of the model", asked[step].prompt))
        artefacts.append(Artefact("answer", f"{step}: its answer", asked[step].text))
    said = dialogue.instruction.text
    return Instruction(
        said,
        said,
        context=human_turns(dialogue),
        notes=notes,
        prompt=asked[last].prompt,
        answer=asked[last].text,
        usage=sum((answer.usage for answer in asked.values()), Usage()),
        artefacts=tuple(artefacts),
    )
