"""The comparison page: any runs, people and the published numbers beside each other."""

from collections.abc import Mapping, Sequence
from typing import Any
from urllib.parse import urlencode

from reibench.cases.comparing import LEVELS, PEOPLE, Comparison, Contestant, Difference, published
from reibench.cases.filtering import CaseFilter
from reibench.cases.views.case_list import address
from reibench.cases.views.charts import Bar, Point, Series, bars, differences
from reibench.dialogue import REFERENCES
from reibench.skill import in_words
from reibench.view.markup import classes, element, text

LOOKS = ("c-plain", "c-tocc", "c-third", "c-fourth", "c-fifth", "c-sixth")
ERRORS = (("success", "k-s"), ("object_omission", "k-o"), ("execution_error", "k-e"),
          ("breakdown", "k-b"))  # fmt: skip


def look_of(chosen: Sequence[Contestant]) -> dict[str, str]:
    """Return the look of each contestant: people ink, the first plain run grey, others in turn."""
    free = list(LOOKS)
    looks = {}
    for one in chosen:
        if one.run == PEOPLE:
            looks[one.run] = "c-person"
        elif one.method == "none" and "c-plain" in free:
            looks[one.run] = free.pop(free.index("c-plain"))
        elif one.method != "none" and "c-tocc" in free:
            looks[one.run] = free.pop(free.index("c-tocc"))
        else:
            looks[one.run] = free.pop(next(n for n, f in enumerate(free) if f not in LOOKS[:2]))
    return looks


def comparison_view(shown: Comparison, known: Sequence[Contestant], *, paper: bool) -> str:
    """Return the page.

    Args:
        shown: the contestants that are compared.
        known: all that could be.
        paper: whether the published numbers are marked.
    """
    looks = look_of(shown.chosen)
    head = _head(shown.chosen, known, looks, paper=paper)
    if not shown.chosen:
        words = (
            "No run is recorded yet that could be compared. The command run plays episodes; what is"
            " in the gallery was chosen and does not count."
        )
        return head + element("section", element("p", text(words), class_="empty"), class_="panel")
    small = element(
        "div", _errors(shown), _differences(shown, looks), _confusions(shown), class_="three"
    )
    return head + _levels(shown, looks, paper=paper) + small


def link(runs: Sequence[str], *, paper: bool, path: str = "/comparison") -> str:
    """Return the address of a comparison of these runs."""
    query = urlencode({"runs": ",".join(runs)} | ({} if paper else {"paper": "0"}))
    return f"{path}?{query}"


def _head(
    chosen: Sequence[Contestant],
    known: Sequence[Contestant],
    looks: Mapping[str, str],
    *,
    paper: bool,
) -> str:
    runs = [one.run for one in chosen]
    chips = []
    for one in chosen:
        less = [run for run in runs if run != one.run]
        off = element(
            "a", "×", href=link(less, paper=paper), aria_label=f"Leave out {one.title}",
            title="Leave out",
        )  # fmt: skip
        chips.append(
            element(
                "span",
                element("i", class_=looks[one.run]),
                text(one.title),
                element("small", text(one.subtitle)),
                off if less else "",
                class_="run",
            )
        )
    shape = element("path", class_="pub", d="M6 1l5 5l-5 5l-5 -5z")
    diamond = element("svg", shape, viewbox="0 0 12 12", aria_hidden="true")
    if any(published(one, *level[::-1]) for one in chosen for level in LEVELS):
        words = "Published" if paper else "Show published"
        chips.append(
            element(
                "a",
                diamond,
                words,
                element("small", "LLaMA3.1-8B, from the paper"),
                href=link(runs, paper=not paper),
                class_=classes("run", off=not paper),
            )
        )
    others = [one for one in known if one.run not in runs]
    more = ""
    if others:
        options = [
            element(
                "li",
                element(
                    "a",
                    element("b", text(one.title)),
                    " ",
                    element("small", text(one.subtitle)),
                    href=link([*runs, one.run], paper=paper),
                ),
            )
            for one in others
        ]
        more = element(
            "details", element("summary", "Add runs", class_="btn sm"),
            element("ul", *options, class_="menu"), class_="export",
        )  # fmt: skip
    files = element(
        "details", element("summary", "Figure ▾", class_="btn sm"),
        element("ul", *(
            element("li", element("a", form.upper(),
                                  href=link(runs, paper=paper, path=f"/comparison/figure.{form}")))
            for form in ("svg", "pdf", "png")
        ), class_="menu"), class_="export right",
    )  # fmt: skip
    data = element(
        "a", "Data", href=link(runs, paper=paper, path="/comparison/data.csv"), class_="btn sm"
    )
    return element(
        "div", element("h1", "Comparison"), *chips, more, element("span", class_="grow"),
        files if runs else "", data if runs else "", class_="runs",
    )  # fmt: skip


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
                published=published(one, reference, context) if paper else (),
            )
        series.append(Series(one.title, looks[one.run], found))
    head = element(
        "header", element("h2", "Success by level, %"),
        element("span", "95 % Wilson intervals. Choose a bar to open its cases.",
                class_="xs muted"),
    )  # fmt: skip
    return element(
        "section", head, element("div", bars(series), class_="bd"), class_="panel levels"
    )


def _errors(shown: Comparison) -> str:
    groups = []
    for reference in REFERENCES:
        rows = [element("span", reference, class_="lv2")]
        for one in shown.chosen:
            found = shown.by_reference.get((one.run, reference))
            rows.append(element("span", text(one.short), class_="who2", title=one.title))
            rows.append(_stack(one, reference, found))
        groups.append(element("div", *rows, class_="sg", style=f"--n:{len(shown.chosen)}"))
    key = element(
        "div",
        *(element("span", element("i", class_=look), name.replace("_", " "))
          for name, look in ERRORS[:3]),
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
    words = (
        "95 % intervals from drawing whole seed tasks anew 10,000 times."
        if groups
        else "Two runs on the same episodes are needed."
    )
    inside = (differences(groups) if groups else "") + element("p", words, class_="xs muted")
    return element("section", head, element("div", inside, class_="bd"), class_="panel")


def _told(one: Contestant, base: Contestant, each: Difference) -> Point:
    words = (
        f"{one.title} against {base.title}, {each.reference}: {100 * each.difference:+.0f} points"
        f" ({100 * each.low:+.0f} to {100 * each.high:+.0f}) on {each.pairs} episodes; it alone"
        f" {each.only_second}, the other alone {each.only_first}, p = {each.p:.2g}"
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
    return in_words(object_type) if object_type else "none"


def _cell(of: Contestant, meant: str, taken: str, count: int, most: int) -> str:
    if not count:
        return element("span", class_="mc")
    right = meant == taken
    share = round(8 + 40 * count / most)
    words = (
        f"{_name(meant)} taken for {_name(taken)}: {count}"
        if not right
        else (f"{_name(meant)} taken: {count}")
    )
    return element(
        "a", str(count), href=_cases(of, taken=f"{meant}/{taken}"),
        class_=classes("mc", right=right, wrong=not right), style=f"--p:{share}%", title=words,
        aria_label=words,
    )  # fmt: skip
