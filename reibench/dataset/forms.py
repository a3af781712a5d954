"""The forms of referring expressions, and the names people have for things (section 3.1)."""

import csv
import re
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Literal

LEXICON = Path(__file__).parents[2] / "assets" / "lexicon"
Number = Literal["count", "mass", "plural"]

PRONOUNS = frozenset(
    "it its this that they them their these those one some both".split()
) | frozenset(("one of those", "one of these", "one of them", "some of it", "both of them"))
INDEFINITE = frozenset(("a", "an", "one", "some", "another", "any"))
DEFINITE = frozenset(
    "the this that these those my your his her its our their no every each".split()
)


@dataclass(frozen=True)
class Names:
    """What people call a type of thing, in picture-book words."""

    number: Number
    """Whether it is counted, poured or only comes in the plural."""
    singular: tuple[str, ...]
    plural: tuple[str, ...]

    @property
    def words(self) -> tuple[str, ...]:
        """All names, longest first."""
        return tuple(sorted({*self.singular, *self.plural}, key=len, reverse=True))


@lru_cache(maxsize=1)
def names() -> dict[str, Names]:
    """Return the names of every type that can be a task object."""
    with (LEXICON / "names.csv").open(encoding="utf-8", newline="") as file:
        return {row["object_type"]: _read(row) for row in csv.DictReader(file)}


def _read(row: dict[str, str]) -> Names:
    def listed(cell: str) -> tuple[str, ...]:
        return tuple(filter(None, row[cell].split(";")))

    number: Number = (
        "mass" if row["number"] == "mass" else "plural" if row["number"] == "plural" else "count"
    )
    return Names(number, listed("singular"), listed("plural"))


def says(text: str, word: str) -> bool:
    """Whether `text` holds `word` as a whole word, not inside another (keyboard holds no key)."""
    return _whole(word).search(text) is not None


@lru_cache(maxsize=4096)
def _whole(word: str) -> re.Pattern[str]:
    return re.compile(rf"(?<![\w-]){re.escape(word)}(?![\w-])", re.IGNORECASE)


def is_plural(named: str, referent: str) -> bool:
    """Whether a named mention speaks of several; `a bunch of keys` does not."""
    known = names().get(referent)
    if known is None:
        return False
    longest = next((word for word in known.words if says(named, word)), "")
    return longest in known.plural


def named_form(text: str, referent: str) -> str:
    """Return the form of a named mention: plural, indefinite, definite or proper."""
    if is_plural(text, referent):
        return "plural"
    first = text.split()[0].lower()
    if first in INDEFINITE:
        return "indefinite"
    if first in DEFINITE or first.endswith(("'s", "s'")):
        return "definite"
    return "proper"


def unnamed_form(text: str) -> str:
    """Return the form of an unnamed mention: pronoun or attributive."""
    return "pronoun" if text.lower() in PRONOUNS else "attributive"
