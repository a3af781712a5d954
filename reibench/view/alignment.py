"""Two runs of one episode, aligned step by step."""

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
