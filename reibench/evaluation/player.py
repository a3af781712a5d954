"""A player: keeps one model and one world open, and plays one job after another with them."""

from time import perf_counter

from reibench.backends import Backend
from reibench.backends.opening import open_backend
from reibench.evaluation import Job, Played
from reibench.rollout import Rollout
from reibench.run import RunSpec, attempt, make_world


def nothing(happened: object) -> None:
    """Take no note: the whole record is handed over at the end."""


class Player:
    """Plays jobs whose runs share the model, the world and the rules."""

    def __init__(
        self, spec: RunSpec, *, frames: bool = False, backend: Backend | None = None
    ) -> None:
        """Open the world and, unless `backend` is lent, the model; raises ReibenchError."""
        self._own = open_backend(spec.model) if spec.model and backend is None else None
        self._backend = backend or self._own
        self._world = make_world(spec, frames=frames)

    def play(self, job: Job) -> Played:
        """Play one job to its end, whatever breaks."""
        rollout = Rollout(job.episode, self._world, max_steps=job.spec.max_steps)
        begun = perf_counter()
        error = attempt(job.spec, rollout, self._backend, nothing, nothing)
        record = rollout.record("", job.spec.actor, error=error)
        return Played(job, record, perf_counter() - begun)

    def close(self) -> None:
        """Free the world, and the model unless it was lent."""
        self._world.close()
        if self._own:
            self._own.close()
