"""What pages outside Gradio share: the document around them, and the bar that leads from one on."""

from collections.abc import Sequence

from reibench.view.icons import sprite
from reibench.view.logo import LOGO
from reibench.view.markup import element, text

LINKS = (
    ("Demo", "/"),
    ("Cases", "/cases"),
    ("Comparison", "/comparison"),
    ("Your own words", "/own"),
)
"""The pages anybody may go to, in the order of the bar; none of them leads to a study."""


def navigation(here: str) -> str:
    """Return the bar; `here` is the address of the page it stands on."""
    tabs = [
        element(
            "a", text(title), class_="tab", href=href, aria_current="page" if href == here else None
        )
        for title, href in LINKS
    ]
    return bar("Pages", element("div", *tabs, class_="tabs"))


def bar(label: str, start: str, end: str = "") -> str:
    """Return the bar of a page: the brand, `start`, and at its end `end` and light or dark."""
    theme = element(
        "button", "◐", type="button", class_="btn sm quiet icon", data_do="theme",
        aria_label="Light or dark", title="Light or dark",
    )  # fmt: skip
    brand = element("a", LOGO, "REI-Bench", class_="brand", href="/")
    grow = element("span", class_="grow")
    return element(
        "header",
        element("nav", brand, start, grow, end, theme, class_="nav", aria_label=label),
        class_="top",
    )


def document(title: str, over: str, body: str, *, head: str, page: str) -> str:
    """Return a whole HTML document.

    Args:
        title: of the window.
        over: the bar.
        body: what stands below it.
        head: styles and scripts, as markup.
        page: what the style sheet calls it.
    """
    inside = element(
        "head",
        element("meta", charset="utf-8"),
        element("meta", name="viewport", content="width=device-width,initial-scale=1"),
        element("title", text(f"{title} · REI-Bench")),
        element("link", rel="icon", href="/web/favicon.svg"),
        head,
    )
    skip = element("a", "To the content", href="#content", class_="skip")
    live = element("div", id="live", class_="sr", aria_live="polite", role="status")
    shown = element("body", skip, sprite(), live, over, body)
    return "<!doctype html>" + element("html", inside, shown, lang="en", data_page=page)


def select(name: str, label: str, options: Sequence[tuple[str, str]], chosen: str) -> str:
    """Return a choice with its label for screen readers; `options` are values and words."""
    return element(
        "select",
        *(
            element("option", text(words), value=value, selected=value == chosen)
            for value, words in options
        ),
        class_="native",
        name=name,
        aria_label=label,
    )
