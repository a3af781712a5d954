"""Everything of a study as tidy tables: CSV, JSONL, and a codebook of their columns."""

import csv
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from reibench.errors import ReibenchError
from study.config import all_episodes
from study.enrolment import Enrolment

Row = Mapping[str, Any]
_OF_STUDY = "join participants as p on participant = p.code where p.study = ? {kept}"
QUERIES = {
    "participants": (
        "select code, version, slot, seed, state, accepted, reason, stage, simulated,"
        " quiz_tries, arrived, seen, ended, parameters"
        " from participants as p where p.study = ? {kept}"
        " order by arrived"
    ),
    "versions": (
        "select v.version, v.created, json as definition from study_versions as v"
        " where v.study = ? order by v.created"
    ),
    "assignments": (
        "select participant, kind, a.place, episode, task, level, record from assignments as a"
        f" {_OF_STUDY} order by arrived, kind, a.place"
    ),
    "trials": (
        "select participant, a.place, r.episode, r.task, task_type, r.level, room, r.status,"
        " error_kind, fault, said_done, steps, started, finished, r.id as record"
        " from assignments as a join records as r on r.id = a.record"
        f" {_OF_STUDY} and kind = 'trial' order by arrived, a.place"
    ),
    "steps": (
        "select participant, a.place, number, skill, s.success, message, seconds, s.created,"
        " s.record from steps as s join assignments as a on a.record = s.record"
        f" {_OF_STUDY} and kind = 'trial' order by arrived, a.place, number"
    ),
    "answers": (
        "select participant, a.stage, a.place, question, attempt, answer, right, created"
        f" from answers as a {_OF_STUDY} order by created"
    ),
    "page_times": (
        "select participant, t.stage, t.place, step, shown, left, hidden, created"
        f" from page_times as t {_OF_STUDY} order by created"
    ),
}
KEPT = "and p.simulated = 0 and p.state not in ('withdrawn', 'rejected')"
"""Whose data are exported unless all are asked for; those withdrawn have none left anyway."""
CODEBOOK: Mapping[str, Mapping[str, str]] = {
    "participants": {
        "code": "random code; the key of a participant in every table",
        "version": "version of the study they took part in",
        "slot": "number of their place in the design",
        "seed": "decided what was drawn for them",
        "state": "active, finished, no_consent, failed_check, withdrawn or rejected",
        "accepted": "when a researcher accepted them (UTC)",
        "reason": "why a researcher accepted, rejected or restored them",
        "stage": "where they are: consent … over",
        "simulated": "1 for those of `study simulate`",
        "quiz_tries": "how often the quiz was handed in",
        "arrived": "when they came (UTC)",
        "seen": "when they last did something (UTC)",
        "ended": "when they finished or left (UTC)",
        "parameters": "what the study keeps of their link, JSON",
    },
    "versions": {
        "version": "what participants.version refers to",
        "created": "when it was kept (UTC)",
        "definition": "the whole study as JSON: settings, questions, texts",
    },
    "assignments": {
        "participant": "code",
        "kind": "practice or trial",
        "place": "from 0, in the order played",
        "episode": "id, TASK.LEVEL",
        "task": "seed task",
        "level": "vagueness: reference-context",
        "record": "id of the record, if it was begun",
    },
    "trials": {
        "participant": "code",
        "place": "from 0, in the order played",
        "episode": "id, TASK.LEVEL",
        "task": "seed task",
        "task_type": "ALFRED's name",
        "object": "type of the thing the task is about; what the question of the kind `object`"
        " asks for",
        "level": "vagueness: reference-context",
        "room": "name of the room",
        "status": "success: the goal holds at the end; failure; truncated: budget of steps or time"
        " spent; error;"
        " empty while it is played",
        "error_kind": "the paper's two kinds: object-omission or execution-error",
        "fault": "the finer kind",
        "said_done": "1 if they ended it themselves",
        "steps": "how many",
        "started": "when it began (UTC)",
        "finished": "when it ended (UTC)",
        "record": "id of the record, as for planners",
    },
    "steps": {
        "participant": "code",
        "place": "of the trial, from 0",
        "number": "of the step, from 1",
        "skill": "what was done",
        "success": "1 if it could be done",
        "message": "what the page said if not",
        "seconds": "from when the page was shown to the choice, by the participant's clock",
        "created": "when it was kept (UTC, the server's clock)",
        "record": "id of the record",
    },
    "answers": {
        "participant": "code",
        "stage": "quiz, after (a trial) or end",
        "place": "of the trial, from 0",
        "question": "its name in the study",
        "attempt": "of the quiz, from 1",
        "answer": "as given; object questions are answered with an object type",
        "right": "1 or 0 where the study says what is right",
        "created": "when it was kept (UTC)",
    },
    "page_times": {
        "participant": "code",
        "stage": "of the page that was left",
        "place": "of the trial, from 0",
        "step": "number of the step that was chosen there; 0 elsewhere",
        "shown": "when the page was shown, ms since 1970 by the participant's clock",
        "left": "when something was chosen on it, likewise",
        "hidden": "ms in which it was out of sight",
        "created": "when it was kept (UTC, the server's clock)",
    },
}


def tables_of(enrolment: Enrolment, name: str, *, everybody: bool = False) -> dict[str, list[Row]]:
    """Return the tables of a study by name; `everybody` counts simulated and rejected people in."""
    enrolment.study(name)
    kept = "" if everybody else KEPT
    tables: dict[str, list[Row]] = {
        table: list(enrolment.store.query(query.format(kept=kept), [name]))
        for table, query in QUERIES.items()
    }
    objects = {episode.task.id: episode.task.goal.object for episode in all_episodes()}
    for at, row in enumerate(tables["trials"]):
        whole = {**row, "object": objects.get(str(row["task"]), "")}
        tables["trials"][at] = {name: whole[name] for name in CODEBOOK["trials"]}
    return tables


def export(enrolment: Enrolment, name: str, folder: Path, *, everybody: bool = False) -> list[Path]:
    """Write each table as CSV and JSONL, and the codebook; return the files.

    Raises:
        ReibenchError: when the folder cannot be written to.
    """
    tables = tables_of(enrolment, name, everybody=everybody)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        files = [folder / "codebook.md"]
        files[0].write_text(codebook(), encoding="utf-8")
        for table, rows in tables.items():
            files += [folder / f"{table}.csv", folder / f"{table}.jsonl"]
            _write_csv(files[-2], list(CODEBOOK[table]), rows)
            lines = (json.dumps(row, ensure_ascii=False) for row in rows)
            files[-1].write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
    except OSError as problem:
        raise ReibenchError(
            f"The export cannot be written to {folder}: {problem.strerror}."
        ) from None
    return files


def codebook() -> str:
    """Return what every column means, in Markdown."""
    parts = ["# Codebook\n"]
    for table, columns in CODEBOOK.items():
        rows = "\n".join(f"| `{name}` | {meaning} |" for name, meaning in columns.items())
        parts.append(f"## {table}\n\n| column | is |\n|---|---|\n{rows}\n")
    return "\n".join(parts)


def _write_csv(path: Path, columns: Sequence[str], rows: Sequence[Row]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        writer.writerows({name: _safe(value) for name, value in row.items()} for row in rows)


def _safe(value: object) -> object:
    """Keep a spreadsheet from taking an answer for a formula."""
    formula = isinstance(value, str) and value.startswith(("=", "+", "@", "\t", "-"))
    return f"'{value}" if formula else value
