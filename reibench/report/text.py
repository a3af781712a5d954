"""Scores as text for the terminal."""

from collections.abc import Iterator
from typing import Any

from reibench.report import Row
from reibench.report.labels import TITLES
from reibench.report.paper import in_words, our_words
from reibench.score import COUNTED

NOTHING = "No episode has been run yet."


def score_report(rows: list[Row]) -> str:
    """Return the scores as text."""
    if not rows:
        return NOTHING
    return "\n\n".join("\n".join(_block(row)) for row in rows)


def _block(row: Row) -> Iterator[str]:
    yield _heading(row)
    yield (
        f"  {row['episodes']} episodes"
        + (f", {row['unfinished']} unfinished" if row["unfinished"] else "")
        + (f", {row['mean_steps']:.1f} steps on average" if row["episodes"] else "")
    )
    for name in COUNTED:
        yield f"  {TITLES[name]:<18}{rate(row, name)}"
        if finer := fault_counts(row, name):
            yield f"      {finer}"
    apart = row["determined_only"]
    if apart and apart["episodes"] != row["episodes"]:
        left = row["episodes"] - apart["episodes"]
        yield f"  without {left} underdetermined: success {rate(apart, 'success')}"
    for name in (name for name in row if name.startswith("by_")):
        yield from _groups(row, name.removeprefix("by_").split(","), row[name])
    yield from _costs(row["cost"])
    yield from _paired(row.get("paired"))
    if "against_paper" in row:
        yield from _against_paper(row)


def rate(row: Row, name: str) -> str:
    """Return count, rate and interval of a kind of outcome."""
    if not row["episodes"]:
        return "–"
    low, high = row[f"{name}_low"], row[f"{name}_high"]
    return (
        f"{row[name]:>3} of {row['episodes']:<3} {row[f'{name}_rate']:>6.1%}"
        f"  [{low:.1%}, {high:.1%}]"
    )


def fault_counts(row: Row, kind: str) -> str:
    """Return how often each finer kind of a failure was seen, the most frequent first."""
    counts = sorted(row["faults"].get(kind, {}).items(), key=lambda item: -item[1])
    return ", ".join(f"{fault.replace('-', ' ')} {count}" for fault, count in counts if count)


def _heading(row: Row) -> str:
    spec, runs = row["spec"], row["runs"]
    said = [f"{spec['rules']} rules"] if "rules" in spec else []
    said += [f"{spec['max_steps']} steps"] if "max_steps" in spec else []
    said += [f"code {spec['code']}"] if spec.get("code") else []
    said += [f"run {runs[0]}"] if len(runs) == 1 else [f"{len(runs)} runs together"]
    where = "" if spec.get("world") == "embedded" else f"{_where(row)}, "
    return f"{row['actor']}  ·  {where}{', '.join(said)}"


def _where(row: Row) -> str:
    """Name a world that is not the usual one, and how far its results can be trusted."""
    world = str(row["spec"].get("world", "several worlds"))
    return world + (f" ({row['verification']})" if row["verification"] else "")


def _groups(row: Row, columns: list[str], groups: list[Row]) -> Iterator[str]:
    names = [" ".join(str(group[column]) for column in columns) for group in groups]
    width = max([20, *map(len, names)])
    for name, group in zip(names, groups, strict=True):
        yield f"    {name:<{width}} success {rate(group, 'success')}{said_done(group)}"


def said_done(row: Row) -> str:
    """Return the second reading of success, where it differs from the first."""
    if row["success_said_done"] == row["success"]:
        return ""
    return f" ({row['success_said_done']} said done)"


def _costs(cost: Row | None) -> Iterator[str]:
    if not cost or not cost["decisions"]:
        return
    asked = cost["total_tokens"] > 0
    if asked:
        yield (
            f"  a planning step    {cost['input_tokens']:,.0f} tokens in"
            f" ({cost['evaluated_tokens']:,.0f} evaluated), {cost['output_tokens']:,.1f} out;"
            f" model {cost['model_ms']:,.0f} ms, in all {cost['total_ms']:,.0f} ms"
        )
    for part, words in (("method", "restating"), ("closing", "saying done")):
        if cost[f"{part}_total_tokens"]:
            yield (
                f"    of that {words}, an episode: {cost[f'{part}_input_tokens']:,.0f} in"
                f" ({cost[f'{part}_evaluated_tokens']:,.0f} evaluated),"
                f" {cost[f'{part}_output_tokens']:,.1f} out, {cost[f'{part}_model_ms']:,.0f} ms"
            )
    if cost["dollars"]:
        yield f"    about ${cost['dollars']:.4f} in all"


def _paired(compared: dict[str, Any] | None) -> Iterator[str]:
    if not compared:
        return
    shared = compared["success"]
    if not shared["episodes"]:
        yield f"  no episode is shared with run {compared['run']} ({compared['actor']})"
        return
    yield (
        f"  against run {compared['run']} ({compared['actor']}), on {shared['episodes']} shared"
        f" episodes of {shared['tasks']} seed tasks"
    )
    for reading in ("success", "success_said_done"):
        result = compared[reading]
        yield (
            f"    {TITLES[reading]:<16} {points(result)}; only here {result['only_second']},"
            f" only there {result['only_first']}, p = {result['p']:.3g}"
        )
    yield "    (95 % bootstrap over seed tasks; exact McNemar, as if tasks' levels were apart)"


def points(result: Row) -> str:
    """Return a difference in percentage points with its interval."""
    text = f"{100 * result['difference']:+.1f} points"
    if result["low"] is None:
        return f"{text} (one seed task: no interval)"
    return f"{text} [{100 * result['low']:+.1f}, {100 * result['high']:+.1f}]"


def _against_paper(row: Row) -> Iterator[str]:
    against = row["against_paper"]
    if not against["errors"] and not against["cost"]:
        yield "  the paper prints no numbers for this planner and method"
        return
    yield "  error rates beside the paper's (SayCan), %"
    for each in against["errors"]:
        level, kind = f"{each['reference']}-{each['context']}", each["metric"].replace("_", " ")
        ours = our_words(each)
        yield f"    {level:<18} {kind:<16} {ours:<22} paper: {in_words(each['published'])}"
    if against["cost"]:
        yield (
            "    a planning step of the paper's LLaMA3.1-8B:"
            f" {against['cost']['input_tokens']:,.0f} tokens in,"
            f" {against['cost']['output_tokens']:,.0f} out, {against['cost']['latency_ms']} ms"
        )
