"""The list of cases and its filters."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any
from urllib.parse import urlencode

import pandas as pd

from reibench.cases.filtering import CaseFilter, Found, in_order, taken_parts
from reibench.cases.table import KINDS, LANES, PERSON
from reibench.cases.views.words import KIND_TITLES, KIND_WORDS, level_words, present
from reibench.dialogue import CONTEXTS, REFERENCES
from reibench.episode import TaskType
from reibench.faults import FaultKind
from reibench.report.labels import model_label
from reibench.skill import in_words
from reibench.verdict import ErrorKind
from reibench.view.choices import method_title, planner_title
from reibench.view.icons import mark
from reibench.view.markup import classes, element, text
from reibench.view.site import select
from reibench.view.topbar import room_name

PAGE = 60
"""How many cases are listed at first, and how many more each time."""
MOST_LISTED = 2000
_WHOSE = {"person": "by a person", "plain": "without a method", "told": "with a method"}


def address(wanted: CaseFilter, **more: str) -> str:
    """Return the address of the page with this filter and these other parameters."""
    query = urlencode({**wanted.active, **{key: value for key, value in more.items() if value}})
    return f"/cases?{query}" if query else "/cases"


def runs_of(row: Mapping[Any, Any]) -> str:
    """Return the ids of a case's runs as the address has them."""
    return ",".join(present(row[f"{lane}_id"]) for lane in LANES if present(row[f"{lane}_id"]))


def filters(wanted: CaseFilter, found: Found) -> str:
    """Return the search, the levels, the kinds and the other choices."""
    inputs = [
        element("input", type="hidden", name=name, value=getattr(wanted, name))
        for name in ("level", "kind", "taken")
        if getattr(wanted, name)
    ]
    first = (
        _choice("task_type", "All task types", wanted, found, lambda t: TaskType(t).label),
        _errors(wanted, found),
    )
    return element(
        "form",
        *inputs,
        _search(wanted),
        _levels(wanted, found),
        _kinds(wanted, found),
        element("div", *first, class_="two"),
        _more(wanted, found),
        element("noscript", element("button", "Apply", class_="btn sm")),
        _taken(wanted),
        class_="filt",
        id="filters",
        action="/cases",
        role="search",
    )


def _search(wanted: CaseFilter) -> str:
    field = element(
        "input", type="search", name="words", value=wanted.words, placeholder="Text, object, tag",
        autocomplete="off", id="words", aria_label="Search in what is said, objects and tags",
    )  # fmt: skip
    return element("div", _GLASS, field, element("kbd", "/", class_="hide-m"), class_="search")


def _more(wanted: CaseFilter, found: Found) -> str:
    """Return the filters that are folded while none of them is set."""
    offered: Mapping[str, tuple[str, Any]] = {
        "room": ("Any room", room_name),
        "planner": ("Any actor", _actor),
        "model": ("Any model", model_label),
        "method": ("Any method", method_title),
        "tag": ("Any tag", str),
    }
    choices = [
        _choice(name, nothing, wanted, found, words) for name, (nothing, words) in offered.items()
    ]
    return element(
        "details",
        element("summary", "More filters"),
        element("div", *choices, class_="two"),
        open=any(getattr(wanted, name) for name in offered),
    )


_GLASS = (
    '<svg width="15" height="15" viewBox="0 0 16 16" fill="none" stroke="currentColor"'
    ' stroke-width="1.700" aria-hidden="true"><circle cx="7" cy="7" r="4.700"/>'
    '<path d="M10.600 10.600 14.500 14.500" stroke-linecap="round"/></svg>'
)


def _levels(wanted: CaseFilter, found: Found) -> str:
    counts = found.counts["level"]
    most = max(counts.values(), default=1)
    cells = [element("span"), *(element("span", context, class_="h") for context in CONTEXTS)]
    for reference in REFERENCES:
        cells.append(element("span", reference, class_="v"))
        for context in CONTEXTS:
            level = f"{reference}-{context}"
            count = counts.get(level, 0)
            chosen = level in wanted.levels
            cells.append(
                element(
                    "a",
                    str(count),
                    href=address(replace(wanted, level=wanted.toggled(level))),
                    class_=classes("hc", sel=chosen),
                    style=f"--p:{round(8 + 60 * count / most)}%",
                    aria_label=f"{reference}, {context}: {count} cases",
                    aria_current="true" if chosen else None,
                    data_part="list",
                )
            )
    return element("div", *cells, class_="lv", role="group", aria_label="Level, with counts")


def _kinds(wanted: CaseFilter, found: Found) -> str:
    counts = found.counts["kind"]
    chips = []
    for kind in KINDS:
        chosen = kind == wanted.kind
        if not counts.get(kind) and not chosen:
            continue
        chips.append(
            element(
                "a",
                KIND_WORDS[kind],
                " ",
                element("i", str(counts.get(kind, 0))),
                href=address(replace(wanted, kind="" if chosen else kind)),
                class_=classes("chip", on=chosen),
                title=KIND_TITLES[kind],
                aria_current="true" if chosen else None,
                data_part="list",
            )
        )
    return element("div", *chips, class_="fs")


def _choice(name: str, nothing: str, wanted: CaseFilter, found: Found, words: Any) -> str:
    counts, chosen = found.counts[name], getattr(wanted, name)
    values = in_order(name, counts)
    if chosen and chosen not in values:
        values.append(chosen)
    options = [("", nothing)]
    options += [(each, f"{_safe(words, each)} ({counts.get(each, 0)})") for each in values]
    return select(name, nothing, options, chosen)


