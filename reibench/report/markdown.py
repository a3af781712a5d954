"""Scores as Markdown tables."""

from collections.abc import Callable, Iterable, Sequence

from reibench.report import Row
from reibench.report.labels import TITLES
from reibench.report.paper import in_words, our_words
from reibench.report.text import NOTHING, points, rate
from reibench.score import FAULTS

COSTS = {
    "tokens in": "input_tokens",
    "evaluated": "evaluated_tokens",
    "out": "output_tokens",
    "model, ms": "model_ms",
    "in all, ms": "total_ms",
}


def score_markdown(rows: list[Row]) -> str:
    """Return what there is to say about these rows, table after table."""
    if not rows:
        return NOTHING
    tables = [outcomes(rows)]
    if any(row["cost"] and row["cost"]["total_tokens"] for row in rows):
        tables.append(planning_steps(rows))
    if any("paired" in row for row in rows):
        tables.append(_compared(rows))
    if any("against_paper" in row for row in rows):
        tables.append(_against_paper(rows))
    return "\n\n".join(tables)


def outcomes(rows: list[Row]) -> str:
    """Return a table with groups and totals down, units across: solved of played in cells.

    A number in brackets says how many of the solved were also said to be done, where it differs.
    """
    names = [name for name in rows[0] if name.startswith("by_")]
    lines = []
    for name in names:
        columns = name.removeprefix("by_").split(",")
        found = [{_key(group, columns): group for group in row[name]} for row in rows]
        keys = dict.fromkeys(key for each in found for key in each)
        lines += [[key, *(_solved(each.get(key)) for each in found)] for key in keys]
    for kind, title in TITLES.items():
        lines.append([f"**{title}**", *(" ".join(rate(row, kind).split()) for row in rows)])
        lines += _faults(rows, kind)
    apart = [row["determined_only"] for row in rows]
    pairs = list(zip(rows, apart, strict=True))
    if any(each and each["episodes"] != row["episodes"] for row, each in pairs):
        cells = (" ".join(rate(each, "success").split()) if each else "–" for each in apart)
        lines.append(["success without the underdetermined", *cells])
    first = " / ".join(name.removeprefix("by_").replace(",", ", ") for name in names)
    return table([first, *map(_title, rows)], lines)


def planning_steps(rows: list[Row]) -> str:
    """Return what a planning step costs, as in the paper's token table."""
    lines = []
    for row in rows:
        cost = row["cost"]
        if not cost or not cost["decisions"]:
            continue
        told = f"{cost['method_input_tokens']:,.0f} + {cost['method_output_tokens']:,.0f}"
        done = f"{cost['closing_input_tokens']:,.0f} + {cost['closing_output_tokens']:,.0f}"
        lines.append(
            [
                _title(row),
                *(f"{cost[name]:,.1f}" for name in COSTS.values()),
                told if cost["method_total_tokens"] else "–",
                done if cost["closing_total_tokens"] else "–",
                f"{cost['dollars']:.4f}" if cost["dollars"] else "–",
            ]
        )
        if published := row.get("against_paper", {}).get("cost"):
            lines.append(
                [
                    "*the paper's LLaMA3.1-8B*",
                    f"{published['input_tokens']:,.0f}",
                    "",
                    f"{published['output_tokens']:,.0f}",
                    "",
                    f"{published['latency_ms']:,.1f}",
                    *[""] * 3,
                ]
            )
    apart = ["restating, an episode", "saying done, an episode", "dollars in all"]
    return table(["a planning step", *COSTS, *apart], lines)


def table(header: Sequence[str], lines: Iterable[Sequence[str]]) -> str:
    """Return a Markdown table."""
    rows = [header, ["---"] * len(header), *lines]
    marked: Callable[[str], str] = lambda cell: cell.replace("|", "\\|")  # noqa: E731
    text = ["| " + " | ".join(map(marked, row)) + " |" for row in rows]
    return "\n".join([text[0], "|---" * len(header) + "|", *text[2:]])


def _title(row: Row) -> str:
    return str(row["actor"]) + (f" ({row['verification']})" if row["verification"] else "")


def _key(group: Row, columns: list[str]) -> str:
    return " ".join(str(group[column]) for column in columns)


def _solved(group: Row | None) -> str:
    if group is None:
        return "–"
    text = f"{group['success']}/{group['episodes']}"
    if group["success_said_done"] == group["success"]:
        return text
    return f"{text} ({group['success_said_done']})"


def _faults(rows: list[Row], kind: str) -> Iterable[list[str]]:
    for fault in FAULTS.get(kind, ()):
        counts = [row["faults"][kind][str(fault)] for row in rows]
        if any(counts):
            yield [f"– {fault.replace('-', ' ')}", *map(str, counts)]


def _compared(rows: list[Row]) -> str:
    lines = []
    for row in rows:
        for reading in ("success", "success_said_done"):
            if "paired" not in row or not row["paired"][reading]["episodes"]:
                continue
            result = row["paired"][reading]
            lines.append(
                [
                    _title(row) if reading == "success" else TITLES[reading],
                    f"{result['episodes']} of {result['tasks']} tasks",
                    points(result),
                    str(result["only_second"]),
                    str(result["only_first"]),
                    f"{result['p']:.3g}",
                ]
            )
    first = next(row["paired"]["actor"] for row in rows if "paired" in row)
    header = [f"against {first}", "shared episodes", "success", "only here", "only there", "p"]
    return table(header, lines)


def _against_paper(rows: list[Row]) -> str:
    lines = [
        [
            _title(row),
            f"{each['reference']}-{each['context']}",
            each["metric"].replace("_", " "),
            our_words(each),
            in_words(each["published"]),
        ]
        for row in rows
        for each in row["against_paper"]["errors"]
    ]
    return table(["run", "level", "error rate, %", "ours", "the paper (SayCan)"], lines)
