"""Scoring: success and the paper's error kinds with intervals, costs, and paired tests.

Pandas in and out; the tables are those of `reibench.tally`. Every episode begun counts in the
denominator; nothing here reads message text.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import comb, sqrt
from statistics import NormalDist

import numpy as np
import pandas as pd

from reibench.dialogue import CONTEXTS, EXPLICIT_ALONE, LEVELS, REFERENCES
from reibench.episode import TaskType
from reibench.faults import FaultKind
from reibench.verdict import ErrorKind

COUNTED: dict[str, Callable[[pd.DataFrame], "pd.Series[bool]"]] = {
    "success": lambda frame: frame["status"] == "success",
    "success_said_done": lambda frame: (frame["status"] == "success") & (frame["said_done"] == 1),
    "object_omission": lambda frame: frame["error_kind"] == str(ErrorKind.OMISSION),
    "execution_error": lambda frame: frame["error_kind"] == str(ErrorKind.EXECUTION),
    "breakdown": lambda frame: frame["error_kind"] == str(ErrorKind.BREAKDOWN),
}
"""What is counted among finished records. The last three are the failures, and add up to them."""

FAULTS: dict[str, dict[FaultKind, str]] = {
    kind: {fault: f"{kind}_{fault.replace('-', '_')}" for fault in FaultKind}
    for kind in ("object_omission", "execution_error")
}
"""The finer kinds below each kind, with the names of their columns; they add up to it."""

RUN_COLUMNS = ("run", "planner", "method", "model", "world", "rules", "max_steps", "seed", "code")
"""What all records of a run share; everything else to group by differs within it."""
RECORD_COLUMNS = ("level", "reference", "context", "task_type", "room", "task")

COSTS = ("prompt_tokens", "cached_tokens", "output_tokens", "model_seconds", "dollars")
RESAMPLES = 10_000
_ORDER: dict[str, Sequence[str]] = {
    "level": [str(level) for level in (*LEVELS, EXPLICIT_ALONE)],
    "reference": REFERENCES,
    "context": (*CONTEXTS, EXPLICIT_ALONE.context),
    "task_type": [str(task_type) for task_type in TaskType],
}


@dataclass(frozen=True)
class Paired:
    """Two runs on the episodes both finished: the second against the first."""

    episodes: int
    tasks: int
    """Seed tasks among the episodes: what is drawn anew in the bootstrap."""
    both: int
    only_first: int
    only_second: int
    neither: int
    p: float
    """Two-sided exact McNemar test. Episodes of one seed task are not independent: read it as a
    lower bound."""
    difference: float
    """Success of the second less that of the first, in -1…1; nan without episodes."""
    low: float
    high: float
    """95 % percentile interval of the difference, of a bootstrap over whole seed tasks; nan
    where there is only one task, which says nothing about others."""


def wilson(successes: int, trials: int, confidence: float = 0.95) -> tuple[float, float]:
    """Return the Wilson score interval of a proportion; (0, 1) where nothing was tried."""
    if not trials:
        return 0.0, 1.0
    z = NormalDist().inv_cdf(0.5 + confidence / 2)
    rate = successes / trials
    centre = rate + z * z / (2 * trials)
    spread = z * sqrt(rate * (1 - rate) / trials + z * z / (4 * trials * trials))
    scale = 1 + z * z / trials
    # At 0 and n the bound is exact; rounding must not leave it a hair inside.
    low = 0.0 if successes == 0 else max((centre - spread) / scale, 0.0)
    high = 1.0 if successes == trials else min((centre + spread) / scale, 1.0)
    return low, high


def summarise(frame: pd.DataFrame, by: Sequence[str]) -> pd.DataFrame:
    """Count outcomes for each group of `by`, with rates and 95 % Wilson intervals.

    Args:
        frame: as `records_frame` returns it.
        by: columns, e.g. `run` or `run`, `level`.

    Returns:
        One row a group: `episodes`, `unfinished`, and for each kind of outcome its count,
        `KIND_rate`, `KIND_low` and `KIND_high` in 0…1; the counts of the finer kinds as
        `FAULTS` names them.
    """
    if frame.empty:
        return pd.DataFrame()
    finished = frame["status"].notna()
    marks = {name: holds(frame) & finished for name, holds in COUNTED.items()}
    for kind, columns in FAULTS.items():
        marks |= {column: marks[kind] & (frame["fault"] == f) for f, column in columns.items()}
    marks |= {"episodes": finished, "unfinished": ~finished}
    counts = pd.DataFrame({**marks, "steps": frame["steps"].where(finished, 0)}).astype(int)
    table = _grouped(counts, frame, by)
    trials = table["episodes"].where(table["episodes"] > 0)
    for name in COUNTED:
        bounds = map(wilson, table[name].tolist(), table["episodes"].tolist())
        low, high = zip(*bounds, strict=True)
        table[f"{name}_rate"] = table[name] / trials
        table[f"{name}_low"], table[f"{name}_high"] = low, high
    return table.assign(mean_steps=table.pop("steps") / trials)


def costs(frame: pd.DataFrame, by: Sequence[str]) -> pd.DataFrame:
    """Say what the finished records of each group of `by` cost, per planning step.

    A planning step is a decision: a skill, or saying done.

    Returns:
        One row a group: its `episodes`, `decisions` and `dollars`, and per decision
        `input_tokens`, `evaluated_tokens` (of the input, those that had to be), `output_tokens`,
        `total_tokens`, `model_ms` and `total_ms` (all thinking time). These count every model
        call; what restating the instruction and what saying done took of it is also said apart,
        per episode, with `method_` and `closing_` before the name.
    """
    finished = frame[frame["status"].notna()] if len(frame) else frame
    if finished.empty:
        return pd.DataFrame()
    parts = [f"{part}{cost}" for part in ("", "method_", "closing_") for cost in COSTS]
    sums = _grouped(finished[["decisions", "seconds", *parts]].assign(episodes=1), finished, by)
    table = sums[[*by, "episodes", "decisions", "dollars"]].copy()
    for part in ("", "method_", "closing_"):
        per = sums["episodes"] if part else sums["decisions"].where(sums["decisions"] > 0)
        prompt, output = sums[f"{part}prompt_tokens"], sums[f"{part}output_tokens"]
        table[f"{part}input_tokens"] = prompt / per
        table[f"{part}evaluated_tokens"] = (prompt - sums[f"{part}cached_tokens"]) / per
        table[f"{part}output_tokens"] = output / per
        table[f"{part}total_tokens"] = (prompt + output) / per
        table[f"{part}model_ms"] = 1000 * sums[f"{part}model_seconds"] / per
    return table.assign(
        total_ms=1000 * sums["seconds"] / sums["decisions"].where(sums["decisions"] > 0)
    )


def _grouped(values: pd.DataFrame, frame: pd.DataFrame, by: Sequence[str]) -> pd.DataFrame:
    """Sum `values` over the groups of `frame`, in the order people expect."""
    keys = [frame[name] for name in by]
    table = values.groupby(keys, sort=False, dropna=False).sum().reset_index()
    return table.sort_values(list(by), key=_rank, kind="stable", ignore_index=True)


def _rank(values: "pd.Series[str]") -> "pd.Series[int]":
    """Rank the values of a column: levels and types as the paper has them, runs as they came."""
    name = str(values.name)
    there = list(dict.fromkeys(values)) if name in RUN_COLUMNS else sorted(set(values))
    order = [*_ORDER.get(name, ()), *there]
    return values.map({value: place for place, value in reversed(list(enumerate(order)))})


def paired(frame: pd.DataFrame, first: str, second: str, reading: str = "success") -> Paired:
    """Compare two runs on the episodes both finished.

    Args:
        frame: as `records_frame` returns it.
        first: a run's id.
        second: another's.
        reading: what counts as solved, `success` or `success_said_done`.
    """
    mine = frame[frame["run"].isin([first, second]) & frame["status"].notna()]
    finished = mine.assign(solved=COUNTED[reading](mine))
    # The same id may stand for another text in another version of the data: digests do not.
    columns = finished.set_index("episode_digest")[["run", "task", "solved"]]
    one, other = (columns[columns["run"] == run] for run in (first, second))
    both = one.merge(other[["solved"]], left_index=True, right_index=True, suffixes=("", "_second"))
    before, after = both["solved"].astype(bool), both["solved_second"].astype(bool)
    only_first, only_second = int((before & ~after).sum()), int((~before & after).sum())
    gains = after.astype(int) - before.astype(int)
    low, high = bootstrap(gains, both["task"])
    return Paired(
        episodes=len(both),
        tasks=both["task"].nunique(),
        both=int((before & after).sum()),
        only_first=only_first,
        only_second=only_second,
        neither=int((~before & ~after).sum()),
        p=sign_test(only_first, only_second),
        difference=float(gains.mean()),
        low=low,
        high=high,
    )


def bootstrap(
    gains: "pd.Series[int]", clusters: "pd.Series[str]", seed: int = 0
) -> tuple[float, float]:
    """Return the 95 % percentile interval of the mean gain, drawing whole clusters anew.

    Clusters are weighed by their size, so episodes weigh the same; the same seed gives the same
    interval. Returns nan twice where there are fewer than two clusters.
    """
    grouped = gains.groupby(clusters.to_numpy())
    sums, sizes = grouped.sum().to_numpy(), grouped.size().to_numpy()
    if len(sums) < 2:
        return float("nan"), float("nan")
    totals = _drawn(len(sums), seed) @ np.column_stack([sums, sizes])
    low, high = np.quantile(totals[:, 0] / totals[:, 1], [0.025, 0.975])
    return float(low), float(high)


@lru_cache(maxsize=4)
def _drawn(clusters: int, seed: int) -> "np.ndarray[tuple[int, int], np.dtype[np.float64]]":
    """Return how often each cluster is drawn in each resample."""
    chances = np.full(clusters, 1 / clusters)
    times = np.random.default_rng(seed).multinomial(clusters, chances, size=RESAMPLES)
    return times.astype(np.float64)


def sign_test(first: int, second: int) -> float:
    """Return the two-sided exact binomial p of `first` against `second` discordant pairs."""
    trials = first + second
    tail = sum(comb(trials, k) for k in range(min(first, second) + 1))
    return min(1.0, 2 * tail / 2**trials) if trials else 1.0
