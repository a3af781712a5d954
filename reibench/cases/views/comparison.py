"""The comparison page: any runs, people and the published numbers beside each other."""

from collections.abc import Mapping, Sequence
from math import isnan
from typing import Any

from reibench.cases.comparing import (
    LEVELS,
    OTHERS,
    PEOPLE,
    Comparison,
    Contestant,
    Difference,
    published,
)
from reibench.cases.filtering import CaseFilter
from reibench.cases.views.case_list import address
from reibench.cases.views.charts import Bar, Point, Series, bars, differences
from reibench.cases.views.comparison_head import comparison_head
from reibench.dialogue import REFERENCES
from reibench.published import PLANNER
from reibench.skill import in_words
from reibench.view.markup import classes, element, text

LOOKS = ("c-plain", "c-tocc", "c-third", "c-fourth", "c-fifth", "c-sixth")
ERRORS = (("success", "k-s"), ("object_omission", "k-o"), ("execution_error", "k-e"),
          ("breakdown", "k-b"))  # fmt: skip


def look_of(chosen: Sequence[Contestant]) -> dict[str, str]:
    """Return each one's look: people ink, the first plain run grey, the first TOCC blue."""
    free = list(LOOKS)
    looks = {}
    for one in chosen:
        if one.run == PEOPLE:
            looks[one.run] = "c-person"
        elif one.method == "none" and "c-plain" in free:
            looks[one.run] = free.pop(free.index("c-plain"))
        elif one.method.startswith("tocc") and "c-tocc" in free:
            looks[one.run] = free.pop(free.index("c-tocc"))
        else:
            looks[one.run] = free.pop(
                next((n for n, f in enumerate(free) if f not in LOOKS[:2]), 0)
            )
    return looks


def comparison_view(shown: Comparison, known: Sequence[Contestant], *, paper: bool) -> str:
    """Return the page.

    Args:
        shown: the contestants that are compared.
        known: all that could be.
        paper: whether the published numbers are marked.
    """
    looks = look_of(shown.chosen)
    head = comparison_head(shown.chosen, known, looks, paper=paper)
    if not shown.chosen:
        return head + _paper_alone()
    small = element(
        "div", _errors(shown), _differences(shown, looks), _confusions(shown), class_="three"
    )
    return head + _levels(shown, looks, paper=paper) + small


def _cases(one: Contestant, **wanted: str) -> str:
    """Return the address of the cases of a contestant."""
    if one.run == PEOPLE:
        return address(CaseFilter(planner="person", **wanted))
    method = {} if one.method == "none" else {"method": one.method}
    return address(CaseFilter(planner=one.planner, model=one.model, **method, **wanted))


def _levels(shown: Comparison, looks: Mapping[str, str], *, paper: bool) -> str:
    series = []
    for one in shown.chosen:
        found: dict[tuple[str, str], Bar] = {}
        for context, reference in LEVELS:
            row = shown.by_level.get((one.run, context, reference))
            if row is None or not row["episodes"]:
                continue
            found[context, reference] = Bar(
                rate=100 * row["success_rate"],
                low=100 * row["success_low"],
                high=100 * row["success_high"],
                episodes=int(row["episodes"]),
                href=_cases(one, level=f"{reference}-{context}"),
            )
        series.append(Series(one.title, looks[one.run], found, _published(one) if paper else {}))
    head = element(
        "header", element("h2", "Success by level, %"),
        element("span", "95 % Wilson intervals. Choose a bar to open its cases.",
                class_="xs muted"),
    )  # fmt: skip
    return element(
        "section", head, element("div", bars(series), class_="bd"), class_="panel levels"
    )


def _published(one: Contestant) -> dict[tuple[str, str], tuple[float, ...]]:
    return {level: published(one, level[1], level[0]) for level in LEVELS}


def _paper_alone() -> str:
    """Return what there is before any run: the paper's numbers, and how to get one's own."""
    both = [Contestant("", PLANNER, method, "", "", 0) for method in ("none", "tocc")]
    series = [Series(one.title, "", {}, _published(one)) for one in both]
    head = element(
        "header", element("h2", "Success by level, %"),
        element("span", "Published: SayCan (left) and SayCan + TOCC (right), LLaMA3.1-8B, from the"
                " paper.", class_="xs muted"),
    )  # fmt: skip
    words = (
        "No run is recorded yet that could be set beside them. To play some, with the default"
        " model, which needs nothing to be fetched:"
    )
    command = "python -m reibench run --episodes pilot-54 --method none,tocc-taught"
    told = element(
        "div", element("p", text(words)), element("code", command),
        element("p", "What is in the gallery was chosen to show what happens, and does not count:"
                " it is among the ", element("a", "cases", href="/cases"), "."),
        class_="empty",
    )  # fmt: skip
    drawn = element("div", bars(series), class_="bd")
    levels = element("section", head, drawn, class_="panel levels")
    return levels + element("section", told, class_="panel")


