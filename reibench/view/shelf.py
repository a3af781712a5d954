"""Models and settings: what is on the shelf, what it takes to get it, and how TOCC is done."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from reibench.models import Shelved, in_megabytes
from reibench.planners import planners
from reibench.view.markup import classes, element, number, text
from reibench.view.topbar import METHOD_NAMES, PLANNER_NAMES

PLANNER_NOTES = {
    "saycan": "one choice among the skills after another",
    "dag-plan": "a graph of sub-tasks, written at once and again after a failure",
    "hpe": "sub-goals first, then the steps of each, with a memory bank",
    "llm-p": "a goal in PDDL, which a classical planner solves",
}
METHOD_NOTES = {
    "tocc": "the paper's: the model rewrites the instruction freely",
    "tocc-span": "ours: the model only says what each vague expression stands for",
}


@dataclass(frozen=True)
class Fetching:
    """A model on its way here, or what stopped it."""

    done: int = 0
    total: int = 0
    seconds_left: float | None = None
    error: str = ""


def shelf(
    models: Sequence[Shelved],
    *,
    chosen: str,
    planner: str,
    method: str,
    ready: bool = False,
    fetching: Mapping[str, Fetching] | None = None,
) -> str:
    """Return the sheet with models and settings.

    Args:
        models: what is on the shelf.
        chosen: name of the model in use.
        planner: which planner acts.
        method: which variant of TOCC is used.
        ready: whether the chosen model is loaded.
        fetching: models on their way, by name.
    """
    fetching = fetching or {}
    rows = [
        _model(entry, fetching.get(entry.model.name), chosen=chosen, ready=ready)
        for entry in models
    ]
    close = element(
        "button", "×", type="button", class_="btn icon quiet", data_do="close", aria_label="Close"
    )
    heading = element("header", element("h2", "Models and settings"), close)
    return element(
        "div",
        heading,
        element("h3", "Language model", class_="label"),
        *rows,
        element("h3", "Planner", class_="label"),
        *_variants("planner", planner, _offered(), PLANNER_NOTES),
        element("h3", "How TOCC rewrites", class_="label"),
        *_variants("method", method, METHOD_NAMES, METHOD_NOTES),
        element("h3", "Keys", class_="label"),
        _keys(),
        class_="sheet",
        role="dialog",
        aria_label="Models and settings",
        id="shelf",
    )


def _offered() -> dict[str, str]:
    """Return the planners there are to choose from."""
    return {name: PLANNER_NAMES[name] for name in PLANNER_NAMES if name in planners.names()}


def _variants(
    what: str, chosen: str, names: Mapping[str, str], notes: Mapping[str, str]
) -> list[str]:
    """Return the ways something can be done, as one choice."""
    return [
        element(
            "label",
            _radio(what, name, checked=name == chosen),
            element("span", element("b", text(title)), element("small", text(notes[name]))),
            class_="option",
        )
        for name, title in names.items()
    ]


def _keys() -> str:
    box = element("input", type="checkbox", data_do="keys", id="single-keys", checked=True)
    words = element("b", "Single-letter keys") + element("small", "E, N, P, / and V")
    return element("label", box, element("span", words), class_="option")


def _radio(what: str, value: str, *, checked: bool) -> str:
    return element("input", type="radio", name=what, value=value, checked=checked, data_choose=what)


def _model(entry: Shelved, fetching: Fetching | None, *, chosen: str, ready: bool) -> str:
    model = entry.model
    size = ("" if model.sha256 else "about ") + in_megabytes(model.size)
    title = element(
        "span",
        element("b", text(model.name)),
        element("small", text(f"{size} · {model.licence}")),
        element("small", text(model.note)),
    )
    if entry.present:
        radio = _radio("model", model.name, checked=model.name == chosen)
        words = "ready" if ready and model.name == chosen else "here"
        state = element("span", element("span", class_="dotst good"), words, class_="small state")
    else:
        radio = element("input", type="radio", name="model", disabled=True)
        state = _get(model.name, fetching)
    row = element("label", radio, title, class_=classes("option", absent=not entry.present))
    return element("div", row, state, _progress(fetching), class_="model")


def _get(name: str, fetching: Fetching | None) -> str:
    if fetching and not fetching.error:
        return element("span", element("span", class_="dotst busy"), "coming", class_="small state")
    words = "Try again" if fetching else "Get"
    return element(
        "button", words, type="button", class_="btn sm", data_do="get", data_model=name,
        aria_label=f"Get {name}",
    )  # fmt: skip


def _progress(fetching: Fetching | None) -> str:
    if fetching is None:
        return ""
    if fetching.error:
        return element("p", text(fetching.error), class_="small bad", role="alert")
    share = 100 * fetching.done / fetching.total if fetching.total else 0.0
    words = f"{in_megabytes(fetching.done)} of {in_megabytes(fetching.total)}"
    if fetching.seconds_left is not None:
        minutes = fetching.seconds_left / 60
        words += f", {minutes:.0f} min left" if minutes >= 1 else ", less than a minute left"
    bar = element("span", element("i", style=f"width:{number(share)}%"), class_="bar")
    return element("div", element("span", words, class_="small num"), bar, class_="coming")
