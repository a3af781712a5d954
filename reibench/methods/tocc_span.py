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
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from reibench.artefact import Artefact
from reibench.backends import Backend, Prompt, Selection, Usage
from reibench.dialogue import Dialogue
from reibench.methods import Instruction, methods
from reibench.methods.expressions import (
    PRONOUNS,
    Candidate,
    candidates,
    names_a_thing,
    request,
)
from reibench.methods.wording import human_turns
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
SURE = 0.9
"""How probable `none` must be: the rules that propose an expression are right more often."""


@dataclass(frozen=True)
class Span:
    """An expression and where in the instruction it stands."""

    start: int
    text: str

    @property
    def end(self) -> int:
        """Offset behind it."""
        return self.start + len(self.text)


@methods.register("tocc-span")
class SpanSubstitution:
    """Let the model name vague expressions and their objects; substitute them."""

    title = "TOCC-span"
    summary = "ours: the model says what each vague expression stands for, code puts that in place"

    def instruct(self, dialogue: Dialogue, backend: Backend) -> Instruction:
        """Return the instruction with the objects' names in it, its chatter left out.

        The last question is the instruction's prompt; those before it are artefacts.
        """
        original = dialogue.instruction.text
        asked = request(original)
        spans, finding = find_vague(asked, backend)
        if not spans:
            return Instruction(
                asked, original, usage=_cost(finding), artefacts=tuple(_kept(finding))
            )
        naming = name_each(spans, ask_what_is_meant(dialogue), backend)
        objects = [choice.text.strip() for choice in naming]
        further = (*_kept(finding), *_kept(naming[:-1]))
        return Instruction(
            substitute(asked, spans, objects),
            original,
            prompt=naming[-1].prompt,
            answer=" ".join(map(_meaning, spans, objects)),
            usage=_cost(finding) + _cost(naming),
            artefacts=further,
        )


def _cost(choices: Sequence[Selection]) -> Usage:
    return sum((choice.usage for choice in choices), Usage())


def _kept(choices: Sequence[Selection]) -> Iterator[Artefact]:
    for choice in choices:
        yield Artefact("prompt", "asked of the model", choice.prompt)
        yield Artefact("answer", "chosen", choice.text)


def find_vague(instruction: str, backend: Backend) -> tuple[list[Span], list[Selection]]:
    """Let the model say which candidates are expressions for a thing, and how far they reach.

    Its choices are returned beside them.
    A pronoun is only asked about while nothing else is found, and `none` is no answer to all
    questions unless something that can be picked up is named.
    """
    proposed = candidates(instruction)
    spans: list[Span] = []
    choices: list[Selection] = []
    for candidate in proposed:
        inside = bool(spans) and candidate.start < spans[-1].end
        if inside or (candidate.pronoun and spans):
            continue
        options = (*candidate.spans, NONE.strip())
        choices.append(_choose_span(instruction, spans, options, backend))
        if chosen := _chosen(choices[-1]):
            spans.append(Span(candidate.start, chosen))
    if proposed and not spans and not names_a_thing(instruction):
        every = [span for candidate in proposed for span in candidate.spans]
        choices.append(_choose_span(instruction, spans, every, backend))
        chosen = _chosen(choices[-1])
        spans.append(Span(instruction.index(chosen), chosen))
    return spans + _pronouns_after(spans, proposed), choices


def _choose_span(
    instruction: str, before: Sequence[Span], options: Sequence[str], backend: Backend
) -> Selection:
    prefix = _solved()
    listed = "".join(f"Expression: {span.text}\n" for span in before)
    text = f"{prefix}Instruction: {instruction}\n{listed}Expression:"
    return backend.choose(Prompt(text, fixed=len(prefix)), [f" {one}" for one in options])


def _chosen(choice: Selection) -> str:
    """Return what was chosen, or nothing if the model is sure that it is none of the options."""
    if choice.text != NONE:
        return choice.text.strip()
    none = next((other for other in choice.alternatives if other.text == NONE), None)
    others = [other.text for other in choice.alternatives if other.text != NONE]
    if none is None or none.probability >= SURE or not others:
        return ""
    return others[0].strip()


def _pronouns_after(spans: Sequence[Span], proposed: Sequence[Candidate]) -> list[Span]:
    """Return the first pronoun after two things: it stands for one of them."""
    if len(spans) < 2:
        return []
    return [
        Span(candidate.start, candidate.spans[0])
        for candidate in proposed
        if candidate.pronoun and candidate.start > spans[1].end
    ][:1]


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


def name_each(spans: Sequence[Span], question: str, backend: Backend) -> list[Selection]:
    """Let the model say what each of `spans` stands for, in words.

    Two descriptions stand for two things; a pronoun after them stands for one of those.
    """
    objects: list[str] = []
    choices: list[Selection] = []
    every = [in_words(name) for name in PICKABLE]
    for span in spans:
        repeats = bool(objects) and span.text.lower() in PRONOUNS
        options = objects if repeats else [name for name in every if name not in objects]
        begun = " ".join((*map(_meaning, spans, objects), _meaning(span, "")))
        prompt = Prompt(question, len(NAMING), chat=True, begun=begun)
        choices.append(backend.choose(prompt, [f" {name}" for name in options]))
        objects.append(choices[-1].text.strip())
    return choices


def _meaning(span: Span, name: str) -> str:
    return f'By "{span.text}", the human means the' + (f" {name}." if name else "")


def substitute(instruction: str, spans: Sequence[Span], objects: Sequence[str]) -> str:
    """Return `instruction` with each expression replaced by its object's name.

    Where only one object was found, the pronouns after it are replaced as well, but for what is
    to be switched on, which is no thing to pick up.
    """
    done, end = "", 0
    for span, name in zip(spans, objects, strict=True):
        done += f"{instruction[end : span.start]}the {name}"
        end = span.end
    rest = instruction[end:]
    if len(set(objects)) == 1:
        again = r"(?<!switch )(?<!turn )\b(?:it|them)\b(?!['’])"
        rest = re.sub(again, f"the {objects[0]}", rest)
    return done + rest
