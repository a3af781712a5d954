"""Tables of tokens and of success, in LaTeX."""

from collections.abc import Iterator, Mapping
from typing import Any

import pandas as pd

from reibench.dialogue import CONTEXTS, REFERENCES
from reibench.report.labels import (
    distinct,
    each_run,
    method_label,
    model_label,
    model_labels,
    place_of,
    planner_label,
)
from reibench.report.latex import (
    NEEDS,
    NO_EPISODES,
    TO_THE_WIDTH,
    counted,
    escaped,
    row,
    table,
)
from reibench.report.selecting import contestants
from reibench.score import costs, summarise


def token_table(frame: pd.DataFrame) -> str:
    """Return the table of tokens and latency per planning step."""
    chosen = contestants(frame)
    runs = each_run(chosen).sort_values(
        "method", key=lambda names: names.map(place_of), kind="stable"
    )
    runs = runs.sort_values(["planner", "model"], kind="stable")
    spent = costs(chosen, ["run"]).set_index("run")
    named = [
        model if method == "none" else f"{model} {method_label(method)}"
        for model, method in zip(model_labels(runs, planners=True), runs["method"], strict=True)
    ]
    labels = distinct(runs, named)
    paid = bool((spent["dollars"] > 0).any()) if len(spent) else False
    lines = [
        row(escaped(label), *_cost_cells(spent.loc[run], paid=paid))
        for label, run in zip(labels, runs["run"], strict=True)
        if run in spent.index and spent.loc[run, "decisions"]
    ]
    header = [
        ("Method", ""),
        ("Avg Input", "Tokens"),
        ("Evaluated", "Tokens"),
        ("Avg Output", "Tokens"),
        ("Avg Total", "Tokens"),
        ("Model", "(ms)"),
        ("Latency", "(ms)"),
        ("Restating", "(in + out)"),
        ("Saying Done", "(in + out)"),
        *[("Cost", "(\\$)")] * paid,
    ]
    upper, lower = zip(*header, strict=True)
    caption = (
        "Average token usage and latency per planning step: a skill, or saying done. Every model"
        " call is counted in; what restating the instruction and saying done took of it is also"
        " said apart, per episode. Evaluated are the input tokens that were in no cache."
    )
    body = ["\\toprule", row(*upper), row(*lower), "\\midrule", *lines, "\\bottomrule"]
    return f"{NEEDS}\n{table(caption, 'token_latency', 'l' + 'c' * (len(header) - 1), body)}"


def _cost_cells(cost: "pd.Series[float]", *, paid: bool) -> Iterator[str]:
    for name in ("input_tokens", "evaluated_tokens", "output_tokens", "total_tokens"):
        yield f"{cost[name]:.0f}"
    for name in ("model_ms", "total_ms"):
        yield f"{cost[name]:.2f}"
    for part in ("method", "closing"):
        told, answered = cost[f"{part}_input_tokens"], cost[f"{part}_output_tokens"]
        yield f"{told:.0f} + {answered:.0f}" if told or answered else NO_EPISODES
    if paid:
        yield f"{cost['dollars']:.4f}"


def success_table(frame: pd.DataFrame) -> str:
    """Return success at each level and over all, in both readings, with intervals over all."""
    chosen = contestants(frame)
    runs = each_run(chosen)
    levels = summarise(chosen, ["run", "reference", "context"])
    whole = summarise(chosen, ["run"]).set_index("run")
    cells = {
        (each["run"], each["context"], each["reference"]): _two_readings(each)
        for each in levels.to_dict("records")
    }
    settings = zip(runs["planner"], runs["model"], runs["method"], strict=True)
    plain = [
        f"{planner_label(planner)}, {model_label(model)}, {method_label(method)}"
        for planner, model, method in settings
    ]
    lines = []
    for label, run in zip(distinct(runs, plain), runs["run"], strict=True):
        places = [(run, context, reference) for context in CONTEXTS for reference in REFERENCES]
        over_all = [
            _with_interval(whole.loc[run], reading) for reading in ("success", "success_said_done")
        ]
        found = (cells.get(place, NO_EPISODES) for place in places)
        lines.append(row(escaped(label), *found, *over_all))
    spans = "".join(f"& \\multicolumn{{3}}{{c}}{{{each.title()}}} " for each in CONTEXTS)
    header = [
        f"\\multirow{{2}}{{*}}{{Run}} {spans}& \\multicolumn{{2}}{{c}}{{All}} \\\\",
        "\\cmidrule(r){2-4}\\cmidrule(r){5-7}\\cmidrule(r){8-10}\\cmidrule(r){11-12}",
        row("", *[each.title() for each in REFERENCES] * 3, "Goal holds", "and said done"),
    ]
    caption = (
        "Success rates (\\%) by context and level of implicit REs: the goal holds at the end~/ and"
        f" the planner also said done; over all with 95\\% Wilson intervals. {counted(chosen)}"
    )
    body = ["\\toprule", *header, "\\midrule", *lines, "\\bottomrule"]
    return f"{NEEDS}\n{table(caption, 'success', 'l' + 'c' * 11, body, TO_THE_WIDTH)}"


def _two_readings(group: Mapping[Any, Any]) -> str:
    if not group["episodes"]:
        return NO_EPISODES
    return f"{100 * group['success_rate']:.1f}~/ {100 * group['success_said_done_rate']:.1f}"


def _with_interval(group: "pd.Series[float]", reading: str) -> str:
    if not group["episodes"]:
        return NO_EPISODES
    rate, low, high = (100 * group[f"{reading}_{end}"] for end in ("rate", "low", "high"))
    return f"{rate:.1f} [{low:.1f}, {high:.1f}]"
