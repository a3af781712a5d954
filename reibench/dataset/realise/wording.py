"""Wording the mentions of one thing: by name, by pronoun, by what people call it otherwise."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from random import Random

from reibench.dataset.grammar import article
from reibench.dataset.lexicon import Expression
from reibench.dataset.realise.nouns import Noun
from reibench.dataset.realise.parts import Slot
from reibench.dataset.scripts import Mention
from reibench.dialogue import Speaker

CLEAR = 0.9
"""How often the request takes an expression that fits nothing else in the room, if there is one."""
PREPOSITIONS = frozenset("about at by for from in into of off on onto to under up with".split())
_YOURS = {
    "i": "you", "i'm": "you're", "i've": "you've", "i'd": "you'd", "i'll": "you'll", "me": "you",
    "my": "your", "mine": "yours", "we": "you", "we'll": "you'll", "we're": "you're", "us": "you",
    "our": "your", "am": "are",
}  # fmt: skip
_OURS = re.compile(
    r"\b(?:I was|" + "|".join(sorted(_YOURS, key=len, reverse=True)) + r")\b(?!')", re.I
)
_ALIKE = {
    "count": ("one of those", "a thing like that", "something like that"),
    "mass": ("something like that", "stuff like that"),
    "plural": ("things like that", "such things"),
}
"""How to speak of one of a kind without saying which kind."""


@dataclass(frozen=True)
class Use:
    """A slot and what surrounds it."""

    slot: Slot
    speaker: Speaker
    stays: bool
    """Whether a short context keeps it."""
    in_request: bool
    before: str
    """The word before it, in small letters; empty at the start of a piece or after a comma."""
    after: str
    """The word after it, likewise."""
    pronoun: float = 0.0
    """How often a pronoun does: where the thing has just been spoken of, and nothing else since."""
    paired: bool = False
    """Whether another task object is spoken of too, so that `one of those` is not enough."""

    def suits(self, text: str) -> bool:
        """Whether an expression doubles no word here, nor piles up prepositions."""
        first, *_, last = text.lower().split()
        piles = self.after in PREPOSITIONS and last in PREPOSITIONS
        doubled = re.search(r"\b(\w+) \1\b", text, re.IGNORECASE)
        return first != self.before and last != self.after and not piles and not doubled


@dataclass(frozen=True)
class Wording:
    """What the mentions of one thing say, and what they leave open."""

    mentions: tuple[Mention, ...]
    rivals: Mapping[str, str] = field(default_factory=dict)
    """Types of the room the request's words alone could mean, with the words that rule them out."""
    undecided: tuple[str, ...] = ()
    """Those that nothing rules out once the first mention is gone."""


