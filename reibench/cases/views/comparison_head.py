"""Who is compared, who else could be, and what can be downloaded."""

from collections.abc import Mapping, Sequence
from urllib.parse import urlencode

from reibench.cases.comparing import LEVELS, MOST_RUNS, Contestant, published
from reibench.view.markup import classes, element, text

_FORMS = ("svg", "pdf", "png")


def comparison_head(
    chosen: Sequence[Contestant],
    known: Sequence[Contestant],
    looks: Mapping[str, str],
    *,
    paper: bool,
) -> str:
    """Return the line above a comparison.

    Args:
        chosen: who is compared.
        known: all that could be.
        looks: the class of each one's colour, by run.
        paper: whether the published numbers are marked.
    """
    runs = [one.run for one in chosen]
    others = [one for one in known if one.run not in runs]
    return element(
        "div",
        element("h1", "Comparison"),
        *(_chip(one, runs, looks[one.run], paper=paper) for one in chosen),
        _paper(chosen, paper=paper),
        _more(others, runs, paper=paper),
        element("span", class_="grow"),
        *(_downloads(runs, paper=paper) if runs else ()),
        class_="runs",
    )


def link(runs: Sequence[str], *, paper: bool, path: str = "/comparison") -> str:
    """Return the address of a comparison of these runs."""
    query = urlencode({"runs": ",".join(runs)} | ({} if paper else {"paper": "0"}))
    return f"{path}?{query}"


def _chip(one: Contestant, runs: Sequence[str], look: str, *, paper: bool) -> str:
    """Return one who is compared, with the way to leave it out."""
    less = [run for run in runs if run != one.run]
    off = element(
        "a", "×", href=link(less, paper=paper), aria_label=f"Leave out {one.title}",
        title="Leave out",
    )  # fmt: skip
    name = (element("i", class_=look), text(one.title), element("small", text(one.subtitle)))
    return element("span", *name, off if less else "", class_="run")


def _paper(chosen: Sequence[Contestant], *, paper: bool) -> str:
    """Return the switch of the published numbers; nothing where there are none of anybody."""
    if not any(published(one, *level[::-1]) for one in chosen for level in LEVELS):
        return ""
    shape = element("path", class_="pub", d="M6 1l5 5l-5 5l-5 -5z")
    return element(
        "a",
        element("svg", shape, viewbox="0 0 12 12", aria_hidden="true"),
        "Published" if paper else "Show published",
        element("small", "LLaMA3.1-8B, from the paper"),
        href=link([one.run for one in chosen], paper=not paper),
        class_=classes("run", off=not paper),
    )


def _more(others: Sequence[Contestant], runs: Sequence[str], *, paper: bool) -> str:
    if not others:
        return ""
    if len(runs) >= MOST_RUNS:
        words = f"{MOST_RUNS} at most: leave one out to add another"
        return element("span", words, class_="muted xs")
    items = [
        (
            f"{element('b', text(one.title))} {element('small', text(one.subtitle))}",
            link([*runs, one.run], paper=paper),
        )
        for one in others
    ]
    return _menu("Add runs", items)


def _downloads(runs: Sequence[str], *, paper: bool) -> tuple[str, str]:
    figures = [
        (form.upper(), link(runs, paper=paper, path=f"/comparison/figure.{form}"))
        for form in _FORMS
    ]
    data = link(runs, paper=paper, path="/comparison/data.csv")
    return _menu("Figure ▾", figures, "right"), element("a", "Data", href=data, class_="btn sm")


def _menu(words: str, items: Sequence[tuple[str, str]], *names: str) -> str:
    """Return a menu of links: their markup and where they lead."""
    listed = [element("li", element("a", content, href=href)) for content, href in items]
    return element(
        "details",
        element("summary", words, class_="btn sm"),
        element("ul", *listed, class_="menu"),
        class_=classes("export", *names),
    )
