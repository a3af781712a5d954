"""All finished records of a database as one table in memory, and the cases they make up.

A case is an episode with a run without a method, a run with one, of the same planner and model, and
a person's; any of them may be missing. Filters work on this table, so that they stay quick with
tens of thousands of records; it is brought up to date when the database has changed.
"""

import json
import threading
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import pandas as pd

from reibench.cases.titles import told
from reibench.store import Store
from reibench.tally import note_faults

PERSON = "person"
LANES = ("person", "plain", "told")
"""Whose runs a case sets beside each other, in the order of the pages."""
KINDS = ("helps", "people", "hurts", "same", "single")
"""helps: failed without the method, carried out with it. hurts: the other way round. people: a
person did it, no planner here did. same: both came out alike. single: there is nothing to compare.
"""
JUDGED_AT_ONCE = 500
"""How many records of older versions are judged anew before a page is shown."""
LARGE = 20_000
"""Records from which on nobody is kept waiting for the table to be brought up to date."""
_SETTING = ("planner", "model", "rules")
_EPISODE = ("episode", "episode_digest", "task", "task_type", "level", "room")
_RUN = ("id", "status", "error_kind", "fault", "reason", "taken", "steps", "origin")
_RECORDS = """
select records.id, run, origin, records.actor, episode, episode_digest, task, task_type, level,
    room, status, said_done, error_kind, fault, reason, taken, steps, finished, planner, method,
    model, records.rules
from records join runs on runs.id = run where status not null and finished >= ?
order by finished, records.rowid
"""
Hidden = Callable[[], Collection[str]]


@dataclass(frozen=True)
class Table:
    """What the database held at one moment."""

    records: pd.DataFrame
    episodes: pd.DataFrame
    """Of each episode's digest its `title` and what is `meant`, the goal's object."""
    words: Mapping[str, str]
    """What is said in each episode, by its digest."""
    cases: pd.DataFrame
    """One row a case, most telling first.

    It has the episode's columns, `title` and `meant`, `planner`, `model`, `method`, `rules`,
    `kind`, for each of `LANES` the record's columns, e.g. `plain_status`, and what the case can be
    found by more than once: its `actors`, and the kinds of failure (`errors`) of its runs.
    """
    hidden: frozenset[str] = frozenset()
    """Ids of those `records` that say nothing of people, e.g. of practice tasks."""

    def without(self, hidden: Collection[str]) -> pd.DataFrame:
        """Return the records without some."""
        return self.records[~self.records["id"].isin(hidden)] if hidden else self.records

    @cached_property
    def ids(self) -> frozenset[str]:
        """The ids of all records."""
        return frozenset(self.records["id"])

    @cached_property
    def public(self) -> pd.DataFrame:
        """The cases without what participants of studies did."""
        studied = self.records["origin"] == "study"
        if not studied.any():
            return self.cases
        return cases_of(self.records[~studied], self.episodes)


