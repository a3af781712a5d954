"""Which patterns of an instruction strongly suggest an implicit referring expression: rules.

Section 3.1 calls two forms implicit, pronouns and attributive expressions; these rules look for
both in what is asked for, and leave the chatter around it alone. They know the objects' names and
no dialogue, so "it" after a named object counts as explained.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from reibench.methods.expressions import candidates, names_a_thing, request

STAND_INS = frozenset(
    "thing things one ones stuff item items object objects something bit pair lot"
    " device devices electronics machine gadget appliance tool utensil implement"
    " beverage beverages drink fruit fruits vegetable veg food snack"
    " container containers vessel".split()
)
"""Nouns that say of which kind a thing is and not which: the paper's "electronic devices",
"beverages", "fruits" and "containers", and those that are used like them."""
EVERYDAY = frozenset(
    "key keys card phone remote clock bat ball basketball racket towel sponge shaker"
    " salt pepper soap tissue tissues paper bottle wine loaf".split()
)
"""Short names of things, which are no descriptions of them."""


@dataclass(frozen=True)
class Pattern:
    """A rule that fired, and where."""

    name: str
    """pronoun: nothing named before it explains it. stand-in: a description of something of a
    kind. what-clause: what it does instead of what it is. unnamed: a noun phrase without an
    object's name, where the instruction names no object at all."""
    found: str
    """The words of the instruction."""

    def __str__(self) -> str:
        return f'{self.name} "{self.found}"'


def implicit_patterns(instruction: str) -> list[Pattern]:
    """Return the patterns of implicit referring expressions in what `instruction` asks for."""
    asked = request(instruction)
    return list(_patterns(asked))


def _patterns(asked: str) -> Iterator[Pattern]:
    for candidate in candidates(asked):
        if candidate.pronoun:
            if not _named(asked[: candidate.start]):
                yield Pattern("pronoun", candidate.head)
        elif candidate.head.lower().startswith("what"):
            yield Pattern("what-clause", candidate.head)
        elif stand_in := _up_to_stand_in(candidate.head):
            yield Pattern("stand-in", stand_in)
        elif not _named(asked):
            yield Pattern("unnamed", candidate.head)


def _named(text: str) -> bool:
    return names_a_thing(text) or not EVERYDAY.isdisjoint(re.findall(r"\w+", text.lower()))


def _up_to_stand_in(phrase: str) -> str:
    words = phrase.split()
    ends = (end for end, word in enumerate(words, 1) if word.lower() in STAND_INS)
    return " ".join(words[: next(ends, 0)])
