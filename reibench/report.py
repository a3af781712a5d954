"""Scores as rows for machines and as text for people."""

import json
from typing import Any

import pandas as pd

from reibench.score import COUNTED, paired, records_frame, summarise
from reibench.store import Store
from reibench.worlds.naming import verified

TITLES = {
    "success": "success",
    "success_said_done": "… and said done",
    "object_omission": "object omission",
    "execution_error": "execution error",
    "breakdown": "breakdown",
}


def score_rows(store: Store, runs: set[str] | None, by: str) -> list[dict[str, Any]]:
    """Return one row a run, with its groups by `by` inside, and its difference to the first run."""
    frame = records_frame(store)
    if frame.empty:
        return []
    if runs is not None:
        frame = frame[frame["run"].isin(runs)]
    groups = summarise(frame, ["run", by])
    # Episodes that nobody can be sure about bound what any actor can reach (reading of B.3).
    determined = summarise(frame[frame["underdetermined"] == 0], ["run"])
    rows: list[dict[str, Any]] = []
    for row in _plain(summarise(frame, ["run"])):
        run = row.pop("run")
        first = frame[frame["run"] == run].iloc[0]
        spec = json.loads(first["spec"])
        mine = _plain(groups[groups["run"] == run].drop(columns="run"))
        apart = _plain(determined[determined["run"] == run].drop(columns="run"))
        rows.append(
            {
                "run": run,
                "actor": first["actor"],
                "verification": verified(spec["world"]),
                **row,
                "determined_only": apart[0] if apart else None,
                "spec": spec,
                f"by_{by}": mine,
            }
        )
    for row in rows[1:]:
        row["against_first"] = paired(frame, rows[0]["run"], row["run"])
    return rows


def _plain(frame: pd.DataFrame) -> list[dict[str, Any]]:
    """Return rows of plain numbers, with `null` where a rate has no trials."""
    rows: list[dict[str, Any]] = json.loads(frame.to_json(orient="records", double_precision=4))
    return rows


def score_report(rows: list[dict[str, Any]], by: str) -> str:
    """Return the scores as text."""
    if not rows:
        return "No episode has been run yet."
    parts = []
    for row in rows:
        spec = row["spec"]
        lines = [
            f"{row['actor']}  ·  {_where(spec)}{spec['rules']} rules, {spec['max_steps']} steps,"
            f" code {spec['code']}, run {row['run']}",
            f"  {row['episodes']} episodes"
            + (f", {row['unfinished']} unfinished" if row["unfinished"] else "")
            + (f", {row['mean_steps']:.1f} steps on average" if row["episodes"] else ""),
        ]
        lines += [f"  {TITLES[name]:<18}{_rate(row, name)}" for name in COUNTED]
        apart = row["determined_only"]
        if apart and apart["episodes"] != row["episodes"]:
            left = row["episodes"] - apart["episodes"]
            lines.append(f"  without {left} underdetermined: success {_rate(apart, 'success')}")
        for group in row[f"by_{by}"]:
            lines.append(f"    {group[by]:<20} success {_rate(group, 'success')}")
        if versus := row.get("against_first"):
            lines.append(
                f"  against the first run, on {versus['episodes']} shared episodes: only here"
                f" {versus['only_second']}, only there {versus['only_first']} solved;"
                f" p = {versus['p']:.3g} (exact McNemar; episodes of a task are not independent)"
            )
        parts.append("\n".join(lines))
    return "\n\n".join(parts)


def score_markdown(rows: list[dict[str, Any]], by: str) -> str:
    """Return a Markdown table: groups and totals down, runs across, solved of played in cells."""
    groups = list(dict.fromkeys(group[by] for row in rows for group in row[f"by_{by}"]))
    lines = [
        f"| {by} | " + " | ".join(row["actor"] + _marked(row["spec"]) for row in rows) + " |",
        "|---" * (len(rows) + 1) + "|",
    ]
    for name in groups:
        cells = [
            next((f"{g['success']}/{g['episodes']}" for g in row[f"by_{by}"] if g[by] == name), "–")
            for row in rows
        ]
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    for name, title in TITLES.items():
        cells = [f"{_rate(row, name).strip()}" for row in rows]
        lines.append(f"| **{title}** | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _where(spec: dict[str, Any]) -> str:
    """Name a world that is not the usual one, and how far its results can be trusted."""
    if spec["world"] == "embedded":
        return ""
    return f"{spec['world']}{_marked(spec)}, "


def _marked(spec: dict[str, Any]) -> str:
    return f" ({verified(spec['world'])})" if verified(spec["world"]) else ""


def _rate(row: dict[str, Any], name: str) -> str:
    if not row["episodes"]:
        return "–"
    low, high = row[f"{name}_low"], row[f"{name}_high"]
    return (
        f"{row[name]:>3} of {row['episodes']:<3} {row[f'{name}_rate']:>6.1%}"
        f"  [{low:.1%}, {high:.1%}]"
    )
