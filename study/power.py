"""How many people? The analysis of a study, simulated before there is one."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from math import exp, log
from pathlib import Path
from random import Random
from typing import Any

import pandas as pd

from reibench.dialogue import REFERENCES
from reibench.episode import Episode
from reibench.errors import ReibenchError, unknown
from reibench.score import wilson
from reibench.store import Store
from study.analysis import versus
from study.config import Study
from study.designs import Comer, designs

ALPHA = 0.05
RUN = "planner"


@dataclass(frozen=True)
class Expected:
    """What a study is expected to find; shares from 0 to 1, spreads in log odds."""

    person: Mapping[str, float]
    """Success of people by reference level: explicit, mixed, implicit."""
    planner: Mapping[str, bool | float]
    """Outcome of a planner's run by episode id, or its success by reference level."""
    between_people: float = 0.5
    between_tasks: float = 0.5


@dataclass(frozen=True)
class Power:
    """How often the analysis found a difference, at one size of the study."""

    people: int
    trials: int
    simulations: int
    mcnemar: float
    """Share of simulated studies with p < 0.05."""
    interval: float
    """Share of those whose interval of the difference, by task, leaves out 0."""
    low: float
    high: float
    """95 % Wilson interval of `mcnemar`, for so many simulations."""
    difference: float = field(default=0.0)
    """Mean difference found, person less planner."""


def power(
    study: Study,
    expected: Expected,
    sizes: Sequence[int],
    *,
    simulations: int = 200,
    seed: int = 1,
    tell: Callable[[str], object] = lambda line: None,
) -> list[Power]:
    """Simulate the study at each of `sizes` numbers of people, and analyse it as it would be."""
    pool = study.chosen()
    found = []
    for people in sizes:
        outcomes = [
            _one_study(study, pool, expected, people, Random(f"{seed}/{people}/{number}"))
            for number in range(simulations)
        ]
        significant = sum(outcome[0] for outcome in outcomes)
        low, high = wilson(significant, simulations)
        found.append(
            Power(
                people,
                study.trials,
                simulations,
                significant / simulations,
                sum(outcome[1] for outcome in outcomes) / simulations,
                low,
                high,
                sum(outcome[2] for outcome in outcomes) / simulations,
            )
        )
        tell(f"{people} people: power {found[-1].mcnemar:.2f}")
    return found


def _one_study(
    study: Study, pool: Sequence[Episode], expected: Expected, people: int, choose: Random
) -> tuple[bool, bool, float]:
    """Simulate one study; return whether it finds a difference, by either test, and which."""
    of_task = {episode.task.id: choose.gauss(0, expected.between_tasks) for episode in pool}
    design = designs.create(study.design)
    filled: dict[str, int] = {}
    rows = []
    for slot in range(people):
        of_person = choose.gauss(0, expected.between_people)
        for episode in design.assign(pool, study.trials, Comer(slot, filled, choose)):
            filled[episode.id] = filled.get(episode.id, 0) + 1
            chance = expected.person[episode.vagueness.reference]
            solved = _draw(chance, of_person + of_task[episode.task.id], choose)
            rows.append((episode.id, episode.task.id, "success" if solved else "failure"))
    frame = pd.DataFrame(rows, columns=["episode_digest", "task", "status"])
    played = [episode for episode in pool if episode.id in filled]
    run = [
        (RUN, RUN, one.id, "success" if _planner(expected, one, of_task, choose) else "failure")
        for one in played
    ]
    planners = pd.DataFrame(run, columns=["run", "actor", "episode_digest", "status"])
    outcome = versus(frame, planners, RUN)
    apart = outcome.low > 0 or outcome.high < 0
    return outcome.p < ALPHA, apart, outcome.difference


def _planner(
    expected: Expected, episode: Episode, of_task: Mapping[str, float], choose: Random
) -> bool:
    known = expected.planner.get(episode.id)
    if isinstance(known, bool):
        return known
    chance = float(expected.planner[episode.vagueness.reference])
    return _draw(chance, of_task[episode.task.id], choose)


def _draw(chance: float, shift: float, choose: Random) -> bool:
    held = min(max(chance, 1e-6), 1 - 1e-6)
    odds = log(held / (1 - held)) + shift
    return choose.random() < 1 / (1 + exp(-odds))


def outcomes_of(store: Store, run: str) -> dict[str, bool | float]:
    """Return what a planner's run came to by episode; raises ReibenchError if it has no record."""
    rows = store.query(
        "select episode, status from records where run = ? and origin = 'run' and status not null",
        [run],
    )
    if not rows:
        raise ReibenchError(f"The database has no finished record of a run {run!r}.")
    return {row["episode"]: row["status"] == "success" for row in rows}


def by_reference(text: str, what: str) -> dict[str, float]:
    """Read `0.9` or `explicit=0.95,mixed=0.9,implicit=0.8`; raises ReibenchError."""
    parts = [part.partition("=") for part in text.split(",")]
    shares: dict[str, float] = {}
    for name, equals, value in parts:
        try:
            share = float(value if equals else name)
        except ValueError:
            share = -1.0
        if not 0 <= share <= 1:
            raise ReibenchError(f"{what} {text!r} should be a share from 0 to 1, or one a level.")
        if equals and name not in REFERENCES:
            raise unknown("level of reference", name, REFERENCES)
        shares |= {name: share} if equals else dict.fromkeys(REFERENCES, share)
    if missing := set(REFERENCES) - set(shares):
        raise ReibenchError(f"{what} {text!r} says nothing of {min(missing)}.")
    return shares


def table_rows(found: Sequence[Power]) -> list[list[Any]]:
    """Return what the command prints, a row a size."""
    return [
        [
            one.people,
            one.people * one.trials,
            f"{one.mcnemar:.2f} [{one.low:.2f}, {one.high:.2f}]",
            f"{one.interval:.2f}",
            f"{100 * one.difference:+.1f}",
        ]
        for one in found
    ]


def draw_curve(found: Sequence[Power], path: Path) -> None:
    """Draw power against the number of people; the ending of `path` decides the format."""
    from matplotlib.figure import Figure  # heavy

    figure = Figure(figsize=(6, 3.6), layout="constrained")
    axes = figure.subplots()
    people = [one.people for one in found]
    axes.fill_between(
        people, [one.low for one in found], [one.high for one in found], alpha=0.15, color="#2f5bd7"
    )
    axes.plot(people, [one.mcnemar for one in found], marker="o", color="#2f5bd7", label="McNemar")
    axes.plot(
        people,
        [one.interval for one in found],
        marker="s",
        color="#1d2126",
        linestyle="--",
        label="interval by task",
    )
    axes.axhline(0.8, color="#808790", linewidth=0.8)
    axes.set(xlabel="participants", ylabel="power", ylim=(0, 1.02))
    axes.legend(frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    try:
        figure.savefig(path)
    except (OSError, ValueError) as problem:
        raise ReibenchError(f"The curve cannot be drawn to {path}: {problem}.") from None
