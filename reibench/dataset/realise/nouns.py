"""What things, places and people are called in realised dialogues."""

import csv
from dataclasses import dataclass
from functools import lru_cache

from reibench.dataset.forms import Number, names
from reibench.dataset.realise.parts import PARTS
from reibench.goals import preposition
from reibench.skill import in_words

OWN = frozenset(("desk", "leisure", "dish"))
"""Kinds of things that people call theirs."""
_PLACES = {
    "ArmChair": "armchair",
    "CounterTop": "counter",
    "GarbageCan": "bin",
    "StoveBurner": "stove",
    "Bathtub": "bath",
    "BathtubBasin": "bath",
    "SinkBasin": "sink",
    "ToiletPaperHanger": "holder on the wall",
    "TVStand": "television stand",
}
"""Everyday words where they differ from the simulator's, or would name a task object."""


@dataclass(frozen=True)
class Noun:
    """How a thing is called in one dialogue."""

    number: Number
    first: tuple[str, ...]
    """Names to introduce it by: `head of lettuce`."""
    later: tuple[str, ...]
    """Names from then on: `lettuce`."""

    @property
    def is_plural(self) -> bool:
        """Whether verbs and pronouns are plural."""
        return self.number == "plural"


@dataclass(frozen=True)
class Name:
    """An ambiguous name."""

    text: str
    category: str
    decoy: str


@lru_cache(maxsize=1)
def nouns() -> dict[str, tuple[Noun, ...]]:
    """Return the ways to call each type of thing: one, or one in each number."""
    found: dict[str, tuple[Noun, ...]] = {}
    with (PARTS / "nouns.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            first, later = (tuple(row[cell].split(";")) for cell in ("first", "later"))
            number: Number = (
                "plural" if row["number"] == "plural" else
                "mass" if row["number"] == "mass" else "count"
            )  # fmt: skip
            name = row["object_type"]
            found[name] = (*found.get(name, ()), Noun(number, first, later))
    for name, known in names().items():
        words = known.singular[:1] or known.plural[:1]
        found.setdefault(name, (Noun(known.number, words, words),))
    return found


@lru_cache(maxsize=1)
def ambiguous_names() -> tuple[Name, ...]:
    """Return the ambiguous names there are."""
    with (PARTS / "names.csv").open(encoding="utf-8", newline="") as file:
        return tuple(
            Name(row["name"], row["category"], row["decoy"]) for row in csv.DictReader(file)
        )


def place_words(object_type: str) -> str:
    """Return what a destination or lamp is called, without an article."""
    return _PLACES.get(object_type) or in_words(object_type)


def at(object_type: str) -> str:
    """Return `in` or `on`, whichever one says of this destination."""
    return preposition(object_type)


def into(holder: str, *, moving: bool) -> str:
    """Return the preposition for what is put in or on a holder."""
    return preposition(holder) + ("to" if moving else "")
