"""An analysis as a page: figure, tables with intervals as bars, people beside planners."""

from collections.abc import Mapping, Sequence
from math import isnan
from typing import Any

from reibench.view.markup import element, number, text
from study.researchers.frame import link, page, section, table, tile

Found = Mapping[str, Any]


def results(name: str, title: str, found: Found, picture: str, *, everybody: bool) -> str:
    """Return the page with an analysis and its figure, an SVG document of our own.

    Args:
        name: of the study.
        title: what it is called.
        found: from `analyse`.
        picture: the figure as SVG.
        everybody: whether simulated and rejected people are counted.
    """
    other = "" if everybody else "?everybody=true"
    words = "without simulated people" if everybody else "with simulated and rejected people"
    [overall] = found["overall"]
    head = element(
        "div",
        element("h1", "Analysis"),
        element(
            "p", link(f"/admin/{name}/analysis{other}", words),
            link(f"/admin/{name}/export.zip{other and ''}", "the data"), class_="facts",
        ),
    )  # fmt: skip
    parts = [
        element("div", *_tiles(found, overall), class_="tiles"),
        element("div", picture[picture.index("<svg") :], class_="figure panel"),
        section("Success by level", _rates(found["by_level"], "level")),
        section("Success by task type", _rates(found["by_task_type"], "task_type")),
        *_meant(found["meant"]),
        section("Beside planners, on the same episodes", _planners(found)),
    ]
    above = [("/admin/", "Studies"), (f"/admin/{name}", title)]
    return page("Analysis", above, head, *parts)


def _tiles(found: Found, overall: Found) -> list[str]:
    pace, length, same = (
        found[key] for key in ("seconds_a_step", "steps_per_expert_step", "agreement")
    )
    rate = f"{100 * overall['success_rate']:.0f} %"
    low, high = 100 * overall["success_low"], 100 * overall["success_high"]
    return [
        tile(str(found["people"]), _counted(found)),
        tile(rate, f"success [{low:.0f}, {high:.0f}]"),
        tile(_spread(pace, " s"), f"a step, median{_quartiles(pace)}"),
        tile(_spread(length, " ×"), f"the expert's steps{_quartiles(length)}"),
        tile(f"{same['same']} of {same['pairs']}", "pairs of people agree on an episode")
        if same["pairs"]
        else tile("–", "agreement: no episode was played by two people"),
    ]


def _counted(found: Found) -> str:
    """Say who is counted."""
    words = {"active": "still taking part", "missed a check": "missed an attention check"}
    who = [f"{n} {words.get(state, state)}" for state, n in found["states"].items() if n]
    return f"people ({', '.join(who)}), {found['trials']} finished tasks"


def _spread(spread: Found, unit: str) -> str:
    return f"{spread['median']:.1f}{unit}" if spread["number"] else "–"


def _quartiles(spread: Found) -> str:
    return f" ({spread['low']:.1f} to {spread['high']:.1f})" if spread["number"] else ""


def _rates(rows: Sequence[Found], by: str) -> str:
    cells = [
        [
            text(str(row[by]).replace("_", " ")),
            _interval(row["success_rate"], row["success_low"], row["success_high"]),
            f"{row['success']} of {row['episodes']}",
            f"{100 * row['success_rate']:.0f} % [{100 * row['success_low']:.0f},"
            f" {100 * row['success_high']:.0f}]",
            str(row["object_omission"]),
            str(row["execution_error"]),
        ]
        for row in rows
    ]
    heads = (
        by.replace("_", " "), "", "solved #", "success, 95 % #", "object omission #",
        "execution error #",
    )  # fmt: skip
    return table(heads, cells, f"Success by {by.replace('_', ' ')}")


def _meant(rows: Sequence[Found]) -> list[str]:
    """Return how often the object that was meant was named, where a question asks for it."""
    if not rows:
        return []
    cells = [
        [
            text(row["reference"]),
            _interval(row["right"] / row["asked"], row["low"], row["high"]),
            f"{row['right']} of {row['asked']}",
            f"{100 * row['right'] / row['asked']:.0f} % [{100 * row['low']:.0f},"
            f" {100 * row['high']:.0f}]",
        ]
        for row in rows
    ]
    heads = ("reference", "", "named #", "share, 95 % #")
    return [section("Named the object that was meant", table(heads, cells, "Named what was meant"))]


def _interval(rate: float, low: float, high: float) -> str:
    """Return a rate as a bar with its interval, from 0 to 1."""
    return element(
        "svg",
        element("rect", x=0, y=6, width=200, height=8, rx=3, class_="all"),
        element("rect", x=0, y=6, width=number(200 * rate), height=8, rx=3, class_="part"),
        element("path", d=f"M{number(200 * low)} 10H{number(200 * high)}", class_="span"),
        viewbox="0 0 200 20",
        class_="interval",
        role="img",
        aria_label=f"{100 * rate:.0f} %, from {100 * low:.0f} to {100 * high:.0f}",
    )


def _planners(found: Found) -> str:
    """Return people against each run, paired by episode."""
    rows = [
        _versus(one, fit)
        for one, fit in zip(found["versus"], found["model"], strict=True)
        if one["trials"]
    ]
    if not rows:
        how = "python -m reibench run --episodes … --db the same database"
        words = "No planner's run in this database is on the same episodes. Record one with "
        return element("p", words, element("code", text(how)), class_="note")
    heads = (
        "planner", "tasks #", "people #", "planner's #", "only people : only planner #",
        "McNemar p #", "difference, points [95 %] #", "log odds of a person [95 %] #",
    )  # fmt: skip
    said = element(
        "p",
        "Each finished task of a person beside the planner's outcome on the same episode. McNemar:"
        " exact, two-sided; the interval: bootstrap over seed tasks; log odds: mixed-effects"
        " logistic model with intercepts by person and by seed task.",
        class_="muted small",
    )
    return table(heads, rows, "People beside planners") + said


def _versus(one: Found, fit: Found) -> list[str]:
    within = "" if isnan(one["low"]) else f" [{100 * one['low']:+.0f}, {100 * one['high']:+.0f}]"
    odds = fit.get("note") or (
        f"{fit['person_log_odds']:+.2f} [{fit['low']:+.2f}, {fit['high']:+.2f}]"
    )
    return [
        text(one["planner"]),
        str(one["trials"]),
        f"{100 * one['person']:.0f} %",
        f"{100 * one['other']:.0f} %",
        f"{one['only_person']} : {one['only_other']}",
        f"{one['p']:.3g}",
        text(f"{100 * one['difference']:+.0f}{within}"),
        text(odds),
    ]
