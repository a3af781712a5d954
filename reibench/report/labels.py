"""What runs, models and methods are called in tables and figures."""

from collections.abc import Sequence

import pandas as pd

METHODS = {
    "none": "none",
    "ap": "AP",
    "gated-ap": "Gated AP",
    "cot": "CoT",
    "short-cot": "Short CoT",
    "segmented-cot": "Segmented CoT",
    "icl": "ICL",
    "tocc": "TOCC",
    "tocc-span": "TOCC-span",
    "tocc-taught": "TOCC-taught",
    "no-context": "Context",
}
"""Methods in the order of the paper's tables, under its names."""
PLANNERS = {
    "saycan": "SayCan",
    "dag-plan": "DAG-Plan",
    "hpe": "HPE",
    "llm-p": "LLM+P",
}
TITLES = {
    "success": "success",
    "success_said_done": "… and said done",
    "object_omission": "object omission",
    "execution_error": "execution error",
    "breakdown": "breakdown",
}
DIFFERING = ("world", "rules", "max_steps", "seed", "run")
"""Settings told in a label only where runs differ in them; the last always tells them apart."""


def method_label(method: str) -> str:
    """Return `+ AP` and the like, `- Context`, or `none`."""
    label = METHODS.get(method, method)
    if method == "none":
        return label
    return f"- {label}" if method == "no-context" else f"+ {label}"


def model_label(model: str) -> str:
    """Return a model's name without its backend, its folder and what follows."""
    name = model.partition(":")[2] or model
    return name.partition("?")[0].rpartition("/")[2].removesuffix(".gguf")


def planner_label(planner: str) -> str:
    """Return a planner's name as the paper writes it."""
    return PLANNERS.get(planner, planner)


def place_of(method: str) -> int:
    """Return where a method stands among the rows of a table."""
    return [*METHODS, method].index(method)


def each_run(records: pd.DataFrame) -> pd.DataFrame:
    """Return one row a run, in the order of the records."""
    return records.drop_duplicates("run")


def model_labels(runs: pd.DataFrame, *, planners: bool = False) -> list[str]:
    """Return each run's model, and its planner too where there are several, or if asked."""
    models = [model_label(model) for model in runs["model"]]
    if runs["planner"].nunique() == 1 and not planners:
        return models
    pairs = zip(models, runs["planner"], strict=True)
    return [f"{model} + {planner_label(planner)}" for model, planner in pairs]


def distinct(runs: pd.DataFrame, said: Sequence[str]) -> list[str]:
    """Return each run's words: what is said of it, and where that is not enough, what differs.

    Args:
        runs: one row a run.
        said: what is said of each, in order.
    """
    labels = list(said)
    for setting in DIFFERING:
        values = [str(value) for value in runs[setting]]
        shared = {label for label in labels if labels.count(label) > 1}
        for label in shared:
            places = [place for place, each in enumerate(labels) if each == label]
            if len({values[place] for place in places}) > 1:
                for place in places:
                    labels[place] = f"{label}, {_setting(setting, values[place])}"
    return labels


def _setting(name: str, value: str) -> str:
    words = {"rules": f"{value} rules", "max_steps": f"{value} steps", "world": value}
    return words.get(name, f"{name} {value}")
