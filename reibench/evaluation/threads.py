"""Workers that are threads of this process, sharing a model that takes many calls at once."""

from reibench.backends import Backend
from reibench.evaluation import Job, Played
from reibench.evaluation.player import Player
from reibench.run import RunSpec


class ThreadWorker:
    """Plays in the thread that asks, with a world of its own."""

    def __init__(self, spec: RunSpec, backend: Backend, *, frames: bool) -> None:
        self._spec = spec
        self._backend = backend
        self._frames = frames
        self._player: Player | None = None
        self._playing = False

    def open(self) -> None:
        """Make the world."""
        self._player = Player(self._spec, frames=self._frames, backend=self._backend)

    def play(self, job: Job) -> Played:
        """Play one job to its end."""
        if self._player is None:
            raise RuntimeError("a worker plays only once it is open")
        self._playing = True
        played = self._player.play(job)
        self._playing = False
        return played

    def close(self) -> None:
        """Free the world; one that is played in goes with the process, which is about to end."""
        if self._player and not self._playing:
            self._player.close()
