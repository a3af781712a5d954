"""Checking scripts together: nothing stock, nothing twice, in word, person and expression."""

from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence

from reibench.dataset.forms import unnamed_form
from reibench.dataset.levels import derive
from reibench.dataset.scripts import Script

WORDS_IN_A_ROW = 5
MOST_SHARED = 0.2
"""Share of a script's five-word sequences that any other script may hold too."""
OPENING_SHARE = 0.012
"""Share of all human turns that may open with the same two words."""
EXPRESSION_SHARE = 0.01
"""Share of all attributive mentions that may be the same words."""
FEW = 4
"""What occurs no more often than this is never too often, however small the set."""
STOCK = (
    "certainly", "absolutely", "of course", "great idea", "sounds good", "sounds great",
    "let me", "i will", "i have", "i'd be happy", "happy to help", "no problem", "sure thing",
)  # fmt: skip
STOCK_SHARE = 0.01
"""Share of the robot's turns that may open with one of these."""


def set_problems(scripts: Sequence[Script]) -> list[str]:
    """Return what is wrong with scripts as a set, one sentence each."""
    found = [*_same_ids(scripts), *_same_speakers(scripts), *_shared_words(scripts)]
    return [*found, *_same_openings(scripts), *_stock_openings(scripts), *_worn(scripts)]


def word_runs(script: Script) -> frozenset[tuple[str, ...]]:
    """Return the five-word sequences of the explicit noised text, its richest."""
    runs: set[tuple[str, ...]] = set()
    for utterance in derive(script)[1].dialogue.utterances:
        words = [word.strip(".,;:!?\"'()").lower() for word in utterance.text.split()]
        runs.update(zip(*(words[shift:] for shift in range(WORDS_IN_A_ROW)), strict=False))
    return frozenset(runs)


def _same_ids(scripts: Sequence[Script]) -> Iterator[str]:
    for name, count in Counter(script.id for script in scripts).items():
        if count > 1:
            yield f"{name} is there {count} times"


def _same_speakers(scripts: Sequence[Script]) -> Iterator[str]:
    for speaker, count in Counter(script.speaker.lower() for script in scripts).items():
        if count > 1:
            yield f"{count} scripts have the speaker {speaker!r}"


def _shared_words(scripts: Sequence[Script]) -> Iterator[str]:
    runs = {script.id: word_runs(script) for script in scripts}
    holders: dict[tuple[str, ...], list[str]] = defaultdict(list)
    for name, mine in runs.items():
        for run in mine:
            holders[run].append(name)
    shared: Counter[tuple[str, str]] = Counter()
    for names in holders.values():
        ordered = sorted(names)
        shared.update((a, b) for i, a in enumerate(ordered) for b in ordered[i + 1 :])
    for (one, other), count in shared.items():
        share = count / max(1, min(len(runs[one]), len(runs[other])))
        if share > MOST_SHARED:
            yield f"{one} and {other} share {share:.0%} of their five-word sequences"


def _openings(scripts: Sequence[Script], speaker: str) -> Counter[str]:
    return Counter(
        " ".join(utterance.text.lower().split()[:2]).rstrip(",.!?")
        for script in scripts
        for utterance in derive(script)[0].dialogue.utterances
        if utterance.speaker == speaker
    )


def _same_openings(scripts: Sequence[Script]) -> Iterator[str]:
    openings = _openings(scripts, "human")
    for words, count in openings.items():
        if count > max(FEW, OPENING_SHARE * openings.total()):
            yield f"{count} human turns open with {words!r}"
    first = Counter(
        " ".join(derive(s)[0].dialogue.utterances[0].text.lower().split()[:3]) for s in scripts
    )
    for words, count in first.items():
        if count > 1:
            yield f"{count} scripts open with {words!r}"


def _stock_openings(scripts: Sequence[Script]) -> Iterator[str]:
    turns = [
        utterance.text.lower()
        for script in scripts
        for utterance in derive(script)[0].dialogue.utterances
        if utterance.speaker == "robot"
    ]
    for words in STOCK:
        count = sum(turn.startswith(words) for turn in turns)
        if count > max(1, STOCK_SHARE * len(turns)):
            yield f"{count} robot turns open with {words!r}"


def _worn(scripts: Sequence[Script]) -> Iterator[str]:
    used = Counter(
        mention.unnamed.lower()
        for script in scripts
        for _, _, mention in script.mentions
        if mention.unnamed and unnamed_form(mention.unnamed) == "attributive"
    )
    for words, count in used.items():
        if count > max(FEW, EXPRESSION_SHARE * used.total()):
            yield f"{words!r} is used {count} times"
