"""The gallery: real runs that come along, exactly as they were recorded.

Any can be replayed. They were chosen, to show what happens, and count in no table.
"""

import base64
import gzip
import json
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from reibench.errors import ReibenchError
from reibench.store import Store

FILE = Path(__file__).parents[1] / "assets" / "gallery" / "runs.jsonl.gz"
TABLES = ("runs", "episodes", "scenes", "records", "steps")
_OF_RECORDS = {
    "runs": "select * from runs where id in (select run from records where {})",
    "episodes": "select * from episodes where digest in"
    " (select episode_digest from records where {})",
    "scenes": "select * from scenes where digest in (select start_scene from records where {})",
    "records": "select * from records where {}",
    "steps": "select * from steps where record in (select id from records where {})"
    " order by record, number",
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


def save(store: Store, chosen: Sequence[GalleryCase], file: Path = FILE) -> int:
    """Write these cases' records as they are in `store`; return the bytes of the file.

    Raises:
        ReibenchError: for a record that is not there or not finished.
    """
    ids = list(dict.fromkeys(id_ for case in chosen for id_ in (case.plain, case.told)))
    where = f"id in ({', '.join('?' * len(ids))})"
    known = {
        row["id"]
        for row in store.query(f"select id from records where {where} and status not null", ids)
    }
    if missing := [each for each in ids if each not in known]:
        raise ReibenchError(f"The database has no finished record {missing[0]!r}.")
    lines: list[dict[str, Any]] = [{"cases": [vars(case) for case in chosen]}]
    for table in TABLES:
        rows = store.query(_OF_RECORDS[table].format(where), ids)
        lines += [{"table": table, "row": _to_json(row)} for row in rows]
    file.parent.mkdir(parents=True, exist_ok=True)
    text = "".join(json.dumps(line, ensure_ascii=False) + "\n" for line in lines)
    # no time of writing in it: the same records give the same file
    file.write_bytes(gzip.compress(text.encode(), 9, mtime=0))
    return file.stat().st_size


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


def matching(store: Store, pairs: Iterable[tuple[str, str, str]]) -> list[GalleryCase]:
    """Return the cases of episode, model and method triples, from the runs of a database.

    Raises:
        ReibenchError: where a run without the method or with it is missing.
    """
    found = []
    for episode, model, method in pairs:
        ids = {}
        for name in ("none", method):
            rows = store.query(
                "select records.id from records join runs on runs.id = run where episode = ?"
                " and model = ? and method = ? and planner = 'saycan' and status not null"
                " order by finished desc limit 1",
                [episode, model, name],
            )
            if not rows:
                raise ReibenchError(
                    f"The database has no finished run of {episode} with {model}, method {name}."
                )
            ids[name] = rows[0]["id"]
        found.append(GalleryCase(episode, ids["none"], ids[method]))
    return found