class CaseTable:
    """The table of one database, made when first needed and kept up to date."""

    def __init__(self, store: Store, hidden: Hidden = tuple) -> None:
        """Read from `store`; `hidden` tells the records that say nothing of people."""
        self._store = store
        self._hidden = hidden
        self._lock = threading.Lock()
        self._known: tuple[int, str] = (0, "")
        self._table = _empty()

    def now(self) -> Table:
        """Return the table as the database is now.

        A large one that has changed is brought up to date behind the scenes: it is returned as it
        was a moment ago, and nobody waits.
        """
        known, hidden = self._state(), frozenset(self._hidden())
        table = self._table
        # who was rejected must not count for a moment longer, so that is always waited for
        judged = hidden & table.ids != table.hidden
        if known == self._known and not judged:
            return table
        if len(table.records) > LARGE and not judged:
            if self._lock.acquire(blocking=False):
                threading.Thread(target=self._catch_up, args=(known, hidden), daemon=True).start()
            return self._table
        with self._lock:
            self._update(known, hidden)
            return self._table

    def _state(self) -> tuple[int, str]:
        """Return how many records are finished, and when the last one was."""
        [row] = self._store.query(
            "select count(finished) as records, coalesce(max(finished), '') as latest from records"
        )
        return row["records"], row["latest"]

    def _catch_up(self, known: tuple[int, str], hidden: frozenset[str]) -> None:
        """Update the table; the lock is held already."""
        try:
            self._update(known, hidden)
        finally:
            self._lock.release()

    def _update(self, known: tuple[int, str], hidden: frozenset[str]) -> None:
        """Bring the table up to date, unless somebody else just did."""
        if known != self._known:
            self._table = self._read(known[0], hidden)
            self._known = known
        elif hidden & self._table.ids != self._table.hidden:
            self._table = _hiding(self._table, hidden)

    def forget(self) -> None:
        """Read everything anew next time."""
        with self._lock:
            self._known, self._table = (0, ""), _empty()

    def _read(self, number: int, hidden: frozenset[str]) -> Table:
        """Read what is new; everything, if something is gone."""
        note_faults(self._store, JUDGED_AT_ONCE)
        before = self._table
        records = new = self._since(self._known[1])
        if len(before.records):
            stays = before.records[~before.records["id"].isin(new["id"])]
            records = pd.concat([stays, new], ignore_index=True)
        whole = len(records) != number
        if whole:
            records = self._since("")
        episodes, words = self._episodes(set((records if whole else new)["episode_digest"]))
        table = Table(records, episodes, words, before.cases, before.hidden)
        if whole or hidden & before.ids != before.hidden or not len(before.cases):
            return _hiding(table, hidden)
        real = table.without(hidden)
        cases = _changed(before.cases, real, set(new["episode_digest"]), episodes)
        return replace(table, cases=cases, hidden=hidden & table.ids)

    def _since(self, finished: str) -> pd.DataFrame:
        rows = self._store.query(_RECORDS, [finished])
        return pd.DataFrame(rows, columns=_columns())

    def _episodes(self, wanted: set[str]) -> tuple[pd.DataFrame, Mapping[str, str]]:
        """Return titles and words of episodes, reading only those that are new."""
        known, words = self._table.episodes, dict(self._table.words)
        new = wanted - words.keys()
        rows = [
            (row["digest"], *told(json.loads(row["json"])))
            for row in (self._store.query("select digest, json from episodes") if new else ())
            if row["digest"] in new
        ]
        words |= {digest: said for digest, _, _, said in rows}
        added = pd.DataFrame([row[:3] for row in rows], columns=_TITLES)
        return (pd.concat([known, added], ignore_index=True) if rows else known), words


_TITLES = ["episode_digest", "title", "meant"]


def _empty() -> Table:
    records, episodes = pd.DataFrame(columns=_columns()), pd.DataFrame(columns=_TITLES)
    return Table(records, episodes, {}, cases_of(records, episodes))


def _hiding(table: Table, hidden: frozenset[str]) -> Table:
    """Return a table with all cases made anew, of the records that are not hidden."""
    cases = cases_of(table.without(hidden), table.episodes)
    return replace(table, cases=cases, hidden=hidden & table.ids)


def _changed(
    cases: pd.DataFrame, records: pd.DataFrame, digests: set[str], titles: pd.DataFrame
) -> pd.DataFrame:
    """Return cases with those of some episodes made anew."""
    anew = cases_of(records[records["episode_digest"].isin(digests)], titles)
    stays = cases[~cases["episode_digest"].isin(digests)]
    return _in_order(pd.concat([stays, anew], ignore_index=True))


def _columns() -> list[str]:
    return [
        "id", "run", "origin", "actor", *_EPISODE, "status", "said_done", "error_kind", "fault",
        "reason", "taken", "steps", "finished", "planner", "method", "model", "rules",
    ]  # fmt: skip


