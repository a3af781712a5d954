"""The paper's numbers beside ours: the same method at the same level."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import pandas as pd

from reibench.published import (
    ERRORS,
    PLANNER,
    PublishedNumber,
    published_costs,
    published_errors,
)
from reibench.score import summarise


@dataclass(frozen=True)
class Cell:
    """A number of the paper, and where it stands."""

    table: str
    row: str
    model: str
    value: float
    """Per cent."""


@dataclass(frozen=True)
class Beside:
    """One error rate of ours at one level, and all the paper has for it; rates in per cent."""

    reference: str
    context: str
    metric: str
    """`object_omission`, `execution_error` or `overall_error`."""
    ours: float
    low: float
    high: float
    """95 % Wilson interval."""
    said_done: float | None
    """The overall rate if a solved episode counts only where done was said."""
    episodes: int
    published: tuple[Cell, ...]
    """Several models' where the method is none, and both where the paper contradicts itself."""


@dataclass(frozen=True)
class AgainstPaper:
    """All the paper has to set beside a run."""

    errors: tuple[Beside, ...] = ()
    cost: dict[str, float] = field(default_factory=dict)
    """Its tokens and milliseconds per planning step, of LLaMA3.1-8B."""


def beside_paper(records: pd.DataFrame) -> AgainstPaper:
    """Set the paper's numbers beside `records`: error rates level by level, and costs.

    There are none unless the records are of one method, with the planner of the paper's tables.
    """
    if set(records["planner"]) != {PLANNER} or records["method"].nunique() != 1:
        return AgainstPaper()
    [method] = set(records["method"])
    return AgainstPaper(tuple(_errors(records, method)), published_costs(method))


def _errors(records: pd.DataFrame, method: str) -> Iterator[Beside]:
    for row in summarise(records, ["reference", "context"]).to_dict("records"):
        numbers = list(published_errors(method, row["reference"], row["context"]))
        for metric in ERRORS:
            cells = tuple(_cell(each) for each in numbers if each.metric == metric)
            if cells and row["episodes"]:
                ours, low, high = error_rate(row, metric)
                yield Beside(
                    reference=row["reference"],
                    context=row["context"],
                    metric=metric,
                    ours=ours,
                    low=low,
                    high=high,
                    said_done=_unsaid(row) if metric == "overall_error" else None,
                    episodes=row["episodes"],
                    published=cells,
                )


def error_rate(row: Mapping[Any, Any], metric: str) -> tuple[float, float, float]:
    """Return an error's rate in per cent and its interval, of a row of `summarise`."""
    if metric == "overall_error":
        # Whatever is no success is an error: what broke down is in this rate and no other.
        rate, low, high = (1 - row[f"success_{end}"] for end in ("rate", "high", "low"))
    else:
        rate, low, high = (row[f"{metric}_{end}"] for end in ("rate", "low", "high"))
    return round(100 * rate, 1), round(100 * low, 1), round(100 * high, 1)


def our_words(beside: Mapping[str, Any]) -> str:
    """Return our rate with its interval, and the other reading where it differs."""
    text = f"{beside['ours']:.1f} [{beside['low']:.1f}, {beside['high']:.1f}]"
    strict = beside["said_done"]
    return text if strict in (None, beside["ours"]) else f"{text} ({strict:.1f} unless said done)"


def in_words(cells: Sequence[Mapping[str, Any]]) -> str:
    """Return `LLaMA3.1-8B 22.7 (main text) or 21.4 (appendix)`, and the like, of each model."""
    places: dict[str, dict[float, list[str]]] = {}
    for cell in cells:
        place = "appendix" if cell["table"].startswith("appendix") else "main text"
        found = places.setdefault(cell["model"], {}).setdefault(cell["value"], [])
        found += [place] if place not in found else []
    return ", ".join(
        f"{model} " + " or ".join(f"{v:.1f} ({' and '.join(p)})" for v, p in values.items())
        for model, values in places.items()
    )


def _unsaid(row: Mapping[Any, Any]) -> float:
    return round(100 * (1 - float(row["success_said_done_rate"])), 1)


def _cell(number: PublishedNumber) -> Cell:
    return Cell(number.table, number.row, number.model, number.value)
