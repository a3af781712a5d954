"""Task-oriented context cognition by substitution: ours, not the paper's free rewriting.

The model says which expressions of the instruction stand for things to be picked up, and for
which; code puts the names in their place. Like `tocc` it separates understanding from planning,
and the planner sees no dialogue; unlike `tocc` it cannot lose the verb or the destination. The
object names it may answer with are the pickable types of the skill list, whatever the room.
"""

import re
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

from reibench.backends import Backend, Prompt, Usage
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods
from reibench.methods.none import human_turns
from reibench.skill import FINDABLE, PICKABLE, in_words

HEADER = """\
A human talks and then asks a robot for something. Each expression of the pending instruction \
that stands for a thing to be picked up is listed, with the name of the object it stands for.
"""
PREVIOUS = "Human previous inquiry (not required to execute): "
PENDING = "Human pending instruction: "
EXPRESSION = "The expression:"
OBJECT = "The object:"
NONE = "none"
EXAMPLES = Path(__file__).parents[2] / "assets" / "examples" / "referents.toml"

MOST = 3
"""Expressions looked for: Stack & Place has two things, and often a pronoun for the second."""
LONGEST = 8
"""Words of an expression."""
OPENERS = "a an the this that these those my your our his her their some what whatever".split()
PRONOUNS = "it this that them these those".split()
BREAKS = "and then or but so please before after until while because".split()
"""Words no expression goes beyond."""


@dataclass(frozen=True)
class Finding:
    """An expression of the instruction and the object it stands for."""

    expression: str
    object: str
    """In words."""


@methods.register("tocc-span")
class SpanSubstitution:
    """Let the model name expressions and their objects; substitute them."""

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the instruction with the objects' names in it, its chatter left out."""
        original = dialogue.instruction.text
        said = "".join(f"{PREVIOUS}{turn}\n" for turn in human_turns(dialogue))
        question = f"{said}{PENDING}{original}\n"
        findings, usage = _ask(question, original, backend)
        answer = "".join(f"{EXPRESSION} {f.expression}\n{OBJECT} {f.object}\n" for f in findings)
        text = to_the_point(substitute(original, findings))
        return Instruction(text, original, (), introduction() + question, answer, usage)


def _ask(question: str, original: str, backend: Backend) -> tuple[tuple[Finding, ...], Usage]:
    """Let the model list findings until it says there are no more."""
    prefix = introduction()
    prompt = Prompt(prefix + question, fixed=len(prefix))
    spans = expressions(original)
    names = [f" {in_words(name)}" for name in PICKABLE]
    findings: list[Finding] = []
    usage = Usage()
    while spans and len(findings) < MOST:
        prompt = replace(prompt, text=prompt.text + EXPRESSION)
        span = backend.choose(prompt, [f" {NONE}", *(f" {span}" for span in spans)])
        usage += span.usage
        if span.text.strip() == NONE:
            break
        prompt = replace(prompt, text=f"{prompt.text}{span.text}\n{OBJECT}")
        name = backend.choose(prompt, names)
        usage += name.usage
        prompt = replace(prompt, text=f"{prompt.text}{name.text}\n")
        findings.append(Finding(span.text.strip(), name.text.strip()))
        spans = [other for other in spans if not _overlap(other, span.text.strip())]
    return tuple(findings), usage


def _overlap(one: str, other: str) -> bool:
    return one in other or other in one


@lru_cache(maxsize=1)
def introduction() -> str:
    """Return what the prompt begins with, the same for every instruction."""
    parts = [HEADER]
    for example in tomllib.loads(EXAMPLES.read_text(encoding="utf-8"))["example"]:
        lines = [f"{PREVIOUS}{said}" for said in example["context"]]
        lines.append(PENDING + example["instruction"])
        for span, name in example["answers"]:
            lines += [f"{EXPRESSION} {span}", f"{OBJECT} {name}"]
        parts.append("\n".join((*lines, f"{EXPRESSION} {NONE}\n")))
    return "\n".join((*parts, ""))


def expressions(instruction: str) -> list[str]:
    """Return the stretches of `instruction` that may stand for a thing, in its order.

    They begin with a determiner or `what`, or are a pronoun; they stay within a clause; and they
    do not name a place or a lamp.
    """
    found: dict[str, None] = {}
    for clause in re.split(r"[^\w\s'’-]+", instruction):
        words = clause.split()
        for start, word in enumerate(words):
            opener = word.lower() in OPENERS or word.lower().endswith(("'s", "’s"))
            longest = _until_break(words, start) if opener else start + 1
            for end in range(start + 1, longest + 1):
                span = words[start:end]
                if _may_refer(span, pronoun=len(span) == 1):
                    found.setdefault(" ".join(span))
    return list(found)


def _until_break(words: Sequence[str], start: int) -> int:
    for end in range(start + 1, min(len(words), start + LONGEST)):
        if words[end].lower() in BREAKS:
            return end
    return min(len(words), start + LONGEST)


def _may_refer(span: Sequence[str], *, pronoun: bool) -> bool:
    if pronoun:
        return span[0].lower() in PRONOUNS
    return not _PLACE.fullmatch(" ".join(span[1:]).lower())


_PLACE = re.compile(
    "|".join(in_words(name).lower() for name in FINDABLE if name not in PICKABLE)
    + r"|light|lamp|counter|table|couch|bin|stove|burner"
)


def substitute(instruction: str, findings: Sequence[Finding]) -> str:
    """Return `instruction` with every expression found replaced by its object's name.

    Where all findings are of one object, the remaining `it` and `them` are replaced as well.
    """
    text = instruction
    for finding in findings:
        text = re.sub(
            rf"\b{re.escape(finding.expression)}\b", f"the {finding.object}", text, count=1
        )
    if len({finding.object for finding in findings}) == 1:
        text = re.sub(r"\b(?:it|them)\b(?!['’])", f"the {findings[0].object}", text)
    return text


def to_the_point(text: str) -> str:
    """Return the sentences of `text` that name something a skill can use; all, if none does."""
    sentences = re.split(r"(?<=[.!?])\s+", text)
    useful = [sentence for sentence in sentences if _NAMED.search(sentence)]
    return " ".join(useful or sentences)


_NAMED = re.compile(
    r"\b(?:" + "|".join(in_words(name) for name in FINDABLE) + r")\b", re.IGNORECASE
)
