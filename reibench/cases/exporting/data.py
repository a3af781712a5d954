"""Cases as data: one with everything that was recorded of it, many as a table."""

import csv
import io
from typing import Any

import pandas as pd

from reibench.cases.case import Case, Run
from reibench.cases.table import LANES
from reibench.cases.views.words import run_title
from reibench.dataset.files import episode_to_json
from reibench.explanation import explain
from reibench.faults import fault_kind
from reibench.rollout import Step
from reibench.verdict import error_kind

COLUMNS = (
    "episode", "title", "task_type", "level", "room", "planner", "model", "method", "rules", "kind",
    *(f"{lane}_{name}" for lane in LANES for name in ("id", "status", "error_kind", "fault",
                                                      "reason", "steps")),
)  # fmt: skip


def case_data(case: Case) -> dict[str, Any]:
    """Return a case as values for JSON: the episode, and each run step by step."""
    return {
        "title": case.title,
        "episode": episode_to_json(case.episode),
        "rows": [list(row) for row in case.rows],
        "first_divergence": case.split,
        "runs": [_run(run) for run in case.runs],
    }


def _run(run: Run) -> dict[str, Any]:
    record, told = run.record, run.record.instruction
    kind, fault = error_kind(record), fault_kind(record)
    return {
        "id": run.id,
        "title": run_title(run),
        "lane": run.lane,
        "planner": run.planner,
        "method": run.method,
        "model": run.model,
        "rules": run.rules,
        "max_steps": run.max_steps,
        "status": record.status,
        "said_done": record.said_done,
        "error_kind": kind and str(kind),
        "fault": fault and str(fault),
        "verdict": explain(record),
        "instruction": None if told is None else {"original": told.original, "text": told.text},
        "steps": [_step(step) for step in record.steps],
    }


def _step(step: Step) -> dict[str, Any]:
    usage = step.decision.usage
    return {
        "number": step.number,
        "skill": step.decision.skill.text,
        "success": step.event.success,
        "message": step.event.message,
        "goals": {goal.text: goal.holds for goal in step.event.goals},
        "seconds": step.seconds,
        "alternatives": {a.text.strip(): a.probability for a in step.decision.alternatives},
        "tokens": {
            "prompt": usage.prompt_tokens,
            "cached": usage.cached_tokens,
            "output": usage.completion_tokens,
        },
        "prompt": step.decision.prompt,
    }


def cases_csv(cases: pd.DataFrame) -> str:
    """Return cases as a CSV table, one row a case; no cell is read as a formula."""
    file = io.StringIO()
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(COLUMNS)
    for row in cases[list(COLUMNS)].itertuples(index=False):
        writer.writerow(["" if pd.isna(cell) else _plain(cell) for cell in row])
    return file.getvalue()


def _plain(cell: object) -> object:
    """Return a cell that a spreadsheet takes for what it is."""
    if isinstance(cell, float) and cell.is_integer():
        return int(cell)
    if isinstance(cell, str) and cell[:1] in ("=", "+", "-", "@", "\t", "\r"):
        return f"'{cell}"
    return cell
