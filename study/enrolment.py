"""Enrolment: studies, their versions, and who takes part in them."""

import json
import secrets
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from random import Random
from typing import Any, Literal, get_args

from sqlite_utils import Database

from reibench.errors import ReibenchError, unknown
from reibench.store import Store
from reibench.store.schema import now
from study import places, schema
from study.config import Study, all_episodes, from_json
from study.designs import Comer, designs
from study.texts import fingerprint

State = Literal["active", "finished", "no_consent", "failed_check", "withdrawn", "rejected"]
RunState = Literal["open", "paused", "stopped"]
RUN_STATES: tuple[RunState, ...] = get_args(RunState)
LETTERS = "BCDFGHJKLMNPQRSTVWXZ23456789"
"""Of codes: nothing that is read as something else, and no words."""

assert schema  # its tables are made when a store is opened


class Closed(ReibenchError):
    """The study takes nobody in now."""


@dataclass(frozen=True)
class Participant:
    """Somebody who takes part."""

    token: str
    """What their browser is known by; a secret."""
    code: str
    """What researchers know them by."""
    study: str
    version: str
    slot: int
    seed: int
    stage: str
    place: int
    """Which trial or practice task they are at, from 0."""
    state: State
    quiz_tries: int
    simulated: bool
    before: State | None = None
    """What they were before they were turned away."""


@dataclass(frozen=True)
class Assignment:
    """An episode that a participant is to play."""

    kind: Literal["practice", "trial"]
    place: int
    episode: str
    record: str | None

    @property
    def room(self) -> str:
        """The room it is in."""
        [room] = [one.task.setup.room for one in all_episodes() if one.id == self.episode]
        return room


