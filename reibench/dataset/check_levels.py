"""Checking the nine levels of one task against each other: they differ only as they may."""

import re
from collections.abc import Iterator, Mapping, Sequence

from reibench.dialogue import CONTEXTS, LEVELS, REFERENCES, Utterance, Vagueness
from reibench.episode import Episode

_SENTENCE_END = re.compile(r"(?<!\bMr\.)(?<!\bMs\.)(?<!\bDr\.)(?<!\bSt\.)(?<!\bMrs\.)(?<=[.!?]) +")
BLANK = "\N{WHITE SQUARE}"

Levels = Mapping[Vagueness, Episode]


def level_problems(episodes: Sequence[Episode]) -> list[tuple[str, str]]:
    """Return (episode id, what is wrong) for the episodes of one task, whose ids differ."""
    levels = {episode.vagueness: episode for episode in episodes}
    missing = [str(level) for level in LEVELS if level not in levels]
    if missing:
        return [(episodes[0].id, f"the task lacks {', '.join(missing)}")]
    if any(len(e.dialogue.utterances) != len(episodes[0].dialogue.utterances) for e in episodes):
        return [(episodes[0].id, "the levels do not have the same number of turns")]
    return [*_references(levels), *_noise(levels), *_short(levels), *_requests(levels)]


def sentences(text: str) -> list[str]:
    """Return a text's sentences; titles such as `Dr.` end none."""
    return [sentence for sentence in _SENTENCE_END.split(text) if sentence]


def blanked(utterance: Utterance, referents: frozenset[str]) -> str:
    """Return the text with the mentions of `referents` blanked out."""
    text = utterance.text
    for mark in reversed(utterance.expressions):
        if referents & set(mark.referent.split("+")):
            text = text[: mark.start] + BLANK + text[mark.end :]
    return text


def _counted(episode: Episode) -> frozenset[str]:
    goal = episode.task.goal
    return frozenset(filter(None, (goal.object, goal.movable_receptacle)))


def _references(levels: Levels) -> Iterator[tuple[str, str]]:
    """Explicit, mixed and implicit differ only inside the marks; short implicit also omits."""
    for context in CONTEXTS:
        base = levels[Vagueness("explicit", context)]
        for reference in REFERENCES[1:]:
            other = levels[Vagueness(reference, context)]
            if (reference, context) == ("implicit", "short"):
                continue
            pairs = zip(base.dialogue.utterances, other.dialogue.utterances, strict=True)
            for number, (one, two) in enumerate(pairs, start=1):
                if blanked(one, _counted(base)) != blanked(two, _counted(base)):
                    yield other.id, f"turn {number} differs from {base.id} outside the mentions"
    explicit, mixed = (levels[Vagueness(r, "standard")] for r in ("explicit", "mixed"))
    if explicit.dialogue.context != mixed.dialogue.context:
        yield mixed.id, "the context is not that of the explicit level"
    implicit = levels[Vagueness("implicit", "standard")]
    if implicit.dialogue.instruction != mixed.dialogue.instruction:
        yield implicit.id, "the request is not that of the mixed level"


def _noise(levels: Levels) -> Iterator[tuple[str, str]]:
    """Without its noise sentences a noised dialogue is the standard one."""
    for reference in REFERENCES:
        standard, noised = (levels[Vagueness(reference, c)] for c in ("standard", "noised"))
        pairs = zip(standard.dialogue.utterances, noised.dialogue.utterances, strict=True)
        for number, (plain, noisy) in enumerate(pairs, start=1):
            names = {mark.text for mark in noisy.expressions if mark.is_noise}
            left = [s for s in sentences(noisy.text) if not any(name in s for name in names)]
            if not names and noisy != plain:
                yield noised.id, f"turn {number} differs from the standard one without any noise"
            elif not _is_subsequence(left, sentences(plain.text)):
                yield noised.id, f"turn {number} changes more than it adds"
            elif not _is_subsequence(sentences(plain.text), sentences(noisy.text)):
                yield noised.id, f"turn {number} lacks a sentence of the standard one"


def _short(levels: Levels) -> Iterator[tuple[str, str]]:
    """A short dialogue is the noised one with sentences missing, never changed."""
    for reference in REFERENCES:
        noised, short = (levels[Vagueness(reference, c)] for c in ("noised", "short"))
        removed = 0
        pairs = zip(noised.dialogue.utterances, short.dialogue.utterances, strict=True)
        for number, (whole, rest) in enumerate(pairs, start=1):
            there, left = sentences(whole.text), sentences(rest.text)
            removed += len(there) - len(left)
            if not _is_subsequence(left, there):
                yield short.id, f"turn {number} is not the noised one with sentences missing"
            if not left:
                yield short.id, f"nothing is left of turn {number}"
        if removed < 1:
            yield short.id, "no sentence is left out"


def _requests(levels: Levels) -> Iterator[tuple[str, str]]:
    for reference in REFERENCES:
        first = levels[Vagueness(reference, "standard")].dialogue.instruction
        for context in CONTEXTS[1:]:
            episode = levels[Vagueness(reference, context)]
            if episode.dialogue.instruction != first:
                yield episode.id, "the request differs from that of the standard context"


def _is_subsequence(few: Sequence[str], many: Sequence[str]) -> bool:
    rest = iter(many)
    return all(any(each == other for other in rest) for each in few)
