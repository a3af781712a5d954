"""The dataset card's figures: counts, lengths, forms and the counting table, as Markdown."""

import hashlib
from collections import Counter
from collections.abc import Iterator, Sequence
from statistics import mean, median

from reibench.dataset.files import digest
from reibench.dialogue import CONTEXTS, LEVELS, REFERENCES, Utterance, Vagueness
from reibench.episode import Episode, TaskType
from reibench.errors import ReibenchError

BEGIN, END = "<!-- computed -->", "<!-- end -->"
"""What `build-dataset` writes stands between these two lines."""


def fingerprint(episodes: Sequence[Episode]) -> str:
    """Return the sha256 of the episodes' digests, in order."""
    return hashlib.sha256("\n".join(map(digest, episodes)).encode()).hexdigest()


def with_figures(card: str, episodes: Sequence[Episode]) -> str:
    """Return a dataset card with its computed part made anew; raises ReibenchError without one."""
    before, begin, rest = card.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not (begin and end):
        raise ReibenchError(f"The dataset card has no part between {BEGIN!r} and {END!r}.")
    return f"{before}{begin}\n{figures(episodes)}\n{end}{after}"


def figures(episodes: Sequence[Episode]) -> str:
    """Return the card's computed part."""
    return "\n".join(
        [
            f"Fingerprint: `{fingerprint(episodes)}`",
            "",
            "### Episodes per task type and level",
            "",
            *_counts(episodes),
            "",
            "### Words of the dialogue, its instruction, and forms of the task objects' mentions",
            "",
            *_lengths(episodes),
            "",
            "### The counting table (appendix B.4)",
            "",
            "Least and greatest number of mentions of one task object, over all episodes of a"
            " level.",
            "",
            *_counting(episodes),
        ]
    )


def _row(*cells: object) -> str:
    return "| " + " | ".join(map(str, cells)) + " |"


def _head(*cells: str) -> list[str]:
    return [_row(*cells), "|---" * len(cells) + "|"]


def _counts(episodes: Sequence[Episode]) -> Iterator[str]:
    types = [kind for kind in TaskType if any(e.task.goal.task_type is kind for e in episodes)]
    yield from _head("level", *(kind.label for kind in types), "all", "underdetermined")
    for level in LEVELS:
        mine = [episode for episode in episodes if episode.vagueness == level]
        counts = Counter(episode.task.goal.task_type for episode in mine)
        unsure = sum(episode.underdetermined for episode in mine)
        yield _row(level, *(counts[kind] for kind in types), len(mine), unsure)
    everything = Counter(episode.task.goal.task_type for episode in episodes)
    unsure = sum(episode.underdetermined for episode in episodes)
    yield _row("**all**", *(everything[kind] for kind in types), len(episodes), unsure)


def counted_types(episode: Episode) -> tuple[str, ...]:
    """Return the task objects whose mentions count: what is picked up, and what it is put into."""
    goal = episode.task.goal
    return tuple(filter(None, (goal.object, goal.movable_receptacle)))


def _forms(episode: Episode) -> Counter[str]:
    counted = set(counted_types(episode))
    return Counter(
        mark.form if not mark.explicit else "named"
        for utterance in episode.dialogue.utterances
        for mark in utterance.expressions
        if counted & set(mark.referent.split("+"))
    )


def _lengths(episodes: Sequence[Episode]) -> Iterator[str]:
    yield from _head(
        "level", "words before it, median", "words of the instruction, median",
        "named", "pronouns", "attributive",
    )  # fmt: skip
    for level in LEVELS:
        mine = [episode for episode in episodes if episode.vagueness == level]
        if not mine:
            continue
        before = [sum(len(u.text.split()) for u in e.dialogue.context) for e in mine]
        asked = [len(e.dialogue.instruction.text.split()) for e in mine]
        forms = [_forms(episode) for episode in mine]
        shares = [
            f"{mean(each[form] for each in forms):.1f}"
            for form in ("named", "pronoun", "attributive")
        ]
        yield _row(level, f"{median(before):.0f}", f"{median(asked):.0f}", *shares)


def _counting(episodes: Sequence[Episode]) -> Iterator[str]:
    yield from _head(
        "level", "named before", "unnamed before", "named in the instruction",
        "unnamed in the instruction",
    )  # fmt: skip
    for reference in REFERENCES:
        for context in CONTEXTS:
            level = Vagueness(reference, context)
            rows = [
                (*_tally(e.dialogue.context, name), *_tally((e.dialogue.instruction,), name))
                for e in episodes
                if e.vagueness == level
                for name in counted_types(e)
            ]
            if rows:
                spans = (f"{min(column)}–{max(column)}" for column in zip(*rows, strict=True))
                yield _row(level, *spans)


def _tally(utterances: Sequence[Utterance], name: str) -> tuple[int, int]:
    marks = [e for u in utterances for e in u.expressions if name in e.referent.split("+")]
    named = sum(mark.explicit for mark in marks)
    return named, len(marks) - named
