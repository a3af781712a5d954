"""What the researchers' pages share: the document, tables, tiles, and how times are said."""

from collections.abc import Sequence
from datetime import UTC, datetime

from reibench.pages.head import head
from reibench.view.markup import classes, element, text
from reibench.view.site import bar, document

Crumb = tuple[str, str]
"""Address and words of a page above this one."""
TONES = {
    "open": "good", "finished": "good", "success": "good", "right": "good",
    "active": "now", "in progress": "now",
    "paused": "warn", "away": "warn", "truncated": "warn", "failed_check": "warn",
    "stopped": "bad", "rejected": "bad", "failure": "bad", "error": "bad", "wrong": "bad",
}  # fmt: skip
WORDS = {"no_consent": "did not agree", "failed_check": "failed the quiz", "withdrawn": "left"}


def page(title: str, crumbs: Sequence[Crumb], *parts: str) -> str:
    """Return a whole page; `crumbs` lead to those above it."""
    way = element("ol", *_crumbs(title, crumbs), class_="crumbs")
    over = bar("Researchers", way, link("/admin/-/cases", "Cases"))
    content = element("main", *parts, class_="admin", id="content")
    return document(title, over, content, head=head("admin", "admin"), page="admin")


def _crumbs(title: str, crumbs: Sequence[Crumb]) -> list[str]:
    above = [element("li", link(href, words)) for href, words in crumbs]
    return [*above, element("li", text(title), aria_current="page")]


def trouble(words: str) -> str:
    """Return a page that says what is wrong."""
    alert = element("p", text(words), role="alert", class_="note")
    return page("That did not work", [("/admin/", "Studies")], alert)


def link(href: str, words: str, class_: str | None = None) -> str:
    """Return a link."""
    return element("a", text(words), href=href, class_=class_)


def table(heads: Sequence[str], rows: Sequence[Sequence[str]], label: str) -> str:
    """Return a table of ready cells; those whose head ends in `#` hold numbers."""
    numeric = [name.endswith("#") for name in heads]
    head_row = element(
        "tr",
        *(
            element("th", text(name.rstrip(" #")), scope="col", class_=classes(n=number))
            for name, number in zip(heads, numeric, strict=True)
        ),
    )
    body = [
        element(
            "tr",
            *(
                element("td", cell, class_=classes(n=number))
                for cell, number in zip(row, numeric, strict=True)
            ),
        )
        for row in rows
    ]
    whole = element("table", element("thead", head_row), element("tbody", *body), aria_label=label)
    return element("div", whole, class_="scrolls panel", tabindex="0")


def section(title: str, *parts: str, beside: str = "") -> str:
    """Return a part of a page with its heading, and what stands at the heading's end."""
    heading = element("div", element("h2", text(title)), beside, class_="heading")
    return element("section", heading, *parts)


def pill(state: str) -> str:
    """Return a state in its colour, in words too."""
    return element("span", text(WORDS.get(state, state)), class_=f"pill {TONES.get(state, '')}")


def tile(number: str, words: str, part: float | None = None) -> str:
    """Return a number with what it counts, and a bar for the part of a whole it is."""
    bar = ""
    if part is not None:
        filled = element("i", style=f"width:{100 * min(part, 1):.0f}%")
        bar = element("span", filled, class_="bar")
    return element("div", element("b", text(number)), element("span", text(words)), bar)


def ago(moment: str) -> str:
    """Return how long ago a moment of the server's clock was, with the moment itself beside it."""
    seconds = (datetime.now(UTC) - datetime.fromisoformat(moment)).total_seconds()
    for length, unit in ((86400, "d"), (3600, "h"), (60, "min")):
        if seconds >= length:
            return _moment(f"{seconds // length:.0f} {unit} ago", moment)
    return _moment("just now", moment)


def _moment(words: str, moment: str) -> str:
    exactly = moment[:19].replace("T", " ") + " UTC"
    return element("time", text(words), datetime=moment, title=exactly)


def lasting(start: str, end: str) -> str:
    """Return the time between two moments."""
    took = (datetime.fromisoformat(end) - datetime.fromisoformat(start)).total_seconds()
    return f"{took / 60:.0f} min" if took >= 90 else f"{took:.0f} s"
