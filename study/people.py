"""People as researchers see them: where everybody is, how long they take, whether they attend."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from reibench.errors import ReibenchError, unknown
from reibench.store import Store
from reibench.store.schema import now
from study.enrolment import Enrolment, log

GONE = {"withdrawn": "has left the study", "no_consent": "has not agreed to take part"}
"""States in which nothing is kept of somebody that could be judged."""
Judgement = Literal["accept", "reject", "restore"]

_PEOPLE = """
select p.code, p.state, p.stage, p.place, p.slot, p.simulated, p.quiz_tries, p.arrived, p.seen,
    p.ended, p.reason, p.version, p.accepted, p.parameters,
    (select count(*) from assignments as a join records as r on r.id = a.record
        where a.participant = p.code and a.kind = 'trial' and r.status not null) as trials,
    (select count(*) from answers as w where w.participant = p.code and w.right = 0
        and w.stage != 'quiz') as inattentive,
    (select avg(s.seconds) from steps as s join assignments as a on a.record = s.record
        where a.participant = p.code and a.kind = 'trial') as seconds,
    (select coalesce(sum(hidden), 0) / 1000 from page_times as t
        where t.participant = p.code) as hidden
from participants as p where p.study = ? order by p.arrived desc
"""


@dataclass(frozen=True)
class Person:
    """A row of the researchers' list."""

    code: str
    state: str
    stage: str
    place: int
    slot: int
    simulated: bool
    quiz_tries: int
    arrived: str
    seen: str
    ended: str | None
    reason: str
    version: str
    parameters: Mapping[str, str]
    """What is kept of the link they came by."""
    accepted: str | None
    """When a researcher accepted them."""
    trials: int
    """Finished ones."""
    inattentive: int
    """Attention checks answered wrongly."""
    seconds: float | None
    """A step, on average."""
    hidden: float
    """Seconds in which the study's page was out of sight."""


def people_of(enrolment: Enrolment, name: str) -> list[Person]:
    """Return everybody of a study, the latest first; raises UnknownName."""
    enrolment.study(name)
    rows = enrolment.store.query(_PEOPLE, [name])
    return [
        Person(
            **row
            | {"simulated": bool(row["simulated"]), "parameters": json.loads(row["parameters"])}
        )
        for row in rows
    ]


def judge(enrolment: Enrolment, name: str, code: str, judgement: Judgement, reason: str) -> None:
    """Accept, reject or restore somebody, with a reason that is kept.

    Who is rejected gives their place back and is left out of analyses; what they did stays.

    Raises:
        UnknownName: when the study has nobody of that code.
        ReibenchError: when it cannot be done to them now, or no reason is given.
    """
    if not reason.strip():
        raise ReibenchError("Please give a reason; it is kept beside the decision.")
    with enrolment.store.writing() as database:
        row = database.execute(
            "select state, before from participants where study = ? and code = ?", [name, code]
        ).fetchone()
        if row is None:
            raise unknown("participant", code, ())
        state, before = row
        if state in GONE:
            raise ReibenchError(f"{code} {GONE[state]}; there is nothing to {judgement}.")
        if (judgement == "restore") != (state == "rejected"):
            raise ReibenchError(f"{code} is {state}, so there is nothing to {judgement}.")
        wanted = {"reject": "rejected", "restore": before, "accept": state}[judgement]
        database.execute(
            "update participants set state = ?, before = ?, accepted = ?, reason = ?"
            " where code = ?",
            [
                wanted,
                state if judgement == "reject" else None,
                now() if judgement == "accept" else None,
                reason.strip()[:500],
                code,
            ],
        )
        log(database, name, code, judgement, reason.strip()[:500])


def trials_of(enrolment: Enrolment, name: str, code: str) -> list[dict[str, Any]]:
    """Return somebody's trials that were begun, in order."""
    return enrolment.store.query(
        "select a.kind, a.place, r.id as record, r.episode, r.status, r.steps, r.reason,"
        " (select sum(seconds) from steps where record = r.id) as seconds from assignments as a"
        " join records as r on r.id = a.record join participants as p on p.code = a.participant"
        " where p.study = ? and p.code = ? order by a.kind, a.place",
        [name, code],
    )


def answers_of(enrolment: Enrolment, name: str, code: str) -> list[dict[str, Any]]:
    """Return what somebody answered, in order."""
    return enrolment.store.query(
        "select w.stage, w.place, question, attempt, answer, right from answers as w"
        " join participants as p on p.code = w.participant"
        " where p.study = ? and p.code = ? order by created, w.rowid",
        [name, code],
    )


def history_of(enrolment: Enrolment, name: str, code: str) -> list[dict[str, Any]]:
    """Return what was noted about somebody, the latest first."""
    return enrolment.store.query(
        "select created, what, reason from study_log where study = ? and participant = ?"
        " order by created desc",
        [name, code],
    )


def no_trials(store: Store) -> set[str]:
    """Return the records that say nothing of people: practice, made up people, rejected ones."""
    rows = store.query(
        "select a.record from assignments as a join participants as p on p.code = a.participant"
        " where a.record not null and (p.simulated or a.kind = 'practice' or p.state = 'rejected')"
    )
    return {row["record"] for row in rows}
