"""A database's records as one table to score: what came out, under which settings, at what cost."""

import json
from collections.abc import Iterator
from typing import Any

import pandas as pd

from reibench.backends import Usage
from reibench.dialogue import Vagueness
from reibench.store import Store
from reibench.store.thoughts import usage_from_json

SETTINGS = ("world", "rules", "max_steps", "seed", "code")
"""What a run's spec says beside planner, method and model."""

_RECORDS = """
with spent as (
    select record, sum(json_extract(usage, '$[0]')) as prompt_tokens,
        sum(json_extract(usage, '$[1]')) as cached_tokens,
        sum(json_extract(usage, '$[2]')) as output_tokens,
        sum(json_extract(usage, '$[3]')) as model_seconds,
        sum(coalesce(json_extract(usage, '$[4]'), 0)) as dollars, sum(seconds) as seconds
    from steps group by record
)
select records.id, run, records.actor, episode, episode_digest, task, task_type, level,
    underdetermined, room, status, error_kind, fault, said_done, steps, planner, method, model,
    spec, json_extract(instruction, '$.usage') as method_usage,
    json_extract(closing, '$.usage') as closing_usage, prompt_tokens, cached_tokens,
    output_tokens, model_seconds, dollars, seconds
from records join runs on runs.id = run left join spent on spent.record = records.id
where origin = ? order by runs.created, runs.rowid, records.started, records.rowid
"""
_COSTS = ("prompt_tokens", "cached_tokens", "output_tokens", "model_seconds", "dollars")


def records_frame(store: Store, origin: str = "run") -> pd.DataFrame:
    """Return one row a record of that origin, oldest run first.

    Beside the record's own columns: its run's `planner`, `method`, `model` and settings; its level
    as `reference` and `context`; and its cost. `prompt_tokens`, `cached_tokens`, `output_tokens`,
    `model_seconds` and `dollars` are those of all its model calls together; with `method_` and
    `closing_` before it, of restating the instruction and of saying done among them. `seconds` is
    all the thinking time, `decisions` the steps and, where the actor said it, done.
    """
    rows = store.query(_RECORDS, [origin])
    return pd.DataFrame([dict(_told(row)) for row in rows])


def note_faults(store: Store, most: int = -1) -> int:
    """Judge old records by today's rules, where those have changed since; return how many.

    At most so many, the latest first; a negative number for all.
    """
    rows = store.query(
        "select id, finished from records where status not null and reason is null union"
        " select id, finished from records where fault is null"
        " and status in ('failure', 'truncated') order by finished desc limit ?",
        [most],
    )
    store.judge(store.record(row["id"]) for row in rows)
    return len(rows)


def _told(row: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    """Yield the columns of a record's row in the table."""
    spec = json.loads(row["spec"])
    yield from ((name, row[name]) for name in row if name not in _COSTS and "usage" not in name)
    yield from ((name, spec.get(name, "")) for name in SETTINGS)
    level = Vagueness.parse(row["level"])
    yield "reference", level.reference
    yield "context", level.context
    method, closing = _usage(row["method_usage"]), _usage(row["closing_usage"])
    for name in _COSTS:
        of_method, of_closing = _part(method, name), _part(closing, name)
        yield f"method_{name}", of_method
        yield f"closing_{name}", of_closing
        yield name, (row[name] or 0) + of_method + of_closing
    # The first step's clock starts before the method is asked; no step's runs while done is said.
    unclocked = closing.seconds + (0 if row["steps"] else method.seconds)
    yield "seconds", (row["seconds"] or 0) + unclocked
    yield "decisions", row["steps"] + row["said_done"]


def _usage(text: str | None) -> Usage:
    return usage_from_json(text) if text else Usage()


def _part(usage: Usage, cost: str) -> float:
    parts = {"output_tokens": usage.completion_tokens, "model_seconds": usage.seconds}
    return parts[cost] if cost in parts else float(getattr(usage, cost))
