"""Filling: turns with their noise and their gaps, and what stands in each slot."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from random import Random

from reibench.dataset.realise.nouns import Noun, at, into, place_words
from reibench.dataset.realise.parts import (
    Agreement,
    Destination,
    Part,
    Piece,
    Preposition,
    Slot,
    Token,
)
from reibench.dataset.realise.wording import Use
from reibench.dataset.scripts import Mention, Passage, Turn
from reibench.dialogue import Speaker
from reibench.episode import Goal


@dataclass(frozen=True)
class Line:
    """A turn before its slots are filled."""

    speaker: Speaker
    pieces: tuple[Piece, ...]
    in_request: bool = False
    pronoun: float = 0.0
    """How often its mention may be a pronoun."""


def arrange(chosen: Sequence[Part], noise: Sequence[str], choose: Random) -> list[Line]:
    """Arrange the parts in six turns and the request, each human turn with a sentence of noise."""
    opening, intro, advice, exchange, plan, place, request = chosen
    noisy = [Piece("noise", (sentence,)) for sentence in noise]
    first = [Piece("first", piece.tokens) for piece in intro.turns[0]]
    begun = [noisy[0], *first] if choose.random() < 1 / 2 else [*first, noisy[0]]
    # an answer to somebody's news can always be missed
    reaction = [Piece("cut", piece.tokens) for piece in opening.turns[1]]
    return [
        Line("human", (*opening.turns[0], *begun)),
        Line("robot", (*reaction, *advice.turns[0])),
        Line("human", (*exchange.turns[0], noisy[1])),
        Line("robot", exchange.turns[1], pronoun=0.4),
        Line("human", (*plan.turns[0], noisy[2])),
        Line("robot", place.turns[0]),
        Line("human", request.turns[0], in_request=True, pronoun=0.15),
    ]


def uses(goal: Goal, lines: Sequence[Line], of: str) -> Iterator[Use]:
    """Yield the slots for a task object, in order, with what surrounds them."""
    for line in lines:
        for piece in line.pieces:
            around = [_around(token, goal) for token in ("", *piece.tokens, "")]
            for number, token in enumerate(piece.tokens):
                if isinstance(token, Slot) and token.of == of:
                    before, after = around[number], around[number + 2]
                    # of "to <place>" only the word next to the slot counts
                    last = before.split(" ")[-2:] if before.endswith(" ") else [""]
                    first = after.split(" ")[1:2] if after.startswith(" ") else [""]
                    if after == " ":
                        first = [_around((*piece.tokens, "")[number + 2], goal)]
                    stays = piece.stay == "always"
                    yield Use(
                        slot=token,
                        speaker=line.speaker,
                        stays=stays,
                        in_request=line.in_request,
                        before=last[0].lower(),
                        after=first[0].lower(),
                        pronoun=_pronoun_chance(goal, line, piece, token),
                        paired=bool(goal.movable_receptacle),
                    )


def _pronoun_chance(goal: Goal, line: Line, piece: Piece, slot: Slot) -> float:
    """Return how often a slot may take a pronoun: where its thing is what was spoken of last."""
    alone = sum(isinstance(token, Slot) for token in piece.tokens) == 1
    if goal.movable_receptacle or not alone or slot.capital or slot.way != "the":
        return 0.0
    if piece.stay == "cut":
        return 0.6
    return line.pronoun


def _around(token: Token, goal: Goal) -> str:
    if isinstance(token, str):
        return token
    filled = None if isinstance(token, Slot) else _filled(token, goal, None)
    return filled if isinstance(filled, str) else ""


def fill(
    goal: Goal,
    noun: Noun,
    lines: Sequence[Line],
    mentions: Sequence[list[Mention]],
    place: str,
) -> Iterator[Turn]:
    """Fill the slots of each line, in order."""
    left = {"object": iter(mentions[0]), "movable": iter(mentions[-1])}
    for line in lines:
        passages: list[Passage] = []
        for piece in line.pieces:
            filled = [
                next(left[token.of])
                if isinstance(token, Slot)
                else _filled(token, goal, noun, place)
                for token in piece.tokens
            ]
            if passages and passages[-1].stay == piece.stay == "always":
                filled = [*passages.pop().parts, " ", *filled]
            passages.append(Passage(piece.stay, tuple(_joined(filled))))
        yield Turn(line.speaker, tuple(passages))


def _filled(token: Token, goal: Goal, noun: Noun | None, place: str = "") -> str | Mention:
    if isinstance(token, Agreement):
        return token.plural if noun and noun.is_plural else token.singular
    if isinstance(token, Destination):
        words = place or place_words(goal.destination)
        return Mention(f"{'The' if token.capital else 'the'} {words}", "", "destination")
    if isinstance(token, Preposition):
        if token.relation == "at":
            return at(goal.destination)
        return into(goal.movable_receptacle, moving=token.relation == "into")
    assert isinstance(token, str)  # slots are filled by the wordsmith
    return token


def _joined(filled: Iterable[str | Mention]) -> Iterator[str | Mention]:
    """Join neighbouring stretches of plain text into one, as in a script that is read."""
    text = ""
    for part in filled:
        if isinstance(part, str):
            text += part
            continue
        if text:
            yield text
        yield part
        text = ""
    if text:
        yield text
