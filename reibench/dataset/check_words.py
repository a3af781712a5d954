"""Checking an episode's words: what names the task objects, where, and grammar."""

from collections.abc import Iterator

from reibench.dataset.forms import is_plural, names, says
from reibench.dataset.grammar import PLURAL, SINGULAR, text_problems
from reibench.dialogue import ReferringExpression
from reibench.episode import Episode


def words_of(object_type: str) -> tuple[str, ...]:
    """Return the everyday names of a type; none for types the lexicon does not know."""
    known = names().get(object_type)
    return known.words if known else ()


def word_problems(episode: Episode) -> Iterator[str]:
    """Yield what is wrong with the words of an episode."""
    goal = episode.task.goal
    for name in filter(None, (goal.object, goal.movable_receptacle)):
        yield from _leaks(episode, name)
        yield from _wrong_names(episode, name)
        yield from _numbers(episode, name)
    for number, utterance in enumerate(episode.dialogue.utterances, start=1):
        for complaint in text_problems(utterance.text):
            yield f"turn {number}: {complaint}"


def _leaks(episode: Episode, name: str) -> Iterator[str]:
    """Find the task object's name where no mark says so."""
    for number, utterance in enumerate(episode.dialogue.utterances, start=1):
        text = utterance.text
        for mark in utterance.expressions:
            if mark.explicit and name in mark.referent.split("+"):
                text = text[: mark.start] + "_" * (mark.end - mark.start) + text[mark.end :]
        found = next((word for word in words_of(name) if says(text, word)), "")
        if found:
            yield f"turn {number}: {found!r} names the {name} outside a named mark"


def _mine(episode: Episode, name: str) -> Iterator[ReferringExpression]:
    for utterance in episode.dialogue.utterances:
        yield from (mark for mark in utterance.expressions if mark.referent == name)


def _wrong_names(episode: Episode, name: str) -> Iterator[str]:
    words = words_of(name)
    for mark in _mine(episode, name):
        if words and mark.explicit and not any(says(mark.text, word) for word in words):
            yield f"{mark.text!r} is marked as naming the {name}, but does not"


def _numbers(episode: Episode, name: str) -> Iterator[str]:
    """Find pronouns of a number that the thing cannot have.

    At the implicit level a plural may stand for the kind, which only other levels name.
    """
    if episode.vagueness.reference == "implicit":
        return
    known = names().get(name)
    named = [mark for mark in _mine(episode, name) if mark.explicit]
    if known is None or known.number == "plural" or not named:
        return
    numbers = {is_plural(mark.text, name) for mark in named}
    if len(numbers) > 1:
        return  # spoken of as one and as several: either pronoun may be right
    wrong = SINGULAR if True in numbers else PLURAL
    for mark in _mine(episode, name):
        if mark.form == "pronoun" and mark.text.lower() in wrong:
            yield f"{mark.text!r} has not the number of {named[0].text!r}"
