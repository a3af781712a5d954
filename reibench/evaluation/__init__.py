"""Evaluation: episodes of many runs, shared out among workers, with one writer of the records."""

from dataclasses import dataclass
from typing import Protocol

from reibench.episode import Episode
from reibench.rollout import Record
from reibench.run import RunSpec


@dataclass(frozen=True)
class Job:
    """One episode of one run, to be played by whoever is free."""

    spec: RunSpec
    episode: Episode
    """As this run plays it; see `run.seeded`."""

    @property
    def key(self) -> tuple[str, str]:
        """What tells jobs apart: the run's id and the episode's."""
        return self.spec.id, self.episode.id


@dataclass(frozen=True)
class Played:
    """A job done: its record, not yet in any database."""

    job: Job
    record: Record
    """Its id is the writer's to give."""
    seconds: float
    """From start to end, opening the model not counted."""


class Worker(Protocol):
    """Plays jobs of one model, one at a time; `open` and `play` are called from one thread."""

    def open(self) -> None:
        """Open the model and the world; raises ReibenchError if they cannot be had, WorkerLost."""
        ...

    def play(self, job: Job) -> Played:
        """Play one job to its end, whatever breaks in it; raises WorkerLost if this worker dies."""
        ...

    def close(self) -> None:
        """Free everything, at once and from any thread, also in the middle of a job."""
        ...