def cases_of(records: pd.DataFrame, titles: pd.DataFrame) -> pd.DataFrame:
    """Return the cases that records make up, most telling first."""
    if records.empty:
        lanes = [f"{lane}_{name}" for lane in LANES for name in _RUN]
        more = ["title", "meant", "kind", "order", "actors", "errors"]
        return pd.DataFrame(columns=[*_EPISODE, *_SETTING, "method", *lanes, *more])
    key = ["episode_digest", *_SETTING]
    planners = records[records["actor"] != PERSON]
    latest = planners.drop_duplicates([*key, "method"], keep="last")
    plain = _lane(latest[latest["method"] == "none"], "plain", key)
    told = _lane(latest[latest["method"] != "none"], "told", [*key, "method"])
    people = records[records["actor"] == PERSON]
    # a study's trial says more of people than somebody's try on the demo page
    people = people.sort_values("origin", key=lambda o: o == "study", kind="stable")
    people = people.drop_duplicates(["episode_digest", "rules"], keep="last")
    person = _lane(people, "person", ["episode_digest", "rules"])
    pairs = told.merge(plain, on=key, how="outer")
    cases = pairs.merge(person, on=["episode_digest", "rules"], how="outer")
    episodes = records.drop_duplicates("episode_digest", keep="last")[list(_EPISODE)]
    cases = cases.merge(episodes, on="episode_digest", how="left")
    cases = cases.merge(titles, on="episode_digest", how="left")
    for name in ("planner", "model", "method"):
        cases[name] = cases[name].fillna("")
    return _sorted(cases)


def _lane(records: pd.DataFrame, lane: str, key: list[str]) -> pd.DataFrame:
    renamed = {name: f"{lane}_{name}" for name in _RUN}
    return records[[*key, *_RUN]].rename(columns=renamed)


def _sorted(cases: pd.DataFrame) -> pd.DataFrame:
    """Add what kind each case is, and put the most telling first."""
    there = {lane: cases[f"{lane}_id"].notna() for lane in LANES}
    solved = {lane: cases[f"{lane}_status"] == "success" for lane in LANES}
    both = there["plain"] & there["told"]
    planner_solved = solved["plain"] | solved["told"]
    kind = pd.Series("single", index=cases.index)
    kind[both] = "same"
    kind[(there["plain"] | there["told"]) & solved["person"] & ~planner_solved] = "people"
    kind[both & ~solved["plain"] & solved["told"]] = "helps"
    kind[both & solved["plain"] & ~solved["told"]] = "hurts"
    failed = (there["plain"] & ~solved["plain"]) | (there["told"] & ~solved["told"])
    rank = kind.map({name: place for place, name in enumerate(KINDS)}) * 4
    rank += (~failed).astype(int) * 2 + (~solved["person"]).astype(int)
    references = cases["level"].str.partition("-")[0]
    vague = references.map({"implicit": 0, "mixed": 1}).fillna(2)
    order = (rank * 4 + vague).astype(int)
    failures = (cases[f"{lane}_{name}"] for lane in LANES for name in ("error_kind", "fault"))
    person = there["person"].map({True: PERSON, False: ""})
    return _in_order(
        cases.assign(
            kind=kind, order=order, actors=_each(cases["planner"], person), errors=_each(*failures)
        )
    )


def _each(first: pd.Series, *others: pd.Series) -> pd.Series:
    """Return for each row the different values of these columns that are there."""
    columns = (first, *others)
    rows = zip(*(column.where(column.notna(), "") for column in columns), strict=True)
    each = [tuple(dict.fromkeys(filter(None, row))) for row in rows]
    return pd.Series(each, index=first.index, dtype=object)


def _in_order(cases: pd.DataFrame) -> pd.DataFrame:
    """Return cases with the most telling first, the vaguest first among those alike."""
    by = ["order", "level", "episode", "method"]
    return cases.sort_values(by, ignore_index=True, kind="stable")
