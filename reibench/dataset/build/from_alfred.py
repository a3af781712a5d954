"""Nine levels around what ALFRED's annotators wrote: the six turns are new, their words stay."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

from reibench.dataset.alfred import Trial
from reibench.dataset.build.annotators import Sorted, WrittenSeed, sort
from reibench.dataset.build.asking import Unfit
from reibench.dataset.build.pipeline import Outcome, check
from reibench.dataset.realise.compose import Called, CannotRealise, Realiser
from reibench.dataset.scripts import Script
from reibench.episode import Task

Unsolved = Callable[[Task], str]


@dataclass(frozen=True)
class TrialOutcome:
    """What became of a trial."""

    trial: Trial
    sorted: tuple[Sorted, ...]
    """What each annotator's words were good for."""
    outcome: Outcome | None
    """What became of the first sound words; None where there are none."""

    @property
    def script(self) -> Script | None:
        """The script made of it, if one was."""
        return self.outcome.script if self.outcome else None

    @property
    def reason(self) -> str:
        """Why it was dropped; of several reasons, that of the first annotator."""
        if self.outcome:
            return f"{self.outcome.step}: {self.outcome.reason}" if not self.script else ""
        return self.sorted[0].reason if self.sorted else "no instruction"


def chosen_seed(trial: Trial, unsolved: Unsolved) -> tuple[tuple[Sorted, ...], Outcome | None]:
    """Return what a trial's instructions are good for, and the first that can be built on.

    An outcome with a reason says that the trial cannot be played here.
    """
    found = tuple(sort(trial))
    first = next((each.written for each in found if each.written), None)
    if first is None:
        return found, None
    if why := unsolved(first.seed.task):
        return found, Outcome(first.seed, None, "room", _in_short(why), why)
    return found, Outcome(first.seed)


def _in_short(why: str) -> str:
    return "it is not there" if why.startswith("No room called") else "the expert does not solve it"


def realise_trials(
    trials: Iterable[Trial], realiser: Realiser, seed: int, unsolved: Unsolved
) -> Iterator[TrialOutcome]:
    """Yield what becomes of each trial with the realiser."""
    for trial in trials:
        found, outcome = chosen_seed(trial, unsolved)
        if outcome and not outcome.reason:
            written = next(each.written for each in found if each.written)
            outcome = _realise(written, realiser, f"{seed}/{trial.id}")
        yield TrialOutcome(trial, found, outcome)


def _realise(written: WrittenSeed, realiser: Realiser, chance: str) -> Outcome:
    seed = written.seed
    called = Called(written.nouns, written.place)
    try:
        script = realiser.realise(seed.task, seed.present, chance, called)
        check(script)
    except CannotRealise as problem:
        return Outcome(seed, None, "realiser", "no parts suit it", str(problem))
    except Unfit as problem:
        return Outcome(seed, None, "filter", problem.reason, problem.complaint)
    return Outcome(seed, script)
