"""The gallery: real runs that come along, exactly as they were recorded.

Any can be replayed. They were chosen, to show what happens, and count in no table.
"""

import base64
import csv
import gzip
import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from reibench.errors import ReibenchError
from reibench.store import Store

FILE = Path(__file__).parents[1] / "assets" / "gallery" / "runs.jsonl.gz"
TABLES = ("runs", "episodes", "scenes", "records", "steps")
_OF_RECORD = {
    "runs": "select * from runs where id = (select run from records where id = ?)",
    "episodes": "select * from episodes where digest ="
    " (select episode_digest from records where id = ?)",
    "scenes": "select * from scenes where digest = (select start_scene from records where id = ?)",
    "records": "select * from records where id = ?",
    "steps": "select * from steps where record = ? order by number",
}


@dataclass(frozen=True)
class GalleryCase:
    """Two runs of one episode, without a method and with one."""

    episode: str
    plain: str
    told: str


def cases(file: Path = FILE) -> tuple[GalleryCase, ...]:
    """Return the gallery's cases, the best first; none where there is no gallery."""
    if not file.exists():
        return ()
    [first] = [line for line, _ in zip(_lines(file), range(1), strict=False)]
    return tuple(GalleryCase(**each) for each in first["cases"])


def save(chosen: Sequence[tuple[Store, GalleryCase]], file: Path = FILE) -> int:
    """Write these cases' records as they are in their databases; return the bytes of the file.

    Raises:
        ReibenchError: for a record that is not there or not finished.
    """
    lines: list[dict[str, Any]] = [{"cases": [vars(case) for _, case in chosen]}]
    written: set[str] = set()
    for store, case in chosen:
        for record_id in (case.plain, case.told):
            if record_id not in written:
                written.add(record_id)
                lines += _record_lines(store, record_id)
    # what several records share stands once
    unique = dict.fromkeys(json.dumps(line, ensure_ascii=False) for line in lines)
    file.parent.mkdir(parents=True, exist_ok=True)
    text = "".join(f"{line}\n" for line in unique)
    # no time of writing in it: the same records give the same file
    file.write_bytes(gzip.compress(text.encode(), 9, mtime=0))
    return file.stat().st_size


def _record_lines(store: Store, record_id: str) -> Iterator[dict[str, Any]]:
    """Yield the rows a record consists of, those it refers to before those that refer."""
    known = store.query("select id from records where id = ? and status not null", [record_id])
    if not known:
        raise ReibenchError(f"The database {store.path} has no finished record {record_id!r}.")
    for table in TABLES:
        for row in store.query(_OF_RECORD[table], [record_id]):
            yield {"table": table, "row": _to_json(row)}


def load(store: Store, file: Path = FILE) -> int:
    """Put the gallery's records into a database that lacks them; return how many it lacked."""
    if not file.exists():
        return 0
    known = {row["id"] for row in store.query("select id from records where origin = 'gallery'")}
    if {id_ for case in cases(file) for id_ in (case.plain, case.told)} <= known:
        return 0
    added = 0
    with store.writing() as database:
        for line in _lines(file):
            if "table" not in line:
                continue
            row = _from_json(line["row"])
            if line["table"] == "records":
                row |= {"origin": "gallery", "visitor": None}
            columns = ", ".join(row)
            held = ", ".join("?" * len(row))
            done = database.execute(
                f"insert or ignore into {line['table']} ({columns}) values ({held})",
                list(row.values()),
            )
            added += done.rowcount if line["table"] == "records" else 0
    return added


def _lines(file: Path) -> Iterator[dict[str, Any]]:
    with gzip.open(file, "rt", encoding="utf-8") as lines:
        for line in lines:
            yield json.loads(line)


def _to_json(row: dict[str, Any]) -> dict[str, Any]:
    """Return a row as JSON takes it: bytes as text that says so."""
    return {
        name: {"base64": base64.b64encode(value).decode()} if isinstance(value, bytes) else value
        for name, value in row.items()
    }


def _from_json(row: dict[str, Any]) -> dict[str, Any]:
    return {
        name: base64.b64decode(value["base64"]) if isinstance(value, dict) else value
        for name, value in row.items()
    }


def matching(store: Store, episode: str, model: str, method: str) -> GalleryCase | None:
    """Return the latest runs of an episode by a model, without the method and with it, if any."""
    ids = []
    for name in ("none", method):
        rows = store.query(
            "select records.id from records join runs on runs.id = run where episode = ?"
            " and model = ? and method = ? and planner = 'saycan' and status not null"
            " order by finished desc limit 1",
            [episode, model, name],
        )
        ids += [row["id"] for row in rows]
    return GalleryCase(episode, *ids) if len(ids) == 2 else None


def read_choice(file: Path) -> list[tuple[str, str, str]]:
    """Return the episodes, models and methods of a table of cases to show, the best first."""
    with file.open(encoding="utf-8", newline="") as rows:
        return [(row["episode"], row["model"], row["method"]) for row in csv.DictReader(rows)]
