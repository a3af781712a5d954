"""The lexicon: what people call things without naming them, and what else each could mean."""

import csv
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from random import Random
from typing import Literal, get_args

from reibench.dataset.forms import LEXICON, names
from reibench.errors import ReibenchError

Kind = Literal["category", "attribute", "function", "event", "location-free-description"]
ExpressionNumber = Literal["singular", "mass", "plural"]
Needs = Literal["", "story", "model", "pair", "once"]
LEAST = 8
"""Expressions each type of thing has at least."""


@dataclass(frozen=True)
class Expression:
    """An attributive expression for a type of thing."""

    object_type: str
    text: str
    kind: Kind
    also_fits: frozenset[str]
    """Other types the words could mean, taken alone and in any room."""
    number: ExpressionNumber
    """The grammar of the words, not of the thing: `the bunch` is singular."""
    needs: Needs
    """What must be so for it to be said: a story told in the talk, a look at the very model, both
    of a pair in the room, or that a joke is made once only; mostly nothing."""

    @property
    def is_free(self) -> bool:
        """Whether anybody may say it of any such thing."""
        return not self.needs


Lexicon = Mapping[str, tuple[Expression, ...]]
"""Expressions by the type of thing they stand for."""


@lru_cache(maxsize=1)
def expressions() -> Lexicon:
    """Return every expression by object type.

    Raises:
        ReibenchError: when the file says something impossible, or too little about a type.
    """
    with (LEXICON / "expressions.csv").open(encoding="utf-8", newline="") as file:
        found = [_read(row) for row in csv.DictReader(file)]
    by_type = _by_type(found)
    counts = Counter({name: len(by_type.get(name, ())) for name in names()})
    if few := [f"{name} ({count})" for name, count in counts.items() if count < LEAST]:
        raise ReibenchError(
            f"The lexicon needs {LEAST} expressions for each type; too few for {', '.join(few)}."
        )
    return by_type


def held_out(fraction: float, seed: int = 0) -> tuple[Lexicon, Lexicon]:
    """Split the lexicon in two: what is kept, and a `fraction` of each type's expressions held out.

    Of each type at least one is held out (if `fraction` is not 0) and at least one kept; the same
    arguments give the same split.

    Raises:
        ReibenchError: when `fraction` is not in [0, 1).
    """
    if not 0 <= fraction < 1:
        raise ReibenchError(
            f"A fraction from 0 up to, not including, 1 can be held out: {fraction}."
        )
    if fraction == 0:
        return expressions(), {}
    kept: list[Expression] = []
    out: list[Expression] = []
    for name, mine in expressions().items():
        shuffled = list(mine)
        Random(f"{seed}/{name}").shuffle(shuffled)
        count = min(max(1, round(fraction * len(mine))), len(mine) - 1)
        out += shuffled[:count]
        kept += shuffled[count:]
    return _by_type(kept), _by_type(out)


def _by_type(found: Iterable[Expression]) -> Lexicon:
    by_type: dict[str, list[Expression]] = {}
    for expression in found:
        by_type.setdefault(expression.object_type, []).append(expression)
    return {name: tuple(mine) for name, mine in by_type.items()}


def _read(row: Mapping[str, str]) -> Expression:
    for column, known in (("kind", Kind), ("number", ExpressionNumber), ("needs", Needs)):
        if row[column] not in get_args(known):
            raise ReibenchError(
                f"The lexicon says {column} {row[column]!r} of {row['expression']!r}; it should be"
                f" one of {', '.join(map(repr, get_args(known)))}."
            )
    kinds = {kind: kind for kind in get_args(Kind)}
    numbers = {number: number for number in get_args(ExpressionNumber)}
    needs = {need: need for need in get_args(Needs)}
    return Expression(
        object_type=row["object_type"],
        text=row["expression"],
        kind=kinds[row["kind"]],
        also_fits=frozenset(filter(None, row["also_fits"].split("|"))),
        number=numbers[row["number"]],
        needs=needs[row["needs"]],
    )