class Enrolment:
    """Studies and participants in one database; safe from several threads and processes."""

    def __init__(self, store: Store) -> None:
        self.store = store

    # studies

    def create(self, study: Study) -> bool:
        """Keep a study, or a new version of it; return whether it is new or changed."""
        with self.store.writing() as database:
            known = database.execute(
                "select version from studies where name = ?", [study.name]
            ).fetchone()
            if known and known[0] == study.version:
                return False
            database.execute(
                "insert or ignore into study_versions values (?, ?, ?, ?)",
                [study.name, study.version, study.to_json(), now()],
            )
            database.execute(
                "insert into studies values (?, ?, 'open', ?)"
                " on conflict (name) do update set version = excluded.version",
                [study.name, study.version, now()],
            )
            log(database, study.name, None, f"version {study.version}")
        return True

    def studies(self) -> list[dict[str, Any]]:
        """Return name, version and state of every study."""
        return self.store.query("select name, version, state, created from studies order by name")

    def study(self, name: str, version: str = "") -> Study:
        """Return a study as it is now, or as that version was; raises UnknownName."""
        rows = self.store.query(
            "select json from study_versions join studies on study = name"
            " where name = ? and study_versions.version ="
            " case ? when '' then studies.version else ? end",
            [name, version, version],
        )
        if not rows:
            raise unknown("study", name, [row["name"] for row in self.studies()])
        return _parsed(rows[0]["json"])

    def is_stopped(self, name: str) -> bool:
        """Whether nobody may go on with a study any more."""
        rows = self.store.query("select state from studies where name = ?", [name])
        return bool(rows) and rows[0]["state"] == "stopped"

    def set_state(self, name: str, state: RunState, reason: str = "") -> None:
        """Open, pause or stop a study; who has begun goes on while it is paused, not stopped."""
        self.study(name)
        with self.store.writing() as database:
            database.execute("update studies set state = ? where name = ?", [state, name])
            log(database, name, None, state, reason)

    def invite(self, name: str, number: int) -> list[str]:
        """Make so many invite codes, each for one person, and return them."""
        self.study(name)
        if number < 1:
            raise ReibenchError(f"{number} invitations are none; ask for at least 1.")
        codes = [_code(8) for _ in range(number)]
        with self.store.writing() as database:
            for code in codes:
                database.execute("insert into invites values (?, ?, ?)", [name, code, now()])
        return codes

    # arriving

    def arrive(
        self,
        name: str,
        parameters: Mapping[str, str],
        *,
        invite: str = "",
        simulated: bool = False,
    ) -> Participant:
        """Take somebody in, or return who came with the same invitation or submission before.

        Their episodes are chosen and noted in the same transaction, so that any number may arrive
        at once.

        Raises:
            UnknownName: when there is no such study.
            Closed: when it takes nobody in, or not without an invitation.
        """
        study = self.study(name)
        kept = {key: parameters[key] for key in study.parameters if parameters.get(key)}
        # what tells submissions apart outlives a withdrawal, and so must name nobody
        sent = kept.get(study.submission) if study.submission else None
        submission = fingerprint(sent) if sent else None
        with self.store.writing() as database:
            known = _known(database, name, invite, submission)
            if known:
                return known
            self._admit(database, study, invite, simulated=simulated)
            code, token = _code(6), secrets.token_urlsafe(16)
            slot = places.free_slot(database, study, simulated=simulated)
            held = places.filled(database, study, simulated=simulated)
            seed = Random(f"{study.name}/{study.seed}/{code}").randrange(2**31)
            comer = Comer(slot, held, Random(seed))
            pool = places.pool_of(study)
            chosen = designs.create(study.design).assign(pool, study.trials, comer)
            row = {
                "token": token, "code": code, "study": name, "version": study.version,
                "slot": slot, "seed": seed, "stage": "consent", "state": "active",
                "invite": invite or None, "submission": submission,
                "parameters": json.dumps(kept), "simulated": simulated,
                "arrived": now(), "seen": now(),
            }  # fmt: skip
            marks = ", ".join("?" * len(row))
            database.execute(
                f"insert into participants ({', '.join(row)}) values ({marks})", list(row.values())
            )
            places.assign(database, code, study, chosen)
        return self.participant(token)

    def _admit(self, database: Database, study: Study, invite: str, *, simulated: bool) -> None:
        state = database.execute(
            "select state from studies where name = ?", [study.name]
        ).fetchone()[0]
        if state != "open":
            raise Closed("This study takes nobody in at the moment. Please try again later.")
        if (
            invite
            and not database.execute(
                "select 1 from invites where study = ? and code = ?", [study.name, invite]
            ).fetchone()
        ):
            raise Closed("This invitation is not known. Please use the link as it was sent to you.")
        if study.invited_only and not invite:
            raise Closed("This study is for people who were invited. Please use your own link.")
        if study.people and places.free_slot(database, study, simulated=simulated) >= study.people:
            raise Closed("This study has all the people it needs. Thank you for your interest.")

    def is_same(self, token: str, name: str, parameters: Mapping[str, str], invite: str) -> bool:
        """Whether who has this token takes part in this study and may have come by this link.

        A link with another invitation or submission is another person's, at the same browser.
        """
        rows = self.store.query(
            "select invite, submission from participants where token = ? and study = ?",
            [token, name],
        )
        if not rows:
            return False
        sent = parameters.get(self.study(name).submission or "")
        return (not invite or invite == rows[0]["invite"]) and (
            not sent or fingerprint(sent) == rows[0]["submission"]
        )

    def participant(self, token: str) -> Participant:
        """Return who has this token; raises UnknownName for any other."""
        rows = self.store.query("select * from participants where token = ?", [token])
        if not rows:
            raise unknown("participant", "(a token)", ())
        return _participant(rows[0])

    def filled(self, study: Study, *, simulated: bool = False) -> dict[str, int]:
        """Return how often each episode is held by who finished or takes part, by its id."""
        with self.store.writing() as database:
            return places.filled(database, study, simulated=simulated)

    def assignments(self, code: str, kind: str = "trial") -> list[Assignment]:
        """Return what a participant is to play, in order."""
        rows = self.store.query(
            "select kind, place, episode, record from assignments"
            " where participant = ? and kind = ? order by place",
            [code, kind],
        )
        return [Assignment(**row) for row in rows]


def _known(
    database: Database, name: str, invite: str, submission: str | None
) -> Participant | None:
    row = database.execute(
        "select * from participants where study = ? and ((? != '' and invite = ?)"
        " or (submission not null and submission = ?))",
        [name, invite, invite, submission],
    ).fetchone()
    return _participant(dict(row)) if row else None


def _participant(row: Mapping[str, Any]) -> Participant:
    names = Participant.__dataclass_fields__
    return Participant(
        **{name: row[name] for name in names} | {"simulated": bool(row["simulated"])}
    )


def log(
    database: Database, study: str, participant: str | None, what: str, reason: str = ""
) -> None:
    """Note what happened to a study or a participant, and why."""
    database.execute(
        "insert into study_log values (?, ?, ?, ?, ?)", [study, participant, what, reason, now()]
    )


def _code(length: int) -> str:
    return "".join(secrets.choice(LETTERS) for _ in range(length))


@lru_cache(maxsize=32)
def _parsed(text: str) -> Study:
    return from_json(text)
