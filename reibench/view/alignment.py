"""Runs of one episode, aligned step by step."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from reibench.skill import Skill

Kind = Literal["same", "differs", "left only", "right only"]
_GAP = 1.0
_OTHER_OBJECT = 1.0
"""A step with the same verb and another object costs less than leaving both out."""


@dataclass(frozen=True)
class Row:
    """Steps of the two runs that answer each other, by index; None without a counterpart."""

    left: int | None
    right: int | None
    kind: Kind


def align(left: Sequence[Skill], right: Sequence[Skill]) -> tuple[Row, ...]:
    """Return the cheapest alignment (Needleman-Wunsch); steps with different verbs never meet."""
    costs = _costs(left, right)
    rows: list[Row] = []
    one, other = 0, 0
    while one < len(left) or other < len(right):
        here = costs[one][other]
        if one < len(left) and other < len(right):
            cost = _mismatch(left[one], right[other])
            if here == cost + costs[one + 1][other + 1]:
                rows.append(Row(one, other, "same" if cost == 0 else "differs"))
                one, other = one + 1, other + 1
                continue
        if one < len(left) and here == _GAP + costs[one + 1][other]:
            rows.append(Row(one, None, "left only"))
            one += 1
        else:
            rows.append(Row(None, other, "right only"))
            other += 1
    return tuple(rows)


def first_difference(rows: Sequence[Row]) -> int | None:
    """Return the index of the first row in which the runs differ; None if they never do."""
    return next((index for index, row in enumerate(rows) if row.kind != "same"), None)


def _mismatch(one: Skill, other: Skill) -> float:
    if one == other:
        return 0.0
    return _OTHER_OBJECT if one.verb is other.verb else 3 * _GAP


def _costs(left: Sequence[Skill], right: Sequence[Skill]) -> list[list[float]]:
    """Return the cost of aligning what is left of both from each pair of positions on."""
    costs = [[0.0] * (len(right) + 1) for _ in range(len(left) + 1)]
    for one in range(len(left), -1, -1):
        for other in range(len(right), -1, -1):
            ways = []
            if one < len(left):
                ways.append(_GAP + costs[one + 1][other])
            if other < len(right):
                ways.append(_GAP + costs[one][other + 1])
            if one < len(left) and other < len(right):
                ways.append(_mismatch(left[one], right[other]) + costs[one + 1][other + 1])
            costs[one][other] = min(ways, default=0.0)
    return costs


Places = tuple[int | None, ...]
"""Which step of each run stands in a row, by index; None where a run has no counterpart."""


def align_many(runs: Sequence[Sequence[Skill]]) -> tuple[Places, ...]:
    """Return rows over any number of runs, each run after the first aligned to those before it.

    Two runs give the rows of `align`.
    """
    rows: list[Places] = [(index,) for index in range(len(runs[0]))] if runs else []
    for number, run in enumerate(runs[1:], start=1):
        shown = [_skill_of(row, runs) for row in rows]
        merged: list[Places] = []
        for row in align(shown, run):
            before = rows[row.left] if row.left is not None else (None,) * number
            merged.append((*before, row.right))
        rows = merged
    return tuple(rows)


def _skill_of(row: Places, runs: Sequence[Sequence[Skill]]) -> Skill:
    """Return what a row stands for: the last run's step in it, which comes nearest to the next."""
    return next(
        runs[run][index] for run, index in reversed(list(enumerate(row))) if index is not None
    )


def divides(row: Places, runs: Sequence[Sequence[Skill]]) -> bool:
    """Whether the runs differ in a row: another skill, or one without a counterpart."""
    skills = {runs[run][index] for run, index in enumerate(row) if index is not None}
    return len(skills) > 1 or None in row
