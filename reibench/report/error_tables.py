"""The paper's tables of errors, by model and by method, in LaTeX."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import pandas as pd

from reibench.dialogue import CONTEXTS, REFERENCES
from reibench.published import ERRORS
from reibench.report.labels import (
    distinct,
    each_run,
    method_label,
    model_label,
    model_labels,
    place_of,
    planner_label,
)
from reibench.report.latex import NEEDS, NO_EPISODES, counted, escaped, row, table
from reibench.report.paper import error_rate
from reibench.report.selecting import contestants
from reibench.score import summarise

LEVEL_LABELS = {"explicit": "Explicit REs", "mixed": "Mixed REs", "implicit": "Implicit REs"}
SETTINGS = ["planner", "model", "world", "rules", "max_steps", "seed"]
"""What the runs of one table of methods share."""
Rates = dict[str, float]
"""Error rates in per cent, by kind."""


@dataclass(frozen=True)
class Block:
    """One run's rows in a table of errors: its rates at each reference and context."""

    label: str
    rates: dict[tuple[str, str], Rates]
    baseline: dict[tuple[str, str], Rates]
    """What differences are to; empty where none are printed."""
    compared: tuple[str, ...] = ERRORS
    """The kinds whose differences are printed."""


def errors_by_model(frame: pd.DataFrame, contexts: Sequence[str] = CONTEXTS[:1]) -> str:
    """Return the table of errors of each planner and model without a method.

    With the standard context alone, differences to the explicit level are printed, as in the
    paper's main text; with more contexts none are, as in its appendix.
    """
    chosen = contestants(frame, ("none",))
    runs = each_run(chosen)
    blocks = []
    for label, run in zip(distinct(runs, model_labels(runs)), runs["run"], strict=True):
        rates = _rates(chosen[chosen["run"] == run])
        explicit: dict[tuple[str, str], Rates] = {
            (reference, context): rates[("explicit", context)]
            for reference in REFERENCES[1:]
            for context in contexts
            if len(contexts) == 1 and ("explicit", context) in rates
        }
        blocks.append(Block(label, rates, explicit))
    what = "without a prompting method"
    return f"{NEEDS}\n{_error_table('Model', what, blocks, contexts, chosen)}"


def errors_by_method(frame: pd.DataFrame, contexts: Sequence[str] = CONTEXTS[:1]) -> str:
    """Return a table of errors for each planner and model: no method first, then each method.

    With the standard context alone, differences to no method are printed, of object omission and
    overall, and the least object omission of a level is bold; as in the paper.
    """
    tables = [NEEDS]
    for _, part in contestants(frame).groupby(SETTINGS, sort=False):
        runs = each_run(part).sort_values("method", key=lambda names: names.map(place_of))
        [named], [planner] = set(runs["model"].map(model_label)), set(runs["planner"])
        methods = list(runs["method"])
        said = [named if method == "none" else method_label(method) for method in methods]
        rates = [_rates(part[part["run"] == run]) for run in runs["run"]]
        plain = rates[0] if methods[0] == "none" and len(contexts) == 1 else {}
        blocks = [
            Block(label, mine, {} if mine is plain else plain, ("object_omission", "overall_error"))
            for label, mine in zip(distinct(runs, said), rates, strict=True)
        ]
        what = f"under different prompting methods, for {named} with {planner_label(planner)}"
        bold = len(contexts) == 1 and len(blocks) > 1
        tables.append(_error_table("Method", what, blocks, contexts, part, bold=bold))
    return "\n\n".join(tables)


def _error_table(
    first: str,
    what: str,
    blocks: Sequence[Block],
    contexts: Sequence[str],
    records: pd.DataFrame,
    *,
    bold: bool = False,
) -> str:
    several = len(contexts) > 1
    context = "" if several else " with ``Standard Context''"
    shown = records[records["context"].isin(contexts)]
    caption = (
        "Error rates (\\%) for the object omission and execution error types"
        f" {escaped(what)}{context}. {counted(shown)}"
    )
    body = ["\\toprule", *_error_header(first, several=several), "\\midrule"]
    least = _least_omission(blocks) if bold else {}
    for number, block in enumerate(blocks):
        body += ["\\midrule"] if number else []
        body += _block_rows(block, contexts, least)
    body.append("\\bottomrule")
    label = f"errors_by_{first.lower()}" + ("_all_contexts" if several else "")
    return table(caption, label, "l" + "c" * (4 + several), body)


def _error_header(first: str, *, several: bool) -> list[str]:
    context = ["\\multirow{2}{*}{\\makecell{Context \\\\ Memory Type}}"] if several else []
    return [
        row(
            f"\\multirow{{2}}{{*}}{{{first}}}",
            *context,
            "\\multirow{2}{*}{Implicit REs Level}",
            "\\multicolumn{2}{c}{Error Type}",
            "\\multirow{2}{*}{Overall Error Rate}",
        ),
        row("", *[""] * several, "", "Object Omission Rate", "Execution Error Rate", ""),
    ]


def _block_rows(
    block: Block, contexts: Sequence[str], least: dict[tuple[str, str], float]
) -> Iterator[str]:
    height = len(REFERENCES) * len(contexts)
    for number, context in enumerate(contexts):
        if number:
            yield f"\\cmidrule(r){{2-{3 + len(ERRORS)}}}"
        for place, reference in enumerate(REFERENCES):
            begins = place == number == 0
            cells = [f"\\multirow{{{height}}}{{*}}{{{escaped(block.label)}}}" if begins else ""]
            if len(contexts) > 1:
                named = f"\\multirow{{{len(REFERENCES)}}}{{*}}{{{context.title()}}}"
                cells.append("" if place else named)
            level = (reference, context)
            cells.append(LEVEL_LABELS[reference])
            yield row(*cells, *(_cell(block, level, kind, least) for kind in ERRORS))


def _cell(
    block: Block, level: tuple[str, str], kind: str, least: dict[tuple[str, str], float]
) -> str:
    if level not in block.rates:
        return NO_EPISODES
    value = block.rates[level][kind]
    text = f"{value:.1f}"
    if kind == "object_omission" and least.get(level) == value:
        text = f"\\textbf{{{text}}}"
    if kind not in block.compared or level not in block.baseline:
        return text
    # Of the printed numbers, so that a reader who subtracts finds the same.
    difference = round(value - block.baseline[level][kind], 1) + 0.0
    return f"{text} (\\({difference:+.1f}\\))"


def _least_omission(blocks: Iterable[Block]) -> dict[tuple[str, str], float]:
    least: dict[tuple[str, str], float] = {}
    for block in blocks:
        for level, rates in block.rates.items():
            least[level] = min(least.get(level, 100.0), rates["object_omission"])
    return least


def _rates(records: pd.DataFrame) -> dict[tuple[str, str], Rates]:
    return {
        (each["reference"], each["context"]): {kind: error_rate(each, kind)[0] for kind in ERRORS}
        for each in summarise(records, ["reference", "context"]).to_dict("records")
        if each["episodes"]
    }
