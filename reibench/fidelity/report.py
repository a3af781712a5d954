"""The report: every trial restored and played, as one JSON object."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import cache, lru_cache
from multiprocessing import get_context
from pathlib import Path
from typing import Any

from reibench.dataset.alfred import Trial, in_names_of
from reibench.errors import InvalidRoom, ReibenchError
from reibench.fidelity.playing import Rooms, RoomsFrom, play_expert, play_plan, world_with
from reibench.fidelity.restoration import restoration
from reibench.household import Room, load_room
from reibench.household.ithor import read_dump
from reibench.worlds.rules import RULES
from reibench.worlds.setup import prepare

PLAYS = {"expert_plan": play_plan, "expert": play_expert}


@dataclass(frozen=True)
class Outcome:
    """What one trial came to."""

    trial: Trial
    counts: Counter[str]
    renamed: bool
    """Whether the room calls the furniture of its goal or plan otherwise."""
    error: str = ""
    """Why it could not be set up."""
    reasons: Mapping[tuple[str, str], str] = field(default_factory=dict)
    """By rules and who played, why the goal was not reached; empty where it was."""


@dataclass(frozen=True)
class Measuring:
    """What a process needs to measure trials."""

    rooms: Path | None

    def __call__(self, trial: Trial) -> Outcome:
        """Restore and play one trial."""
        rooms = _rooms_in(self.rooms)
        try:
            room = rooms(trial.setup.room)
            fitted = in_names_of(room.objects, trial)
            simulator = RoomsFrom(rooms)
            simulator.load(room.name)
            before = simulator.scene()
            prepare(simulator, fitted.setup)
        except ReibenchError as problem:
            return Outcome(trial, Counter(), False, str(problem))
        counts = restoration(before, simulator.scene(), fitted)
        reasons = dict(_reasons(rooms, fitted)) if trial.goal else {}
        return Outcome(trial, counts, fitted is not trial, "", reasons)


def _reasons(rooms: Rooms, trial: Trial) -> Iterator[tuple[tuple[str, str], str]]:
    for name, rules in RULES.items():
        world = world_with(rooms, rules)
        for who, play in PLAYS.items():
            yield (name, who), play(world, trial).reason


@lru_cache(maxsize=1)
def _rooms_in(folder: Path | None) -> Rooms:
    """Return what finds rooms: the imported ones, or those of a folder of dumps."""
    if folder is None:
        return lru_cache(maxsize=None)(load_room)

    @cache
    def read(name: str) -> Room:
        paths = [folder / f"{name}_physics.json", folder / f"{name}.json"]
        path = next((each for each in paths if each.exists()), None)
        if path is None:
            raise InvalidRoom(f"There is no dump of the room {name} in {folder}.")
        return read_dump(path)

    return read


def fidelity_report(
    trials: Sequence[Trial], rooms: Path | None = None, workers: int = 1
) -> dict[str, Any]:
    """Restore and play every trial, in several processes if asked to.

    Args:
        trials: ALFRED's.
        rooms: a folder of dumps of real rooms; None for the imported ones.
        workers: how many processes share the work.
    """
    measuring = Measuring(rooms)
    # Trials of a room together, so that each process reads few rooms.
    ordered = sorted(trials, key=lambda trial: (trial.setup.room, trial.id))
    if workers > 1:
        # Unlike a multiprocessing pool this one says so when a process of it is lost.
        with ProcessPoolExecutor(workers, mp_context=get_context("spawn")) as pool:
            outcomes = list(pool.map(measuring, ordered, chunksize=16))
    else:
        outcomes = [measuring(trial) for trial in ordered]
    return _summary(outcomes)


def _summary(outcomes: Sequence[Outcome]) -> dict[str, Any]:
    single = [each for each in outcomes if each.trial.goal is not None]
    total: Counter[str] = sum((each.counts for each in outcomes), Counter())
    return {
        "trials": len(outcomes),
        "single_object_trials": len(single),
        "two_object_trials": len(outcomes) - len(single),
        "not_set_up": [_entry(each, each.error) for each in outcomes if each.error],
        "renamed_furniture": [each.trial.id for each in outcomes if each.renamed],
        "poses": _chosen(
            total, "poses exact same_receptacle moved elsewhere lost copies removed".split()
        ),
        "parents": _chosen(total, "parents_told parents_honoured parents_renamed".split()),
        "plan": _chosen(
            total, "objects_named objects_found receptacles_named receptacles_found".split()
        ),
        "starts": _chosen(total, "starts starts_exact".split()),
        "rules": {name: _successes(single, name) for name in RULES},
    }


def _chosen(counts: Counter[str], names: Iterable[str]) -> dict[str, int]:
    return {name: counts[name] for name in names}


def _successes(outcomes: Sequence[Outcome], rules: str) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for who in PLAYS:
        reasons = [(each, each.error or each.reasons[rules, who]) for each in outcomes]
        failures = [_entry(each, reason) for each, reason in reasons if reason]
        share = 1 - len(failures) / len(outcomes) if outcomes else 0.0
        found[f"{who}_success"] = round(share, 4)
        found[f"{who}_failures"] = failures
    return found


def _entry(outcome: Outcome, reason: str) -> dict[str, str]:
    trial = outcome.trial
    kind = f"{trial.task_type} in {trial.setup.room}"
    return {"trial": trial.id, "task": kind, "reason": reason}
