"""Task-oriented context cognition by substitution: ours, not the paper's free rewriting.

The model says which expressions of the instruction stand for things to be picked up without
naming them, and for which; code puts the names in their place. Like `tocc` it separates
understanding from planning, and the planner sees no dialogue; unlike `tocc` it cannot lose the
verb or the destination. Which stretches may be an expression is decided by rules
(`expressions.py`), and which objects may be meant by the skill list: the pickable types,
whatever the room.
"""

import re
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from reibench.backends import Backend, Prompt, Usage
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods
from reibench.methods.expressions import PRONOUNS, expressions, request
from reibench.methods.none import human_turns
from reibench.skill import PICKABLE, in_words

EXAMPLES = Path(__file__).parents[2] / "assets" / "examples" / "vague.toml"

FINDING = """\
Each expression of an instruction that stands for a thing to be picked up without naming it is \
listed, in the order in which they stand there.

"""
"""Begins the first question, which needs no dialogue: where are the vague expressions?"""

NAMING = f"""\
A human talks with a household robot and may name things vaguely.
The objects are: {", ".join(in_words(name) for name in PICKABLE)}.

"""
"""Begins the second question: what is meant by each of them?"""

NONE = " none"
MOST = 3
"""Expressions looked for: Stack & Place has two things, and often a pronoun for the second."""


@dataclass(frozen=True)
class Finding:
    """An expression of the instruction and the object it stands for."""

    expression: str
    object: str
    """In words."""


@methods.register("tocc-span")
class SpanSubstitution:
    """Let the model name vague expressions and their objects; substitute them."""

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the instruction with the objects' names in it, its chatter left out."""
        original = dialogue.instruction.text
        asked = request(original)
        spans, found = find_vague(asked, backend)
        if not spans:
            return Instruction(asked, original, usage=found)
        question = ask_what_is_meant(dialogue)
        findings, named = name_each(spans, question, backend)
        answer = " ".join(_meaning(finding) for finding in findings)
        text = substitute(asked, findings)
        return Instruction(text, original, (), question, answer, found + named)


def find_vague(instruction: str, backend: Backend) -> tuple[list[str], Usage]:
    """Let the model list the vague expressions of `instruction`."""
    prefix = _solved()
    text = f"{prefix}Instruction: {instruction}\n"
    options = expressions(instruction)
    spans: list[str] = []
    usage = Usage()
    while options and len(spans) < MOST:
        text += "Expression:"
        choice = backend.choose(
            Prompt(text, fixed=len(prefix)), [NONE, *(f" {option}" for option in options)]
        )
        usage += choice.usage
        if choice.text == NONE:
            break
        spans.append(choice.text.strip())
        text += f"{choice.text}\n"
        options = _after(instruction, spans[-1], options)
    return spans, usage


def _after(instruction: str, span: str, options: Sequence[str]) -> list[str]:
    """Return the options that stand in `instruction` after `span`."""
    rest = instruction.partition(span)[2]
    return [option for option in options if re.search(rf"\b{re.escape(option)}\b", rest)]


@lru_cache(maxsize=1)
def _solved() -> str:
    parts = [FINDING]
    for example in tomllib.loads(EXAMPLES.read_text(encoding="utf-8"))["example"]:
        parts.append(f"Instruction: {example['instruction']}\n")
        parts += [f"Expression: {span}\n" for span in example["expressions"]]
        parts.append(f"Expression:{NONE}\n\n")
    return "".join(parts)


def ask_what_is_meant(dialogue: Dialogue) -> str:
    """Return the second question: the dialogue, with the objects there are before it."""
    turns = (*human_turns(dialogue), dialogue.instruction.text)
    said = "".join(f"Human: {turn}\n" for turn in turns)
    return f"{NAMING}{said}\nWhich household objects are meant in the last line?"


def name_each(
    spans: Sequence[str], question: str, backend: Backend
) -> tuple[tuple[Finding, ...], Usage]:
    """Let the model say what each of `spans` stands for.

    Two descriptions stand for two things; a pronoun after one of them stands for one of those.
    """
    findings: list[Finding] = []
    usage = Usage()
    every = [f" {in_words(name)}" for name in PICKABLE]
    for span in spans:
        before = [f" {finding.object}" for finding in findings]
        pronoun = span.lower() in PRONOUNS
        options = before if before and pronoun else [one for one in every if one not in before]
        begun = " ".join((*map(_meaning, findings), f'By "{span}", the human means the'))
        choice = backend.choose(Prompt(question, len(NAMING), chat=True, begun=begun), options)
        usage += choice.usage
        findings.append(Finding(span, choice.text.strip()))
    return tuple(findings), usage


def _meaning(finding: Finding) -> str:
    return f'By "{finding.expression}", the human means the {finding.object}.'


def substitute(instruction: str, findings: Sequence[Finding]) -> str:
    """Return `instruction` with each expression replaced by its object's name.

    Where only one object was found, the `it` and `them` after it are replaced as well, but for
    what is to be switched on, which is no thing to pick up.
    """
    done, rest = "", instruction
    for finding in findings:
        before, _, rest = rest.partition(finding.expression)
        done += f"{before}the {finding.object}"
    if len({finding.object for finding in findings}) == 1:
        name = f"the {findings[0].object}"
        rest = re.sub(r"(?<!switch )(?<!turn )\b(?:it|them)\b(?!['’])", name, rest)
    return done + rest
