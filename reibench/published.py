"""The paper's published numbers: what its result tables print, to be set beside ours."""

import csv
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

PUBLISHED = Path(__file__).parents[1] / "assets" / "published" / "paper.csv"
PLANNER = "saycan"
"""The planner of every table of errors and tokens; of others the paper prints only figures."""
MODEL = "LLaMA3.1-8B"
"""The model of every table of methods."""
ERRORS = ("object_omission", "execution_error", "overall_error")
TABLES = {
    "error_rate_on_different_models": "main text, models",
    "error_rate_on_prompting_methods": "main text, methods",
    "appendix_error_rate_on_different_models": "appendix, models",
    "appendix_error_rate_on_prompting_methods": "appendix, methods",
    "token_latency": "appendix, tokens",
    "text": "text",
}
"""The tables that can be set beside runs, and what they are called."""
METHODS = {
    "AP": "ap",
    "Gated AP": "gated-ap",
    "CoT": "cot",
    "Short CoT": "short-cot",
    "Segmented CoT": "segmented-cot",
    "ICL": "icl",
    "ICL (2-shot)": "icl",
    "TOCC": "tocc",
    "TOCC (ours)": "tocc",
    "- Context": "no-context",
    "LLaMA3.1-8B + SayCan: instruction only": "no-context",
    "LLaMA3.1-8B + SayCan with TOCC: mean gain": "tocc",
}
"""Rows that are methods; the others are models planning without one."""


@dataclass(frozen=True)
class PublishedNumber:
    """One cell of one table, or a number the text says."""

    table: str
    row: str
    """The row's own label."""
    method: str
    """Under our name for it."""
    model: str
    """Under the paper's name."""
    reference: str
    context: str
    """Both empty where the number is about all levels."""
    metric: str
    value: float
    """Rates in per cent."""

    @property
    def place(self) -> str:
        """The table's name for people."""
        return TABLES[self.table]


@lru_cache(maxsize=1)
def published_numbers() -> tuple[PublishedNumber, ...]:
    """Return every published rate and cost of the paper, in the order of its tables."""
    with PUBLISHED.open(encoding="utf-8", newline="") as file:
        return tuple(
            PublishedNumber(
                table=row["table"],
                row=row["row"],
                method=METHODS.get(row["row"], "none"),
                model=MODEL if _is_of_methods(row["row"]) else row["row"],
                reference=row["reference"],
                context=row["context"],
                metric=row["metric"],
                value=float(row["value"]),
            )
            for row in csv.DictReader(file)
            if row["table"] in TABLES
        )


def published_errors(method: str, reference: str, context: str) -> Iterator[PublishedNumber]:
    """Yield the error rates of a method at a level: of each model and table that has them."""
    for number in published_numbers():
        level = (number.reference, number.context)
        if number.metric in ERRORS and number.method == method and level == (reference, context):
            yield number


def published_success(method: str, reference: str, context: str) -> dict[str, tuple[float, ...]]:
    """Return the success rates in per cent that follow from the overall errors, by model.

    Each model has one; two where the paper's tables contradict each other.
    """
    rates: dict[str, dict[float, None]] = {}
    for number in published_errors(method, reference, context):
        if number.metric == "overall_error":
            rates.setdefault(number.model, {})[round(100 - number.value, 2)] = None
    return {model: tuple(found) for model, found in rates.items()}


def published_costs(method: str) -> dict[str, float]:
    """Return a method's tokens and milliseconds per planning step; nothing if it has none."""
    return {
        number.metric: number.value
        for number in published_numbers()
        if number.table == "token_latency" and number.method == method
    }


def _is_of_methods(row: str) -> bool:
    return row in METHODS or row.startswith(MODEL)
