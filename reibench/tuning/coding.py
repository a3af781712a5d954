"""Lessons as tokens: what the model reads, and at which places it learns what to say next."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from reibench.skill import DONE, SKILLS
from reibench.tuning.lessons import Lesson
from reibench.tuning.restatements import Restatement

BEHIND = ","
"""Follows every skill."""


@dataclass(frozen=True)
class Coded:
    """A text as tokens."""

    tokens: tuple[int, ...]
    taught: tuple[tuple[int, int], ...]
    """Places of tokens, and which token should follow each."""


@dataclass(frozen=True)
class Stretch:
    """A part of a text that is learnt, and what should come behind it whatever does."""

    start: int
    end: int
    behind: int | None = None


def coded(
    made: Sequence[Lesson] | Sequence[Restatement], tokenizer: Any
) -> tuple[list[Coded], list[int]]:
    """Return lessons as tokens, and the tokens that the answers to them are chosen from."""
    told: list[Coded] = []
    for lesson in made:
        if isinstance(lesson, Lesson):
            told.append(code_lesson(lesson, tokenizer))
        else:
            told.append(code_restatement(lesson, tokenizer))
    if isinstance(made[0], Lesson):
        return told, skill_tokens(tokenizer)
    answered = {token for one in told for _, token in one.taught}
    return told, with_beginnings(answered, tokenizer)


def code(text: str, stretches: Iterable[Stretch], tokenizer: Any) -> Coded:
    """Return `text` as tokens, those inside the `stretches` to be learnt."""
    coded = tokenizer(text, return_offsets_mapping=True)
    tokens: list[int] = coded["input_ids"]
    offsets: list[tuple[int, int]] = coded["offset_mapping"]
    taught: list[tuple[int, int]] = []
    for stretch in stretches:
        inside = [
            place
            for place, (start, end) in enumerate(offsets)
            if start >= stretch.start and end <= stretch.end and end > start
        ]
        taught += [(place - 1, tokens[place]) for place in inside]
        if stretch.behind is not None and inside:
            taught.append((inside[-1], stretch.behind))
    return Coded(tuple(tokens), tuple(taught))


def code_lesson(lesson: Lesson, tokenizer: Any) -> Coded:
    """Return a planner's lesson as tokens: what is learnt are the skills, and that they end."""
    [comma] = tokenizer(f"a{BEHIND}", add_special_tokens=False)["input_ids"][1:]
    text, stretches = lesson.told, list[Stretch]()
    for move in lesson.moves:
        start = len(text)
        text += f" {move.skill}"
        if move.taught:
            stretches.append(Stretch(start, len(text), None if move.skill == DONE else comma))
        failure = f" (this action failed: {move.failure})" if move.failure else ""
        text += "" if move.skill == DONE else f"{failure}{BEHIND}"
    return code(text, stretches, tokenizer)


def skill_tokens(tokenizer: Any) -> list[int]:
    """Return every token that a skill has, or that follows one."""
    texts = [f"{BEHIND} {skill}{BEHIND}" for skill in (*map(str, SKILLS), DONE)]
    found = tokenizer(texts, add_special_tokens=False)["input_ids"]
    return sorted({token for tokens in found for token in tokens})


def batches(coded: Sequence[Coded], size: int, shuffled: Sequence[int]) -> Iterator[list[Coded]]:
    """Yield batches of texts of about the same length, in the order of `shuffled`."""
    window = size * 16
    pools = [shuffled[start : start + window] for start in range(0, len(shuffled), window)]
    for pool in pools:
        ordered = sorted(pool, key=lambda number: len(coded[number].tokens))
        groups = [ordered[start : start + size] for start in range(0, len(ordered), size)]
        # the longest first would make the loss jump between windows
        for group in sorted(groups, key=lambda group: group[0]):
            yield [coded[number] for number in group]


def code_restatement(lesson: Restatement, tokenizer: Any) -> Coded:
    """Return a resolver's lesson as tokens: what is learnt is the answer, and that it ends."""
    [end] = tokenizer("\n", add_special_tokens=False)["input_ids"]
    text = lesson.asked + lesson.answer
    return code(text, [Stretch(len(lesson.asked), len(text), end)], tokenizer)


def with_beginnings(tokens: Iterable[int], tokenizer: Any) -> list[int]:
    """Return `tokens` and every token that one of them begins with.

    A grammar lets a word begin with any part of it; the model must learn not to.
    """
    wanted = set(tokens)
    texts = {tokenizer.convert_ids_to_tokens(token) for token in wanted}
    starts = {text[:end] for text in texts for end in range(1, len(text))}
    parts = {token for text, token in tokenizer.get_vocab().items() if text in starts}
    return sorted(wanted | parts)
