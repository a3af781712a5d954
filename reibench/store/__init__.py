"""The store: runs, records and their steps in one SQLite file."""

import hashlib
import json
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from typing import Any, Literal
from uuid import uuid4

from sqlite_utils import Database

from reibench.dataset.files import digest, episode_from_json, episode_to_json
from reibench.episode import Episode
from reibench.errors import UnknownName
from reibench.planners import Decision
from reibench.rollout import Record, Rollout, Step
from reibench.run import RunSpec
from reibench.skill import parse_skill
from reibench.store import codec, thoughts
from reibench.store.database_file import DatabaseFile
from reibench.store.frames import FrameFolder
from reibench.store.judging import judge
from reibench.store.schema import now
from reibench.store.steps import step_row, steps_of
from reibench.worlds import Event

Origin = Literal["run", "demo", "study", "gallery"]
"""Where a record comes from: the command line, the demo page, a study, or the shipped gallery."""


@dataclass(frozen=True)
class Entry:
    """A record as the list of records shows it."""

    id: str
    run: str | None
    origin: str
    visitor: str | None
    actor: str
    episode: str
    rules: str
    world: str
    max_steps: int
    status: str | None
    """None while in progress."""


class Store(DatabaseFile):
    """Runs, records and steps; safe to use from several threads and processes."""

    @property
    def frames(self) -> FrameFolder:
        """What cameras saw, for records of worlds that render."""
        return FrameFolder(self.path)

    # writing

    def begin(
        self,
        spec: RunSpec,
        episode: Episode,
        *,
        actor: str = "",
        origin: Origin = "run",
        visitor: str | None = None,
        start: Event | None = None,
    ) -> str:
        """Note that an episode begins, and return its record's id.

        An unfinished record of the same run and episode is begun again: its steps are dropped,
        for the same spec makes the same ones, and its attempts are counted. `start` is the event of
        the reset, where it is known already: then a record is never without one.
        """
        with self.writing() as database:
            self._note_run(database, spec)
            key = digest(episode)
            text = codec.dump(episode_to_json(episode))
            database.execute(
                "insert or ignore into episodes values (?, ?, ?)", [key, episode.id, text]
            )
            if origin == "run" and (again := self._begun_again(database, spec, episode)):
                return again
            record_id = uuid4().hex[:12]
            task = episode.task
            row = {
                "id": record_id, "run": spec.id, "origin": origin, "visitor": visitor,
                "actor": actor or spec.actor, "episode": episode.id, "episode_digest": key,
                "task": task.id, "task_type": str(task.goal.task_type),
                "level": str(episode.vagueness), "underdetermined": episode.underdetermined,
                "room": task.setup.room, "rules": spec.rules, "max_steps": spec.max_steps,
                "started": now(),
            }  # fmt: skip
            names = ", ".join(row)
            marks = ", ".join("?" * len(row))
            database.execute(f"insert into records ({names}) values ({marks})", list(row.values()))
            if start:
                self._note_start(database, record_id, start)
        return record_id

    def _begun_again(self, database: Database, spec: RunSpec, episode: Episode) -> str | None:
        """Begin the run's record of an episode anew, if there is one; return its id."""
        cut_short = database.execute(
            "select id from records where run = ? and episode = ? and origin = 'run'",
            [spec.id, episode.id],
        ).fetchone()
        if not cut_short:
            return None
        database.execute("delete from steps where record = ?", [cut_short[0]])
        self.frames.forget(cut_short[0])
        database.execute(
            "update records set attempts = attempts + 1, steps = 0, status = null,"
            " finished = null, started = ? where id = ?",
            [now(), cut_short[0]],
        )
        return str(cut_short[0])

    def _note_run(self, database: Database, spec: RunSpec) -> None:
        database.execute(
            "insert or ignore into runs values (?, ?, ?, ?, ?, ?, ?, ?)",
            [
                spec.id,
                spec.actor,
                spec.planner,
                spec.method,
                spec.model,
                spec.rules,
                codec.dump(asdict(spec)),
                now(),
            ],
        )

    def started(self, record_id: str, event: Event) -> None:
        """Note the scene the episode starts in."""
        with self.writing() as database:
            self._note_start(database, record_id, event)

    def _note_start(self, database: Database, record_id: str, event: Event) -> None:
        text = codec.dump(codec.scene_to_json(event.scene))
        key = hashlib.sha256(text.encode()).hexdigest()[:16]
        self.frames.keep(record_id, 0, event.frames)
        database.execute("insert or ignore into scenes values (?, ?)", [key, text])
        database.execute(
            "update records set start_scene = ?, start_goals = ? where id = ?",
            [key, codec.goals_to_json(event.goals), record_id],
        )

    def instructed(self, record_id: str, rollout: Rollout) -> None:
        """Note what the planner is told."""
        with self.writing() as database:
            database.execute(
                "update records set instruction = ? where id = ?",
                [thoughts.instruction_to_json(rollout.instruction), record_id],
            )

    def add_step(self, record_id: str, rollout: Rollout, step: Step) -> None:
        """Commit the rollout's step `step`; raises StoreUnavailable and keeps what was there."""
        before = rollout.steps[step.number - 2] if step.number > 1 else None
        row = step_row(step, before, rollout.first_event, rollout.instruction)
        with self.writing() as database:
            self._add_row(database, record_id, step, row)

    def _add_row(
        self, database: Database, record_id: str, step: Step, row: dict[str, object]
    ) -> None:
        row = {"record": record_id, **row}
        names, marks = ", ".join(row), ", ".join("?" * len(row))
        self.frames.keep(record_id, step.number, step.event.frames)
        database.execute(f"insert into steps ({names}) values ({marks})", list(row.values()))
        database.execute("update records set steps = ? where id = ?", [step.number, record_id])

    def finish(self, record_id: str, rollout: Rollout, actor: str, *, error: str = "") -> Record:
        """Close the record and return it."""
        record = rollout.record(record_id, actor, error=error)
        with self.writing() as database:
            self._close(database, record)
        return record

    def _close(self, database: Database, record: Record) -> None:
        judge(database, record)
        database.execute(
            "update records set status = ?, said_done = ?, error = ?,"
            " instruction = ?, closing = ?, finished = ? where id = ?",
            [
                record.status,
                record.said_done,
                record.error,
                thoughts.instruction_to_json(record.instruction),
                thoughts.closing_to_json(record.closing),
                now(),
                record.id,
            ],
        )

    def judge(self, records: Iterable[Record]) -> None:
        """Judge records anew: how they failed and why, as is known today."""
        with self.writing() as database:
            for record in records:
                judge(database, record)

    def forget(self, database: Database, record_ids: Iterable[str]) -> None:
        """Delete records with their steps and frames, inside the transaction of `writing`."""
        for record_id in record_ids:
            database.execute("delete from steps where record = ?", [record_id])
            database.execute("delete from records where id = ?", [record_id])
            self.frames.forget(record_id)

    def keep(self, record: Record) -> None:
        """Write a record that was begun here and played elsewhere: all of it, or nothing."""
        with self.writing() as database:
            if record.start:
                self._note_start(database, record.id, record.start)
            before = None
            for step in record.steps:
                row = step_row(step, before, record.start, record.instruction)
                self._add_row(database, record.id, step, row)
                before = step
            self._close(database, record)

    # reading

    def finished(self, spec: RunSpec, *, but_errors: bool = False) -> set[str]:
        """Return the ids of the episodes this run has finished, `but_errors` those that broke."""
        outcomes = self.outcomes(spec).items()
        return {name for name, status in outcomes if not (but_errors and status == "error")}

    def outcomes(self, spec: RunSpec) -> dict[str, str]:
        """Return the status of each episode this run has finished, by the episode's id."""
        rows = self.query(
            "select episode, status from records"
            " where run = ? and origin = 'run' and status not null",
            [spec.id],
        )
        return {row["episode"]: row["status"] for row in rows}

    def entries(self, where: str = "1", parameters: Iterable[object] = ()) -> list[Entry]:
        """Return the records that fit a condition over their columns, oldest first."""
        rows = self.query(
            "select id, run, origin, visitor, actor, episode, rules, max_steps, status,"
            " (select json_extract(spec, '$.world') from runs where runs.id = run) as world"
            f" from records where {where} order by started, rowid",
            parameters,
        )
        return [Entry(**row) for row in rows]

    def episode_of(self, record_id: str) -> Episode:
        """Return the episode as it was when the record was made."""
        rows = self.query(
            "select json from episodes join records on digest = episode_digest"
            " where records.id = ?",
            [record_id],
        )
        if not rows:
            raise UnknownName(f"The database {self.path} has no record {record_id!r}.")
        return episode_from_json(json.loads(rows[0]["json"]))

    def skills_done(self, record_id: str) -> list[tuple[Decision, float]]:
        """Return a record's decisions and thinking times, in order, without its scenes."""
        rows = self.query(
            "select skill, seconds from steps where record = ? order by number", [record_id]
        )
        return [(Decision(parse_skill(row["skill"])), row["seconds"]) for row in rows]

    def has_start(self, record_id: str) -> bool:
        """Whether it is known how the room was when a record began."""
        return bool(
            self.query("select 1 from records where id = ? and start_scene not null", [record_id])
        )

    def steps_done(self, record_id: str) -> int:
        """Return how many steps of a record are committed."""
        [row] = self.query("select count(*) as steps from steps where record = ?", [record_id])
        return int(row["steps"])

    def record(self, record_id: str) -> Record:
        """Return a whole record, in progress ones with the status they would end in."""
        episode = self.episode_of(record_id)
        [row] = self.query("select * from records where id = ?", [record_id])
        instruction = thoughts.instruction_from_json(row["instruction"])
        start = None
        steps: list[Step] = []
        if row["start_scene"]:
            [scene] = self.query("select json from scenes where digest = ?", [row["start_scene"]])
            start = Event(
                success=True,
                message="",
                scene=codec.scene_from_json(json.loads(scene["json"])),
                goals=codec.goals_from_json(row["start_goals"]),
            )
            rows = self.query("select * from steps where record = ? order by number", [record_id])
            steps = steps_of(rows, start.scene, instruction.prompt if instruction else "")
        return Record(
            id=record_id,
            episode=episode,
            actor=row["actor"],
            status=row["status"] or "failure",
            start=start,
            steps=tuple(steps),
            said_done=bool(row["said_done"]),
            expired=_ran_out(row),
            instruction=instruction,
            closing=thoughts.closing_from_json(row["closing"]),
            error=row["error"],
        )


def _ran_out(row: dict[str, Any]) -> bool:
    """Whether a record ended with steps left and nobody saying done, so by the clock."""
    ended = row["status"] in ("success", "truncated") and not row["said_done"]
    return ended and row["steps"] < row["max_steps"]
