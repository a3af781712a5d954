"""Any runs, and people, beside each other: success by level, kinds of error, paired differences.

The figures are those of `score`; people count as one more run. What was chosen to be shown, as the
gallery is, never counts.
"""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import pandas as pd

from reibench.cases.table import PERSON, Table
from reibench.dialogue import CONTEXTS, REFERENCES
from reibench.errors import unknown
from reibench.published import MODEL, PLANNER, published_success
from reibench.report.labels import model_label
from reibench.score import bootstrap, sign_test, summarise
from reibench.view.choices import method_title, planner_title

PEOPLE = "people"
MOST_RUNS = 6
LEVELS = [(context, reference) for context in CONTEXTS for reference in REFERENCES]
OTHERS = "*"
"""Stands for all that was taken too seldom for a column of its own."""
CONFUSED = 8
"""How many meant objects the matrix shows, the most confused first."""


@dataclass(frozen=True)
class Contestant:
    """A run, or people."""

    run: str
    planner: str
    method: str
    model: str
    rules: str
    episodes: int

    @property
    def title(self) -> str:
        """What it is called, e.g. `SayCan + TOCC`."""
        if self.run == PEOPLE:
            return "People"
        planner = planner_title(self.planner)
        return planner if self.method == "none" else f"{planner} + {method_title(self.method)}"

    @property
    def lane(self) -> str:
        """Which of a case's `LANES` its records stand in."""
        return PERSON if self.run == PEOPLE else "plain" if self.method == "none" else "told"

    @property
    def short(self) -> str:
        """What tells it from runs of the same planner: its method, `plain` without one."""
        if self.run == PEOPLE:
            return "people"
        return "plain" if self.method == "none" else method_title(self.method)

    @property
    def subtitle(self) -> str:
        """Its model, and how many episodes it has finished."""
        parts = [model_label(self.model)] if self.model else []
        if self.rules not in ("strict", ""):
            parts.append(f"{self.rules} rules")
        return ", ".join([*parts, f"n = {self.episodes:,}"])


@dataclass(frozen=True)
class Difference:
    """One contestant against another on the episodes both have."""

    reference: str
    """`all` for all together."""
    pairs: int
    difference: float
    """Of success, in -1…1."""
    low: float
    high: float
    only_first: int
    only_second: int
    p: float


