"""Lessons for the resolver: a dialogue with a vague request, and what is meant, said clearly."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from random import Random

from reibench.dataset.files import shipped_episodes
from reibench.dataset.levels import derive
from reibench.dataset.lexicon import Lexicon, held_out
from reibench.dataset.realise.compose import CannotRealise, Realiser
from reibench.dataset.realise.tasks import tasks
from reibench.dataset.seeds import Seed
from reibench.dialogue import LEVELS, Dialogue, Reference, Utterance
from reibench.episode import Episode, Goal
from reibench.household import Room
from reibench.methods.restating import clear, question
from reibench.skill import PICKABLE
from reibench.tuning.phrasing import Called, Manner, aside, dressed, named, place_word, request

KEPT_BACK = 0.2
"""The part of each type's expressions that nothing is taught with, for measuring."""
SPLIT = 5
"""Seed that decides which."""
WEIGHTS: Mapping[Reference, float] = {"explicit": 0.2, "mixed": 0.4, "implicit": 0.4}
OWN_WORDS = 0.6
"""How often a request is worded anew around the realiser's expressions."""
ASIDES = 0.35
"""How often something else that is there is spoken of, in each of the human's turns."""


@dataclass(frozen=True)
class Restatement:
    """What a resolver is asked, and the right answer."""

    asked: str
    answer: str


def taught_lexicon() -> Lexicon:
    """Return the expressions that are taught: none of a shipped dialogue, none kept back."""
    kept, _ = held_out(KEPT_BACK, SPLIT)
    return _unshipped(kept)


def untaught_lexicon() -> Lexicon:
    """Return the expressions kept back."""
    return _unshipped(held_out(KEPT_BACK, SPLIT)[1])


def _unshipped(lexicon: Lexicon) -> Lexicon:
    shipped = shipped_expressions()
    return {
        name: tuple(one for one in found if one.text.lower() not in shipped)
        for name, found in lexicon.items()
    }


@lru_cache(maxsize=1)
def shipped_expressions() -> frozenset[str]:
    """Return every vague expression of the shipped dialogues, in small letters."""
    return frozenset(
        expression.text.lower()
        for episode in shipped_episodes()
        for turn in episode.dialogue.utterances
        for expression in turn.expressions
        if not expression.explicit
    )


def restatements(
    rooms: Sequence[Room], seed: int, lexicon: Lexicon | None = None
) -> Iterator[Restatement]:
    """Yield lessons without end, with the taught lexicon unless another is given.

    The same rooms, seed and lexicon give the same.
    """
    realiser = Realiser(taught_lexicon() if lexicon is None else lexicon)
    for number, found in enumerate(tasks(rooms, seed, lambda task: True)):
        choose = Random(f"restatement/{seed}/{number}")
        episode = _vague(found, realiser, choose)
        if episode is None:
            continue
        yield Restatement(question(episode.dialogue), f" {clear(found.task.goal)}")


def _vague(found: Seed, realiser: Realiser, choose: Random) -> Episode | None:
    """Return an episode at one of the levels, its request often worded anew."""
    try:
        script = realiser.realise(found.task, found.present, found.task.id)
    except CannotRealise:
        return None
    levels = [level for level in LEVELS if level.context != "alone"]
    weights = [WEIGHTS[level.reference] for level in levels]
    [episode] = derive(script, choose.choices(levels, weights))
    goal = found.task.goal
    others = [name for name in found.present if name in PICKABLE and name not in goal.objects]
    said = list(episode.dialogue.utterances)
    for place, turn in enumerate(said[:-1]):
        if others and turn.speaker == "human" and choose.random() < ASIDES:
            said[place] = replace(turn, text=f"{turn.text} {aside(others, choose)}")
    if choose.random() < OWN_WORDS and (text := _reworded(episode, goal, choose)):
        said[-1] = Utterance("human", text)
    return replace(episode, dialogue=Dialogue(tuple(said)))


def _reworded(episode: Episode, goal: Goal, choose: Random) -> str:
    """Return a request with the expressions of the episode's own; nothing if one is missing."""
    said = {
        expression.referent: expression.text[0].lower() + expression.text[1:]
        for expression in reversed(episode.dialogue.instruction.expressions)
    }
    plain = named(goal, choose)
    if goal.object not in said or goal.movable_receptacle not in {"", *said}:
        return ""
    if episode.vagueness.reference == "explicit":
        words = plain
    else:
        words = Called(
            said[goal.object],
            movable=said.get(goal.movable_receptacle, ""),
            place=place_word(goal.destination, choose),
        )
    return dressed(request(goal, words, choose), choose, Manner(chatter=0.7, carelessness=0.15))
