"""What a method made of the instruction, word by word."""

import re
from difflib import SequenceMatcher

from reibench.methods import Instruction
from reibench.view.artefacts import artefacts_html, folded
from reibench.view.markup import element, text

_WORD = re.compile(r"\w+(?:['’]\w+)*|[^\w\s]")
_SHORT = 3
"""A single word of so few letters between two changes is shown as changed too."""


def word_diff(before: str, after: str) -> str:
    """Return `after` with what it drops from `before` struck out and what it adds marked."""
    old, new = _words(before), _words(after)
    folded = [word.lower() for word in old], [word.lower() for word in new]
    matcher = SequenceMatcher(None, *folded, autojunk=False)
    parts: list[str] = []
    for kept, old_words, new_words in _joined(matcher, old, new):
        if kept:
            parts.append(text(_spaced(new_words)))
            continue
        if old_words:
            parts.append(element("del", text(_spaced(old_words))))
        if new_words:
            parts.append(element("ins", text(_spaced(new_words))))
    return _tight(" ".join(parts))


def told_heading(instruction: Instruction | None, method: str) -> str:
    """Return, as markup, what stands above what `method` made of an instruction."""
    done = "Rewritten" if instruction is None or instruction.rewritten else "Prepared"
    return f"{done} by {text(method)} before planning"


def told_box(instruction: Instruction, method: str, *, turns: int = 0) -> str:
    """Return a box that shows what `method` made of the instruction.

    Args:
        instruction: what the planner is told.
        method: what the page calls the method.
        turns: how often the human spoke before; the planner may be shown none of it.
    """
    title = element("h3", told_heading(instruction, method))
    return element("div", title, told_body(instruction, turns=turns), class_="told")


def told_body(instruction: Instruction, *, turns: int = 0) -> str:
    """Return what the planner is told beside what was said, and how that came about."""
    parts: list[str] = []
    if instruction.rewritten:
        parts.append(element("p", word_diff(instruction.original, instruction.text)))
    parts.append(artefacts_html(each for each in instruction.artefacts if each.kind == "note"))
    if instruction.notes:
        parts.append(element("blockquote", text(instruction.notes.strip())))
    if instruction.demonstrations:
        parts.append(folded("Solved examples shown first", instruction.demonstrations))
    if not (instruction.rewritten or instruction.notes or instruction.demonstrations):
        parts.append(element("p", "It left the instruction as it was said.", class_="muted"))
    if turns and not instruction.context:
        words = "The planner is not shown the dialogue."
        parts.append(element("p", words, class_="muted small"))
    parts.append(artefacts_html(each for each in instruction.artefacts if each.kind != "note"))
    if instruction.prompt:
        parts.append(folded("Asked of the model", instruction.prompt))
        parts.append(folded("Its answer", instruction.answer))
    return "".join(parts)


_Run = tuple[bool, list[str], list[str]]


def _joined(matcher: SequenceMatcher[str], old: list[str], new: list[str]) -> list[_Run]:
    """Return runs of kept and changed words; a change may swallow short words in its midst."""
    runs: list[_Run] = []
    codes = matcher.get_opcodes()
    for index, (kind, a, b, c, d) in enumerate(codes):
        kept = kind == "equal"
        stays = "".join(new[c:d])
        inner = 0 < index < len(codes) - 1
        if kept and inner and d - c == 1 and len(stays) <= _SHORT:
            kept = False
        if runs and not kept and not runs[-1][0]:
            _, old_words, new_words = runs.pop()
            runs.append((False, old_words + old[a:b], new_words + new[c:d]))
        else:
            runs.append((kept, old[a:b], new[c:d]))
    return runs


def _words(sentence: str) -> list[str]:
    return _WORD.findall(sentence)


def _spaced(words: list[str]) -> str:
    return re.sub(r"([(]) ", r"\1", re.sub(r" ([.,;:!?)])", r"\1", " ".join(words)))


def _tight(markup: str) -> str:
    return re.sub(r" ([.,;:!?])", r"\1", markup)
