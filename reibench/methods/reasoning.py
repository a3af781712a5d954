"""Asking a model to reason about an instruction, and keeping what of its answer is of use."""

import re
from collections.abc import Sequence

from reibench.backends import Backend, Generation, Prompt
from reibench.dialogue import Dialogue
from reibench.methods import Instruction
from reibench.methods.wording import THOUGHT, conversation, human_turns

OPENING = 'The "Human Pending Instruction" may contain vague referring expressions.'
"""Begins the prompt of appendix C.2."""
STOPS = ("\nHuman", "\nRobot", "\nStep:")
"""What a model without a chat template goes on with when it has said what it has to say."""
MARKS = re.compile(r"^(?:#+\s*|\d+[.)]\s+|[-*•]\s+)+")
"""List marks, which the planner need not see."""
END = r"(?<!\bDr)(?<!\bMr)(?<!\bMrs)(?<!\bMs)[.!?]"
"""The end of a sentence, and no title's."""
BREAK = re.compile(rf"(?<={END})\s+|(?<={END}[\"”])\s+")
NAME = 3
"""Words that may be a name or an expression, and are no copy of what was said."""


def ask(
    question: str, begun: str, backend: Backend, *, longest: int, stop: Sequence[str] = STOPS
) -> Generation:
    """Ask `question`; the answer goes on from `begun`, within `longest` tokens.

    The beginning makes models of both kinds answer to the point: one with a chat template finds
    its turn begun, one without reads it as a form to be filled in.
    """
    prompt = Prompt(f"{question}\n", chat=True, begun=begun)
    return backend.generate(prompt, max_tokens=longest, stop=stop)


def reasoned(question: str, begun: str, answer: Generation, longest: int) -> str:
    """Return the whole sentences of an answer in one line, `begun` before them; none if it rambles.

    A sentence that was cut off by the limit is left out, and so are those said before, in the
    question or in the answer, and announcements of something that does not come. An answer that
    for the greater part repeats is not worth keeping.
    """
    pieces = _pieces(answer.text, cut_off=answer.usage.completion_tokens >= longest)
    known = _plain(question)
    kept: list[str] = []
    for piece in pieces:
        copied = _plain(piece) in known and len(piece.split()) > NAME
        if not copied and piece not in kept:
            kept.append(piece)
    if kept and kept[-1].endswith(":"):
        kept.pop()
    if not kept or 2 * len(kept) < len(pieces):
        return ""
    if kept[0] != pieces[0]:
        return " ".join(kept)
    joint = "" if begun.endswith('"') else " "
    return f"{begun}{joint}{' '.join(kept)}"


def thought(reasoning: str) -> str:
    """Return the robot's note, a line for the planner's prompt; empty if there is nothing in it."""
    return f"{THOUGHT}{reasoning}" if reasoning else ""


def with_thought(
    dialogue: Dialogue, prompt: str, begun: str, backend: Backend, *, longest: int
) -> Instruction:
    """Return the instruction as it was said after the dialogue, with what the model thinks of both.

    `prompt` is asked with the conversation in it; the answer goes on from `begun`, within `longest`
    tokens, and what is of use in it becomes a note.
    """
    said = dialogue.instruction.text
    question = prompt.format(conversation=conversation(dialogue))
    answer = ask(question, begun, backend, longest=longest)
    return Instruction(
        said,
        said,
        context=human_turns(dialogue),
        notes=thought(reasoned(question, begun, answer, longest)),
        prompt=answer.prompt,
        answer=answer.text,
        usage=answer.usage,
    )


def _pieces(answer: str, *, cut_off: bool) -> list[str]:
    """Return the sentences of an answer, a line without a full stop being one."""
    lines = [MARKS.sub("", line.strip().replace("**", "")) for line in answer.splitlines()]
    pieces = [piece for line in lines for piece in BREAK.split(line)]
    if cut_off and pieces and not re.search(rf"{END}[\"”]?$", pieces[-1]):
        pieces.pop()
    return [piece for piece in pieces if re.search(r"[^\W\d_]{2}", piece)]


def _plain(text: str) -> str:
    return " ".join(re.findall(r"\w+", text.lower()))