class Comparison:
    """Contestants of one table beside each other."""

    def __init__(self, records: pd.DataFrame, chosen: Sequence[Contestant]) -> None:
        self.chosen = tuple(chosen)
        self.records = records[records["run"].isin([one.run for one in chosen])]

    @cached_property
    def by_level(self) -> dict[tuple[str, str, str], Mapping[Any, Any]]:
        """`summarise`'s row for each run, context and reference."""
        return self._summary(["run", "context", "reference"])

    @cached_property
    def by_reference(self) -> dict[tuple[str, str], Mapping[Any, Any]]:
        """`summarise`'s row for each run and reference."""
        return self._summary(["run", "reference"])

    def _summary(self, by: list[str]) -> dict[Any, Mapping[Any, Any]]:
        rows = summarise(self.records, by).to_dict("records")
        return {tuple(row[name] for name in by): row for row in rows}

    def differences(self, first: str, second: str) -> list[Difference]:
        """Return by how much the second is better than the first, by reference and in all."""
        columns = ["episode_digest", "task", "reference", "solved"]
        solved = self.records.assign(solved=(self.records["status"] == "success").astype(int))
        one, other = (solved[solved["run"] == run][columns] for run in (first, second))
        # people may have several trials of an episode: each stands beside the other's record
        pairs = one.merge(other[["episode_digest", "solved"]], on="episode_digest")
        pairs["gain"] = pairs["solved_y"] - pairs["solved_x"]
        parts = [(name, pairs[pairs["reference"] == name]) for name in REFERENCES]
        return [_difference(name, part) for name, part in [*parts, ("all", pairs)] if len(part)]

    def confusions(self, run: str) -> tuple[list[str], list[str], dict[tuple[str, str], int]]:
        """Return what was meant, what was taken for it, and how often, of one run.

        Objects in the order of how often they were taken for something else; what is seldom taken
        is counted as `OTHERS`; nothing taken is the empty name, and comes last.
        """
        mine = self.records[(self.records["run"] == run) & self.records["taken"].notna()]
        counted = Counter(zip(mine["meant"], mine["taken"], strict=True))
        pairs = {(str(meant), str(taken)): number for (meant, taken), number in counted.items()}
        wrong: dict[str, int] = {}
        for (meant, taken), number in pairs.items():
            wrong[meant] = wrong.get(meant, 0) + (number if taken != meant else 0)
        rows = sorted(wrong, key=lambda name: (-wrong[name], name))[:CONFUSED]
        instead: dict[str, int] = {}
        for (meant, taken), number in pairs.items():
            if meant in rows and taken not in rows and taken:
                instead[taken] = instead.get(taken, 0) + number
        others = sorted(instead, key=lambda name: (-instead[name], name))
        columns = [*rows, *others[: CONFUSED // 2]]
        left = set(others[CONFUSED // 2 :])
        if left:
            columns.append(OTHERS)
            for meant in rows:
                pairs[meant, OTHERS] = sum(pairs.get((meant, taken), 0) for taken in left)
        return rows, [*columns, ""], pairs


def _difference(name: str, pairs: pd.DataFrame) -> Difference:
    low, high = bootstrap(pairs["gain"], pairs["task"])
    worse, better = int((pairs["gain"] < 0).sum()), int((pairs["gain"] > 0).sum())
    return Difference(
        reference=name,
        pairs=len(pairs),
        difference=float(pairs["gain"].mean()),
        low=low,
        high=high,
        only_first=worse,
        only_second=better,
        p=sign_test(worse, better),
    )


def prepared(table: Table, *, researcher: bool) -> pd.DataFrame:
    """Return the records that may be compared, people's trials as one run of theirs.

    The expert's are not: it is told the goal, which nobody else is.
    """
    records = table.without(table.hidden)
    person = records["actor"] == PERSON
    runs = (records["origin"] == "run") & (person | (records["model"] != ""))
    trials = person & (records["origin"] == "study")
    mine = records[runs | (trials & researcher)]
    levels = mine["level"].str.partition("-")
    mine = (
        mine.assign(
            run=mine["run"].where(mine["actor"] != PERSON, PEOPLE),
            reference=levels[0],
            context=levels[2],
        )
        if len(mine)
        else mine.assign(reference="", context="")
    )
    return mine.merge(table.episodes, on="episode_digest", how="left")


def contestants(records: pd.DataFrame) -> list[Contestant]:
    """Return who can be compared: people first, then runs, those with most episodes first."""
    if records.empty:
        return []
    columns = ["planner", "method", "model", "rules"]
    grouped = records.groupby("run", sort=False)
    facts = grouped[columns].first().assign(episodes=grouped.size())
    facts = facts.sort_values("episodes", ascending=False, kind="stable")
    found = [
        Contestant(
            str(run),
            row["planner"] or "",
            row["method"] or "",
            row["model"] or "",
            row["rules"] or "",
            int(row["episodes"]),
        )
        for run, row in facts.iterrows()
    ]
    return sorted(found, key=lambda one: one.run != PEOPLE)


def choose(known: Sequence[Contestant], wanted: str) -> list[Contestant]:
    """Return those an address names; by default people and the runs of the largest study.

    Raises:
        UnknownName: for a run there is none of.
    """
    names = [name for name in wanted.split(",") if name]
    if names:
        by_run = {one.run: one for one in known}
        for name in names:
            if name not in by_run:
                raise unknown("run", name[:40], by_run)
        return [by_run[name] for name in dict.fromkeys(names)][:MOST_RUNS]
    planners = [one for one in known if one.run != PEOPLE and one.model]
    if not planners:
        return list(known)[:MOST_RUNS]
    first = planners[0]
    alike = [
        one
        for one in planners
        if (one.model, one.planner, one.rules) == (first.model, first.planner, first.rules)
    ]
    alike.sort(key=lambda one: (one.method != "none", -one.episodes))
    people = [one for one in known if one.run == PEOPLE]
    return [*people, *alike][:MOST_RUNS]


def published(one: Contestant, reference: str, context: str) -> tuple[float, ...]:
    """Return the paper's success rates in per cent for a method at a level; of SayCan only."""
    if one.planner != PLANNER:
        return ()
    return published_success(one.method, reference, context).get(MODEL, ())
