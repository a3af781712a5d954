"""What the case pages call runs, outcomes and failures."""

from typing import Any

from reibench.cases.case import Run
from reibench.report.labels import model_label
from reibench.view.choices import method_title, planner_title

KIND_WORDS = {
    "helps": "method helps",
    "hurts": "method hurts",
    "same": "no change",
    "people": "people only",
    "single": "one run",
}
"""What the kinds of case are called; which method it is, the case says."""
KIND_TITLES = {
    "helps": "Failed without the method, carried out with it",
    "hurts": "Carried out without the method, failed with it",
    "same": "Both came out alike",
    "people": "A person carried it out, no planner here did",
    "single": "There is nothing to compare with",
}


def run_title(run: Run) -> str:
    """Return what a run is called, e.g. `SayCan + TOCC`."""
    if run.lane == "person":
        return f"Person {run.id[:4].upper()}"
    planner = planner_title(run.planner)
    return planner if run.method == "none" else f"{planner} + {method_title(run.method)}"


def run_subtitle(run: Run) -> str:
    """Return what else is to be known of a run: its model; rules where they are not the usual."""
    parts = [model_label(run.model)] if run.model else []
    if run.rules != "strict":
        parts.append(f"{run.rules} rules")
    if run.lane == "person":
        parts.append("in a study" if run.origin == "study" else "on the demo page")
    return ", ".join(parts)


def level_words(level: str) -> str:
    """Return `implicit · noised` for `implicit-noised`."""
    return " · ".join(level.split("-"))


def outcome_words(status: str, error_kind: str | None) -> str:
    """Return how a run came out, in a word or two."""
    if status == "success":
        return "Success"
    if status == "error":
        return "Broke off"
    return str(error_kind or "failed").replace("-", " ").capitalize()


def present(value: Any) -> str:
    """Return a cell of a table as text; what is missing there is empty."""
    return value if isinstance(value, str) else ""
