"""Scoring: success and the paper's error kinds with intervals, and paired tests; pandas in and out.

Every episode begun counts in the denominator; nothing here reads message text.
"""

from collections.abc import Callable, Sequence
from math import comb, sqrt
from statistics import NormalDist

import pandas as pd

from reibench.store import Store
from reibench.verdict import ErrorKind

COUNTED: dict[str, Callable[[pd.DataFrame], "pd.Series[bool]"]] = {
    "success": lambda frame: frame["status"] == "success",
    "success_said_done": lambda frame: (frame["status"] == "success") & (frame["said_done"] == 1),
    "object_omission": lambda frame: frame["error_kind"] == str(ErrorKind.OMISSION),
    "execution_error": lambda frame: frame["error_kind"] == str(ErrorKind.EXECUTION),
    "breakdown": lambda frame: frame["error_kind"] == str(ErrorKind.BREAKDOWN),
}
"""What is counted among finished records. The last three are the failures, and add up to them."""


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


def records_frame(store: Store, origin: str = "run") -> pd.DataFrame:
    """Return one row a record of that origin, with its run's planner, method, model and rules."""
    rows = store.query(
        "select records.*, planner, method, model, spec from records join runs on runs.id = run"
        " where origin = ? order by runs.created, records.started",
        [origin],
    )
    return pd.DataFrame(rows)


def summarise(frame: pd.DataFrame, by: Sequence[str]) -> pd.DataFrame:
    """Count outcomes for each group of `by`, with rates and 95 % Wilson intervals.

    Args:
        frame: as `records_frame` returns it.
        by: columns, e.g. `run` or `run`, `level`.

    Returns:
        One row a group: `episodes`, `unfinished`, and for each kind of outcome its count,
        `KIND_rate`, `KIND_low` and `KIND_high` in 0…1.
    """
    if frame.empty:
        return pd.DataFrame()
    rows = []
    for key, group in frame.groupby(list(by), sort=False):
        finished = group[group["status"].notna()]
        row: dict[str, object] = dict(zip(by, key, strict=True))
        row |= {"episodes": len(finished), "unfinished": len(group) - len(finished)}
        for name, holds in COUNTED.items():
            count = int(holds(finished).sum())
            low, high = wilson(count, len(finished))
            rate = count / len(finished) if len(finished) else float("nan")
            row |= {name: count, f"{name}_rate": rate, f"{name}_low": low, f"{name}_high": high}
        row["mean_steps"] = float(finished["steps"].mean())
        rows.append(row)
    return pd.DataFrame(rows)


def paired(frame: pd.DataFrame, first: str, second: str) -> dict[str, object]:
    """Compare two runs on the episodes both finished: an exact McNemar test.

    Returns:
        `episodes` both finished, `both`, `only_first`, `only_second`, `neither` solved, and the
        two-sided `p`. Episodes of one seed task are not independent: read p as a lower bound.
    """
    solved = {
        run: {
            str(episode): status == "success"
            for episode, status in frame.loc[
                (frame["run"] == run) & frame["status"].notna(), ["episode", "status"]
            ].to_numpy()
        }
        for run in (first, second)
    }
    shared = sorted(solved[first].keys() & solved[second].keys())
    pairs = [(solved[first][episode], solved[second][episode]) for episode in shared]
    only_first, only_second = pairs.count((True, False)), pairs.count((False, True))
    return {
        "episodes": len(pairs),
        "both": pairs.count((True, True)),
        "only_first": only_first,
        "only_second": only_second,
        "neither": pairs.count((False, False)),
        "p": sign_test(only_first, only_second),
    }


def sign_test(first: int, second: int) -> float:
    """Return the two-sided exact binomial p of `first` against `second` discordant pairs."""
    trials = first + second
    tail = sum(comb(trials, k) for k in range(min(first, second) + 1))
    return min(1.0, 2 * tail / 2**trials) if trials else 1.0
