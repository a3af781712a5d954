"""Progress of an evaluation in words: how far, how many solved, how long it will take."""

from collections import Counter, defaultdict
from collections.abc import Sequence
from time import perf_counter

from reibench.evaluation.product import Share
from reibench.rollout import Record
from reibench.run import RunSpec
from reibench.verdict import error_kind
from reibench.worlds.naming import verified

FORECAST_AFTER = 5
"""Episodes after which the whole is foretold."""
WORTH_FORETELLING = 50
"""Episodes: fewer are soon seen."""


class Progress:
    """Counts what is done of several runs, and says it."""

    def __init__(self, shares: Sequence[Share], workers: int = 1) -> None:
        """Start the clock."""
        self._shares = shares
        self._workers = workers
        self._begun = perf_counter()
        self._finished = Counter({share.spec.id: share.finished for share in shares})
        self._solved = Counter({share.spec.id: share.solved for share in shares})
        self._left = Counter({share.spec.id: len(share.left) for share in shares})
        self._seconds: defaultdict[str, list[float]] = defaultdict(list)
        self._one_model = len({share.spec.model for share in shares if share.spec.model}) <= 1
        self.total = sum(self._left.values())
        self.done = 0
        self.broken = 0

    def opening(self) -> list[str]:
        """Return what there is to do: a line for each run, and one for all."""
        lines = []
        for share in self._shares:
            note = f" ({verified(share.spec.world)})" if verified(share.spec.world) else ""
            episodes = share.finished + len(share.left)
            lines.append(
                f"{share.spec.actor}{note}: {episodes} episodes, {share.finished} finished before"
            )
        if len(self._shares) > 1:
            lines.append(f"{len(self._shares)} runs, {self.total} episodes to play")
        return lines

    def note(self, spec: RunSpec, record: Record, seconds: float) -> list[str]:
        """Count one record, and return what there is to say about it."""
        self.done += 1
        self._left[spec.id] -= 1
        self._finished[spec.id] += 1
        self._solved[spec.id] += record.status == "success"
        self.broken += record.status == "error"
        self._seconds[spec.id].append(seconds)
        kind = error_kind(record)
        outcome = record.status if kind is None else f"{record.status}, {kind}"
        who = f"{self._label(spec)}, " if len(self._shares) > 1 else ""
        solved, finished = self._solved[spec.id], self._finished[spec.id]
        gone, remaining = perf_counter() - self._begun, self.remaining()
        lines = [
            f"[{self.done}/{self.total}] {who}{record.episode.id}: {outcome},"
            f" {len(record.steps)} steps; solved {solved} of {finished} ({solved / finished:.1%});"
            f" {spoken(gone)} gone, about {spoken(remaining)} left"
        ]
        if self.done == FORECAST_AFTER and self.total >= WORTH_FORETELLING:
            lines.append(
                f"All {self.total} will take about {spoken(gone + remaining)}, to judge by the"
                f" first {self.done}. Ctrl-C stops; the same command goes on from there."
            )
        return lines

    def remaining(self) -> float:
        """Return the seconds left, from each run's own pace, or all runs' where it has none."""
        every = [one for several in self._seconds.values() for one in several]
        if not every:
            return 0.0
        usual = sum(every) / len(every)
        pace = {run: sum(several) / len(several) for run, several in self._seconds.items()}
        needed = sum(count * pace.get(run, usual) for run, count in self._left.items())
        return needed / max(1, min(self._workers, self.total - self.done))

    def closing(self) -> str:
        """Return what was done."""
        took = spoken(perf_counter() - self._begun)
        text = f"{self.done} of {self.total} episodes recorded in {took}"
        if self.broken:
            text += f"; {self.broken} broke, which --retry-errors plays again"
        return text + "."

    def _label(self, spec: RunSpec) -> str:
        if self._one_model and spec.model:
            return f"{spec.planner}+{spec.method}"
        return spec.actor


def spoken(seconds: float) -> str:
    """Return a duration as one says it, e.g. `1 h 5 min`."""
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60} s"
    return f"{whole // 3600} h {whole % 3600 // 60} min"
