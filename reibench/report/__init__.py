"""Reports: scores as rows for machines, and as text, tables and figures for people."""

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from itertools import chain
from typing import Any

import pandas as pd

from reibench.errors import unknown
from reibench.report.paper import beside_paper
from reibench.score import FAULTS, RECORD_COLUMNS, RUN_COLUMNS, costs, paired, summarise
from reibench.worlds.naming import verified

Row = dict[str, Any]
"""What is printed as a JSON object."""


@dataclass(frozen=True)
class Grouping:
    """What scores are counted for."""

    units: tuple[str, ...] = ("run",)
    """Columns of runs: each of their combinations is scored as one, its runs pooled."""
    tables: tuple[tuple[str, ...], ...] = (("level",),)
    """Columns of records: each of these tables is counted within every unit."""

    @classmethod
    def parse(cls, texts: Sequence[str]) -> "Grouping":
        """Read `level`, `method,reference` and the like; raises UnknownName."""
        tables = [tuple(name.strip() for name in text.split(",")) for text in texts]
        for name in chain.from_iterable(tables):
            if name not in (*RECORD_COLUMNS, *RUN_COLUMNS):
                raise unknown("column to group by", name, (*RECORD_COLUMNS, *RUN_COLUMNS))
        units = [name for name in RUN_COLUMNS if name in chain.from_iterable(tables)]
        groups = [tuple(name for name in table if name not in RUN_COLUMNS) for table in tables]
        return cls(tuple(units) or ("run",), tuple(filter(None, groups)) or (("level",),))


def score_rows(
    frame: pd.DataFrame,
    grouping: Grouping | None = None,
    *,
    against: str | None = None,
    paper: bool = False,
) -> list[Row]:
    """Return one row a unit (a run, unless others are asked for), its tables inside.

    Args:
        frame: as `records_frame` returns it, of the chosen runs.
        grouping: what is counted for; runs by level unless said.
        against: the run every other is compared to; the first unless said.
        paper: whether to set the paper's numbers beside.
    """
    grouping = grouping or Grouping()
    if frame.empty:
        return []
    units = list(grouping.units)
    # Episodes that nobody can be sure about bound what any actor can reach (reading of B.3).
    apart = _rows_by_unit(summarise(frame[frame["underdetermined"] == 0], units), units)
    spent = _rows_by_unit(costs(frame, units), units)
    tables = {
        f"by_{','.join(table)}": _rows_by_unit(summarise(frame, [*units, *table]), units)
        for table in grouping.tables
    }
    members = {key: part for key, part in frame.groupby(units, sort=False, dropna=False)}
    rows: list[Row] = []
    for key, [row] in _rows_by_unit(summarise(frame, units), units).items():
        mine = members[key]
        named = dict(zip(units, key, strict=True))
        rows.append(
            {
                **named,
                **_described(mine, named),
                **row,
                "cost": next(iter(spent.get(key, [])), None),
                "determined_only": next(iter(apart.get(key, [])), None),
                **{name: table.get(key, []) for name, table in tables.items()},
            }
        )
        if paper:
            rows[-1]["against_paper"] = asdict(beside_paper(mine))
    if units == ["run"]:
        _compare(frame, rows, against or rows[0]["run"])
    return rows


def _compare(frame: pd.DataFrame, rows: list[Row], first: str) -> None:
    """Add to every other run how it does on the episodes it shares with the first."""
    actor = frame.loc[frame["run"] == first, "actor"].iloc[0]
    for row in rows:
        if row["run"] == first:
            continue
        row["paired"] = {"run": first, "actor": actor} | {
            reading: _numbers(asdict(paired(frame, first, row["run"], reading)))
            for reading in ("success", "success_said_done")
        }


def _described(records: pd.DataFrame, named: Row) -> Row:
    """Say whose records these are: what all their runs share, and which runs they are."""
    pooled = ", ".join(f"{column} {value or 'none'}" for column, value in named.items())
    runs = records.drop_duplicates("run")
    specs = [json.loads(spec) for spec in runs["spec"]]
    shared = {
        name: value
        for name, value in specs[0].items()
        if all(spec.get(name) == value for spec in specs)
    }
    marks = sorted({verified(spec["world"]) for spec in specs} - {""})
    return {
        "actor": runs["actor"].iloc[0] if "run" in named else pooled,
        "runs": list(runs["run"]),
        "verification": ", ".join(marks),
        "spec": shared,
    }


def _rows_by_unit(table: pd.DataFrame, units: list[str]) -> dict[tuple[Any, ...], list[Row]]:
    """Return the rows of a table as plain numbers, by their unit, whose columns are left out."""
    found: dict[tuple[Any, ...], list[Row]] = {}
    for record in table.to_dict("records"):
        row = {str(name): value for name, value in record.items()}
        key = tuple(row.pop(name) for name in units)
        found.setdefault(key, []).append(_numbers(row))
    return found


def _numbers(row: Row) -> Row:
    """Return a row with six decimals, `null` where there is no number, and faults inside."""
    plain = {
        name: None if value != value else round(value, 6) if isinstance(value, float) else value
        for name, value in row.items()
    }
    if "object_omission" in row:
        plain["faults"] = {
            kind: {str(fault): plain.pop(column) for fault, column in columns.items()}
            for kind, columns in FAULTS.items()
        }
    return plain