def _errors(shown: Comparison) -> str:
    groups = []
    for reference in REFERENCES:
        rows = [element("span", reference, class_="lv2")]
        for one in shown.chosen:
            found = shown.by_reference.get((one.run, reference))
            rows.append(element("span", text(one.short), class_="who2", title=one.title))
            rows.append(_stack(one, reference, found))
        groups.append(element("div", *rows, class_="sg", style=f"--n:{len(shown.chosen)}"))
    broke = any(row["breakdown"] for row in shown.by_reference.values())
    key = element(
        "div",
        *(element("span", element("i", class_=look), name.replace("_", " "))
          for name, look in ERRORS if name != "breakdown" or broke),
        class_="key",
    )  # fmt: skip
    head = element(
        "header",
        element("h2", "Error kinds, %"),
        element("span", "all contexts", class_="xs muted"),
    )
    return element("section", head, element("div", *groups, key, class_="bd"), class_="panel")


def _stack(one: Contestant, reference: str, row: Mapping[Any, Any] | None) -> str:
    if row is None or not row["episodes"]:
        return element("div", "–", class_="stk none")
    levels = ",".join(f"{reference}-{context}" for context in ("standard", "noised", "short"))
    parts = []
    for name, look in ERRORS:
        share = 100 * row[f"{name}_rate"]
        if not row[name]:
            continue
        words = f"{one.title}, {reference}: {name.replace('_', ' ')} {share:.0f} % ({row[name]})"
        wanted = {"level": levels} | (
            {} if name == "success" else {"error": name.replace("_", "-")}
        )
        parts.append(
            element(
                "a",
                f"{share:.0f}" if share >= 8 else "",
                href=_cases(one, **wanted),
                class_=look,
                style=f"flex:{share:.1f}",
                title=words,
                aria_label=words,
            )
        )
    return element("div", *parts, class_="stk")


def _differences(shown: Comparison, looks: Mapping[str, str]) -> str:
    base = next(
        (one for one in shown.chosen if one.method == "none" and one.run != PEOPLE), shown.chosen[0]
    )
    groups = []
    for one in shown.chosen:
        if one.run == base.run:
            continue
        points = [_told(one, base, each) for each in shown.differences(base.run, one.run)]
        if points:
            groups.append((f"{one.short} − {base.short}", looks[one.run], points))
    head = element(
        "header",
        element("h2", "Paired differences"),
        element("span", "points, same episodes", class_="xs muted"),
    )
    words = "Two runs on the same episodes are needed."
    if groups:
        words = "95 % intervals from drawing whole seed tasks anew 10,000 times."
        if any(isnan(point.low) for _, _, points in groups for point in points):
            words += " There is none where both did episodes of one seed task only."
    inside = (differences(groups) if groups else "") + element("p", words, class_="xs muted")
    return element("section", head, element("div", inside, class_="bd"), class_="panel")


def _told(one: Contestant, base: Contestant, each: Difference) -> Point:
    between = f"{100 * each.low:+.0f} to {100 * each.high:+.0f}"
    words = (
        f"{one.title} against {base.title}, {each.reference}: {100 * each.difference:+.0f} points"
        f" ({'no interval: only one seed task' if isnan(each.low) else between}) on {each.pairs}"
        f" episode{'' if each.pairs == 1 else 's'}; it alone {each.only_second}, the other alone"
        f" {each.only_first}, p = {each.p:.2g}"
    )
    return Point(each.reference, 100 * each.difference, 100 * each.low, 100 * each.high, words)


def _confusions(shown: Comparison) -> str:
    of = next(
        (one for one in shown.chosen if one.method == "none" and one.run != PEOPLE), shown.chosen[0]
    )
    rows, columns, counts = shown.confusions(of.run)
    most = max(counts.values(), default=1)
    cells = [
        element("span"),
        *(element("span", text(_name(c)), class_="mh", title=_name(c)) for c in columns),
    ]
    for meant in rows:
        cells.append(element("span", text(_name(meant)), class_="mv"))
        cells += [_cell(of, meant, taken, counts.get((meant, taken), 0), most) for taken in columns]
    grid = element("div", *cells, class_="mx", style=f"--n:{len(columns)}")
    told = f"{of.title}. “none”: nothing was taken. Choose a cell to open its cases."
    head = element(
        "header",
        element("h2", "What confuses what"),
        element("span", "meant ↓ taken →", class_="xs muted"),
    )
    body = element(
        "div", grid if rows else "", element("p", text(told), class_="xs muted"), class_="bd"
    )
    return element("section", head, body, class_="panel")


def _name(object_type: str) -> str:
    if object_type == OTHERS:
        return "others"
    return in_words(object_type) if object_type else "none"


def _cell(of: Contestant, meant: str, taken: str, count: int, most: int) -> str:
    if not count:
        return element("span", class_="mc")
    if taken == OTHERS:
        words = f"{_name(meant)} taken for something else: {count}"
        return element("span", str(count), class_="mc wrong", style="--p:10%", title=words)
    right = meant == taken
    share = round(8 + 40 * count / most)
    words = (
        f"{_name(meant)} taken for {_name(taken)}: {count}"
        if not right
        else (f"{_name(meant)} taken: {count}")
    )
    return element(
        "a", str(count), href=_cases(of, taken=f"{meant}/{taken}/{of.lane}"),
        class_=classes("mc", right=right, wrong=not right), style=f"--p:{share}%", title=words,
        aria_label=words,
    )  # fmt: skip