class Wordsmith:
    """Words the mentions of one thing in one dialogue."""

    def __init__(
        self,
        noun: Noun,
        expressions: Sequence[Expression],
        present: frozenset[str],
        choose: Random,
        *,
        owned: bool,
    ) -> None:
        """Take the words there are.

        Args:
            noun: its names.
            expressions: those that may be used, of the right number.
            present: the other types of the room.
            choose: decides among equals.
            owned: whether people call it theirs.
        """
        self._noun = noun
        self._present = present
        self._choose = choose
        self._owned = owned
        self._fresh = list(expressions)
        choose.shuffle(self._fresh)
        self._all = tuple(self._fresh)

    def word(self, uses: Sequence[Use]) -> Wording:
        """Return what each of `uses` says, in their order; the first is by name only."""
        said = self._expressions(uses)
        mentions = [self._mention(number, use, said.get(number)) for number, use in enumerate(uses)]
        clues = {
            number: expression
            for number, expression in said.items()
            if uses[number].stays and not uses[number].in_request
        }
        asked = [said[number] for number in said if uses[number].in_request]
        rivals, undecided = self._rivals(mentions, clues, asked[0] if asked else None)
        return Wording(tuple(mentions), rivals, undecided)

    def _expressions(self, uses: Sequence[Use]) -> dict[int, Expression]:
        """Choose an expression for every use that wants one; the clearest where it matters most."""
        said: dict[int, Expression] = {}
        wanting = [n for n, use in enumerate(uses) if n and use.slot.way in ("the", "this", "my")]
        request = [n for n in wanting if uses[n].in_request]
        clear = [n for n in wanting if uses[n].stays and not uses[n].in_request]
        plain = {
            n
            for n in wanting
            if not self._noun.is_plural and self._choose.random() < uses[n].pronoun
        }
        wanting = [n for n in wanting if n not in plain]
        request = [n for n in request if n not in plain]
        anchor = [self._choose.choice(clear)] if clear else []
        for number in sorted(wanting, key=lambda n: (n not in request, n not in anchor, n)):
            is_clear = number in anchor or (number in request and self._choose.random() < CLEAR)
            if found := self._take(uses[number], clear=is_clear):
                said[number] = found
        for number, use in enumerate(uses):
            if number and use.slot.way == "a" and (use.paired or self._choose.random() < 1 / 2):
                vague = [
                    e
                    for e in self._fresh
                    if e.text.startswith("something ") and use.suits(said_by(e.text, use.speaker))
                ]
                if vague:
                    said[number] = vague[0]
                    self._fresh.remove(vague[0])
                elif use.paired and (found := self._take(use, clear=False)):
                    said[number] = found
        return said

    def _take(self, use: Use, *, clear: bool) -> Expression | None:
        """Take an expression that suits; a used one only when there is no other."""
        banned = ("something ", "a ") if use.slot.way == "the" else ("something ", "a ", "what")
        for pool in (self._fresh, self._all):
            suited = [e for e in pool if not e.text.startswith(banned)]
            suited = [e for e in suited if use.suits(said_by(e.text, use.speaker))]
            if clear:
                suited = [e for e in suited if not self._others(e)] or suited
            if suited:
                if suited[0] in self._fresh:
                    self._fresh.remove(suited[0])
                return suited[0]
        return None

    def _others(self, expression: Expression) -> frozenset[str]:
        return expression.also_fits & self._present

    def _mention(self, number: int, use: Use, expression: Expression | None) -> Mention:
        named = self._named(use, first=not number)
        unnamed = ""
        if expression:
            unnamed = said_by(expression.text, use.speaker)
        elif number:
            unnamed = self._pronoun(use.slot)
        return Mention(
            named[0].upper() + named[1:] if use.slot.capital else named, unnamed, use.slot.of
        )

    def _named(self, use: Use, *, first: bool) -> str:
        noun = self._choose.choice(self._noun.first if first else self._noun.later)
        if use.slot.way == "a" or (use.slot.way == "my" and first and self._noun.number == "mass"):
            bare = self._noun.is_plural or (self._noun.number == "mass" and not first)
            return noun if bare else f"{article(noun)} {noun}"
        mine = "my" if use.speaker == "human" else "your"
        if use.slot.way == "my":
            return f"{mine} {noun}"
        is_mine = self._owned and use.slot.way in ("the", "this") and self._choose.random() < 0.3
        return f"{mine} {noun}" if is_mine else f"the {noun}"

    def _pronoun(self, slot: Slot) -> str:
        if slot.way == "a":
            return self._choose.choice(_ALIKE[self._noun.number])
        if self._noun.is_plural:
            return (
                "they"
                if slot.way in ("they", "this")
                else "those"
                if slot.way == "that"
                else "them"
            )
        return "that" if slot.way == "that" else "it"

    def _rivals(
        self,
        mentions: Sequence[Mention],
        clues: Mapping[int, Expression],
        asked: Expression | None,
    ) -> tuple[dict[str, str], tuple[str, ...]]:
        """Say what the request could mean besides, and which words of the context rule it out."""
        if asked:
            others = self._others(asked)
        else:
            others = self._present
            for clue in clues.values():
                others &= clue.also_fits
        rivals, undecided = {}, []
        for other in sorted(others):
            number = next((n for n, clue in clues.items() if other not in clue.also_fits), 0)
            # nothing but its name rules out what fits every clue
            rivals[other] = mentions[number].unnamed if number else mentions[0].named
            if not number:
                undecided.append(other)
        return rivals, tuple(undecided)


def said_by(text: str, speaker: Speaker) -> str:
    """Return an expression, written as the human's, as `speaker` says it."""
    if speaker == "human":
        return text
    return _OURS.sub(lambda found: _YOURS.get(found[0].lower(), "you were"), text)
