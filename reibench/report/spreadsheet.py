"""Scores as one long table for spreadsheets and statistics programs."""

import pandas as pd

from reibench.report import Grouping
from reibench.score import RUN_COLUMNS, costs, summarise
from reibench.worlds.naming import verified


def score_csv(frame: pd.DataFrame, grouping: Grouping) -> str:
    """Return CSV: a row for each unit, and one for each of its groups.

    `by` names what a row is counted by and `group` which; both are empty where it is the whole
    unit. Rates are in 0…1. Costs are per planning step, those of restating and of saying done
    per episode, `dollars` in all.
    """
    if frame.empty:
        return ""
    # A run's settings are the same in all its records, so they split nothing further.
    units = list(RUN_COLUMNS) if grouping.units == ("run",) else list(grouping.units)
    parts = [_counted(frame, units, ())]
    parts += [_counted(frame, units, columns) for columns in grouping.tables]
    table = pd.concat(parts, ignore_index=True)
    if "world" in table:
        place = list(table.columns).index("world") + 1
        table.insert(place, "verification", table["world"].map(verified))
    return table.to_csv(index=False, float_format="%.6g").rstrip("\n")


def _counted(frame: pd.DataFrame, units: list[str], columns: tuple[str, ...]) -> pd.DataFrame:
    by = [*units, *columns]
    outcomes = summarise(frame, by)
    spent = costs(frame, by)
    if len(spent):
        outcomes = outcomes.merge(spent.drop(columns="episodes"), on=by, how="left")
    groups = [" ".join(map(str, values)) for values in outcomes[list(columns)].to_numpy()]
    outcomes = outcomes.drop(columns=list(columns))
    outcomes.insert(len(units), "by", ",".join(columns))
    outcomes.insert(len(units) + 1, "group", groups)
    return outcomes