def _safe(words: Any, value: str) -> str:
    try:
        return str(words(value))
    except (ValueError, LookupError):  # an address can name anything
        return value


def _actor(name: str) -> str:
    return "People" if name == PERSON else planner_title(name)


def _errors(wanted: CaseFilter, found: Found) -> str:
    counts = found.counts["error"]
    options = [("", "Any failure")]
    options += [
        (str(kind), f"{str(kind).replace('-', ' ')} ({counts.get(str(kind), 0)})")
        for kind in ErrorKind
    ]
    options += [
        (str(fault), f"– {str(fault).replace('-', ' ')} ({counts.get(str(fault), 0)})")
        for fault in FaultKind
    ]
    return select("error", "Kind of failure", options, wanted.error)


def _taken(wanted: CaseFilter) -> str:
    if not wanted.taken:
        return ""
    meant, instead, lane = taken_parts(wanted.taken)
    thing = in_words(meant)
    found = "nothing" if not instead else in_words(instead)
    words = f"{thing} taken" if meant == instead else f"{thing} taken for {found}"
    words += f" {_WHOSE[lane]}" if lane in _WHOSE else ""
    off = element(
        "a", text(words), " ×", class_="chip on", data_part="list",
        href=address(replace(wanted, taken="")),
    )  # fmt: skip
    return element("div", off, class_="fs")


def listing(wanted: CaseFilter, found: Found, current: str, most: int = PAGE) -> str:
    """Return the cases that were found, as links; `current` are the runs of the one shown."""
    number = len(found.cases)
    csv = element("a", "CSV", href=f"/cases/list.csv?{wanted.query()}", class_="btn sm quiet")
    words = f"{number:,} case{'' if number == 1 else 's'}"
    head = element(
        "div",
        element("span", words, class_="muted grow num", id="count"),
        element("span", "person · plain · method", class_="muted", title="Whose marks are whose"),
        csv,
        class_="row small listhead",
    )
    if not number:
        return head + _nothing(wanted, found)
    items = [_item(row, wanted, current) for row in _rows(found.cases, most)]
    if number > most:
        items.append(element("li", _further(wanted, current, most, number), class_="more"))
    return head + element("ul", *items, class_="list", id="list")


def _further(wanted: CaseFilter, current: str, most: int, number: int) -> str:
    """Return the link to more cases than are listed; at the limit, how to get at the others."""
    more = min(most + PAGE, number, MOST_LISTED)
    if more > most:
        return element(
            "a", f"Show {more - most} more", class_="btn sm", data_part="list",
            href=address(wanted, runs=current, most=str(more)),
        )  # fmt: skip
    words = (
        f"The first {most:,} of {number:,} cases are listed. To see others, narrow them down by"
        " the filters above; the CSV has all."
    )
    return element("p", text(words), class_="muted small")


def _rows(cases: pd.DataFrame, most: int) -> Sequence[Mapping[Any, Any]]:
    return cases.head(most).to_dict("records")


def _nothing(wanted: CaseFilter, found: Found) -> str:
    if not wanted.active:
        words = (
            "No run is recorded yet. Watch a planner on the demo page, or: python -m reibench run"
        )
        return element("p", text(words), class_="empty")
    name = found.emptied_by.partition(" ")[0]
    drop = CaseFilter(**{key: value for key, value in wanted.active.items() if key != name})
    said = {"words": "the search", "kind": "the outcome", "taken": "what was taken"}.get(
        name, name.replace("_", " ")
    )
    return element(
        "p",
        text(f"No case is all of this. Without {said} there would be some. "),
        element("a", f"Drop {text(said)}", href=address(drop), class_="btn sm", data_part="list"),
        class_="empty",
    )


def _item(row: Mapping[str, Any], wanted: CaseFilter, current: str) -> str:
    runs = runs_of(row)
    marks = "".join(_mark(present(row[f"{lane}_status"])) for lane in LANES)
    about = [level_words(row["level"]), room_name(row["room"])]
    if present(row["method"]):
        about.append(method_title(row["method"]))
    if present(row["model"]):
        about.append(model_label(row["model"]))
    on = runs == current
    return element(
        "li",
        element(
            "a",
            element(
                "span",
                element("b", text(present(row["title"])), class_="grow"),
                element("span", marks, class_="marks"),
                class_="row",
            ),
            element("span", text(_told(row)), class_="why"),
            element("span", text(" · ".join(about)), class_="meta"),
            href=address(wanted, case=row["episode"], runs=runs),
            class_=classes("case", on=on),
            aria_current="true" if on else None,
            data_part="case",
        ),
    )


def _told(row: Mapping[str, Any]) -> str:
    """Return the sentence about the run that failed, the plain one before the others."""
    lanes = ("told", "plain", "person") if row["kind"] == "hurts" else ("plain", "told", "person")
    for lane in lanes:
        if present(row[f"{lane}_status"]) not in ("", "success"):
            fault = present(row[f"{lane}_fault"]).replace("-", " ")
            return present(row[f"{lane}_reason"]) or fault.capitalize() or "Broke off."
    return "Carried out."


def _mark(status: str) -> str:
    if not status:
        return element("span", "–", class_="mk na", title="no run")
    done = status == "success"
    words = element("span", "carried out" if done else "failed", class_="sr")
    return element(
        "span", mark("cooked" if done else "no"), words, class_=classes("mk", no=not done)
    )
