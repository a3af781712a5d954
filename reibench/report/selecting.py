"""Which runs are told of: those of some planners, methods, models, or named by their ids."""

from collections.abc import Collection
from dataclasses import dataclass, field

import pandas as pd

from reibench.errors import ReibenchError, unknown
from reibench.report.labels import model_label


@dataclass(frozen=True)
class Choice:
    """What runs must be; nothing named means any."""

    runs: tuple[str, ...] = ()
    planners: tuple[str, ...] = ()
    methods: tuple[str, ...] = ()
    models: tuple[str, ...] = field(default=())
    """In full, or without the backend."""

    def of(self, frame: pd.DataFrame) -> pd.DataFrame:
        """Return the records of the chosen runs; raises UnknownName for what no run has."""
        if frame.empty:
            return frame
        models = frame["model"].map(model_label)
        chosen = _among(frame["run"], self.runs) & _among(frame["planner"], self.planners)
        chosen &= _among(frame["method"], self.methods)
        known = {*frame["model"], *models}
        _check("model", self.models, known)
        if self.models:
            chosen &= frame["model"].isin(self.models) | models.isin(self.models)
        if not chosen.any():
            raise ReibenchError("No run is all of what was chosen; each of it there is apart.")
        return frame[chosen]


def contestants(frame: pd.DataFrame, methods: tuple[str, ...] = ()) -> pd.DataFrame:
    """Return the records of runs that ask a model, one of these methods if some are named.

    What reads the goal asks none, and is no competitor.
    """
    asked = frame[frame["model"] != ""] if len(frame) else frame
    if methods and len(asked):
        asked = asked[asked["method"].isin(methods)]
    if asked.empty:
        of = f" of the method {' or '.join(methods)}" if methods else ""
        raise ReibenchError(f"No run with a model{of} is among those chosen; `run` makes one.")
    return asked


def _among(values: "pd.Series[str]", names: Collection[str]) -> "pd.Series[bool]":
    _check(str(values.name), names, set(values))
    return values.isin(list(names)) if names else values.notna()


def _check(kind: str, names: Collection[str], known: Collection[str]) -> None:
    for name in names:
        if name not in known:
            raise unknown(kind if kind == "run" else f"run's {kind}", name, sorted(known))
