"""One case: an episode and up to three runs on it, aligned step by step."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Literal

from reibench.cases.table import LANES, PERSON
from reibench.cases.titles import title
from reibench.episode import Episode
from reibench.errors import ReibenchError, UnknownName
from reibench.rollout import Record, Step
from reibench.scene import Scene
from reibench.skill import Skill
from reibench.store import Store
from reibench.view.alignment import Places, align_many, divides

Lane = Literal["person", "plain", "told"]
MOST_RUNS = len(LANES)
KEPT = 96
"""Records kept in memory: a finished one changes only when its run tries it again."""


@dataclass(frozen=True)
class Run:
    """One run of a case."""

    record: Record
    lane: Lane
    planner: str
    """Empty for a person."""
    method: str
    model: str
    rules: str
    max_steps: int
    origin: str

    @property
    def id(self) -> str:
        """The record's id."""
        return self.record.id

    @property
    def steps(self) -> tuple[Step, ...]:
        """What was done."""
        return self.record.steps

    def scenes(self, done: int) -> list[Scene]:
        """Return the room at the start and after each of the first `done` steps."""
        start = self.record.start
        return [] if start is None else [start.scene, *(s.event.scene for s in self.steps[:done])]


@dataclass(frozen=True)
class Case:
    """An episode and runs on it."""

    episode: Episode
    digest: str
    runs: tuple[Run, ...]

    @property
    def title(self) -> str:
        """The goal in one line."""
        return title(self.episode.task.goal)

    @cached_property
    def rows(self) -> tuple[Places, ...]:
        """Which step of each run stands in each row."""
        return align_many(self._skills)

    @cached_property
    def split(self) -> int | None:
        """The first row in which the runs differ; None if they do not, or there is only one."""
        if len(self.runs) < 2:
            return None
        return next((n for n, row in enumerate(self.rows) if divides(row, self._skills)), None)

    @property
    def _skills(self) -> list[list[Skill]]:
        return [[step.decision.skill for step in run.steps] for run in self.runs]

    def reached(self, row: int, lane: int) -> int:
        """Return how many steps of a run are done at a row; at row -1 none is."""
        return sum(places[lane] is not None for places in self.rows[: row + 1])

    def row_of(self, lane: int, number: int) -> int:
        """Return the row of a run's step, numbered from 1; -1 for the start."""
        return next((n for n, row in enumerate(self.rows) if row[lane] == number - 1), -1)

    def decisive(self) -> list[tuple[int, int]]:
        """Return the steps that tell the story, as run and number of steps done then.

        Where the runs part, and how each ends.
        """
        shown: list[tuple[int, int]] = []
        if self.split is not None:
            shown += [
                (lane, self.reached(self.split, lane))
                for lane, index in enumerate(self.rows[self.split])
                if index is not None
            ]
        shown += [(lane, len(run.steps)) for lane, run in enumerate(self.runs)]
        return list(dict.fromkeys(each for each in shown if self.runs[each[0]].record.start))


class Cases:
    """The cases of one database, with the records shown lately kept in memory."""

    def __init__(self, store: Store) -> None:
        self._store = store
        self._record = lru_cache(maxsize=KEPT)(self._read)

    def open(self, run_ids: Sequence[str]) -> Case:
        """Return the case these records make up.

        Raises:
            UnknownName: for an id the database does not have.
            ReibenchError: for none, too many, unfinished ones, or those of several episodes.
        """
        if not 1 <= len(run_ids) <= MOST_RUNS:
            raise ReibenchError(f"A case has one to {MOST_RUNS} runs, not {len(run_ids)}.")
        runs = sorted((self._run(each) for each in run_ids), key=lambda r: LANES.index(r.lane))
        digests = {self._digest(run.id) for run in runs}
        if len(digests) > 1:
            raise ReibenchError("These runs are of different episodes; a case is of one.")
        return Case(runs[0].record.episode, digests.pop(), tuple(runs))

    def _read(self, record_id: str, attempts: int, finished: str) -> Record:
        """Read a record; which attempt it is, and when that ended, only tell it from others."""
        return self._store.record(record_id)

    def _run(self, record_id: str) -> Run:
        rows = self._store.query(
            "select records.actor, status, planner, method, model, records.rules, max_steps,"
            " origin, attempts, finished from records join runs on runs.id = run"
            " where records.id = ?",
            [record_id],
        )
        if not rows:
            raise UnknownName(f"There is no run {record_id[:40]!r} here; it may have been deleted.")
        row = rows[0]
        if row["status"] is None:
            raise ReibenchError("This run is not over yet; its case can be seen when it is.")
        person = row["actor"] == PERSON
        lane: Lane = "person" if person else "plain" if row["method"] == "none" else "told"
        return Run(
            record=self._record(record_id, row["attempts"], row["finished"]),
            lane=lane,
            planner="" if person else row["planner"],
            method="" if person else row["method"],
            model=row["model"],
            rules=row["rules"],
            max_steps=row["max_steps"],
            origin=row["origin"],
        )

    def _digest(self, record_id: str) -> str:
        [row] = self._store.query("select episode_digest from records where id = ?", [record_id])
        return str(row["episode_digest"])
