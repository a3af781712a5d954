"""The product of planners, methods and models as runs, and what is left of each to play."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from reibench.episode import Episode
from reibench.run import RunSpec, needs_model
from reibench.store import Store


def product(
    base: RunSpec, planners: Iterable[str], methods: Sequence[str], models: Sequence[str]
) -> list[RunSpec]:
    """Return one run for each planner, method and model, each once, otherwise as `base`.

    A planner that asks no model has one run, whatever methods and models there are.
    """
    specs = [
        replace(base, planner=planner, method=method, model=model)
        if needs_model(planner)
        else replace(base, planner=planner, method="none", model="")
        for planner in planners
        for model in models or ("",)
        for method in methods
    ]
    return list(dict.fromkeys(specs))


@dataclass(frozen=True)
class Share:
    """One run of an evaluation: what it has finished, and what is left."""

    spec: RunSpec
    finished: int
    solved: int
    left: tuple[Episode, ...]


def share_of(spec: RunSpec, episodes: Iterable[Episode], store: Store, *, retry: bool) -> Share:
    """Return what is left of `episodes`; with `retry`, those that broke are left too."""
    outcomes = store.outcomes(spec)
    if retry:
        outcomes = {name: status for name, status in outcomes.items() if status != "error"}
    left = tuple(episode for episode in episodes if episode.id not in outcomes)
    done = [outcomes[episode.id] for episode in episodes if episode.id in outcomes]
    return Share(spec, len(done), done.count("success"), left)


def by_model(shares: Iterable[Share]) -> list[list[Share]]:
    """Group what is left by model, in the order the models are named, for one is open at a time."""
    groups: dict[str, list[Share]] = {}
    for share in shares:
        if share.left:
            groups.setdefault(share.spec.model, []).append(share)
    return list(groups.values())
