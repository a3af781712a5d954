"""Models and settings: what is on the shelf, how to get it, and which prompting method is used."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from reibench.methods import methods
from reibench.models import Shelved, in_megabytes
from reibench.view.choices import (
    adapter_of,
    offered_methods,
    offered_planners,
    planner_summary,
    planner_title,
)
from reibench.view.markup import classes, element, number, text


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
        method: which prompting method is used.
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
        *_planners(planner),
        element("h3", "Prompting method", class_="label"),
        *_methods(method, _lacking(models, chosen)),
        element("h3", "Keys", class_="label"),
        _keys(),
        class_="sheet",
        role="dialog",
        aria_label="Models and settings",
        id="shelf",
    )


def _planners(chosen: str) -> list[str]:
    """Return the planners that ask a model with what they do, as one choice."""
    return [
        _choice("planner", name, planner_title(name), planner_summary(name), chosen)
        for name in offered_planners()
    ]


def _lacking(models: Sequence[Shelved], chosen: str) -> frozenset[str]:
    """Return the methods that ask an adapter which the chosen model of the shelf has not."""
    names = [entry.model for entry in models if entry.model.name == chosen]
    wanted = {name: adapter_of(name) for name in offered_methods()}
    return frozenset(
        name
        for name, adapter in wanted.items()
        if adapter and names and adapter not in names[0].adapters
    )


def _methods(chosen: str, lacking: frozenset[str]) -> list[str]:
    """Return all prompting methods with what they do, as one choice."""
    known = {name: methods.create(name) for name in offered_methods()}
    return [
        _choice("method", name, method.title, method.summary, chosen, off=name in lacking)
        for name, method in known.items()
    ]


def _choice(
    what: str, name: str, title: str, summary: str, chosen: str, *, off: bool = False
) -> str:
    summary += "; the chosen model was not" if off else ""
    words = element("span", element("b", text(title)), element("small", text(summary)))
    radio = _radio(what, name, checked=name == chosen, disabled=off)
    return element("label", radio, words, class_=classes("option", absent=off))


def _keys() -> str:
    box = element("input", type="checkbox", data_do="keys", id="single-keys", checked=True)
    words = element("b", "Single-letter keys") + element("small", "E, N, P, / and V")
    return element("label", box, element("span", words), class_="option")


def _radio(what: str, value: str, *, checked: bool, disabled: bool = False) -> str:
    return element(
        "input", type="radio", name=what, value=value, checked=checked, disabled=disabled,
        data_choose=what,
    )  # fmt: skip


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
