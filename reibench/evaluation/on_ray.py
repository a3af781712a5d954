"""Workers on the machines of a Ray cluster: one actor each, which only plays and keeps nothing.

Ray is an optional extra; its usage reports are switched off, and its logs stay with it.
"""

import contextlib
import logging
import os
import socket
from collections.abc import Callable
from typing import Any

from reibench.errors import ReibenchError, WorkerLost
from reibench.evaluation import Job, Played, Worker
from reibench.evaluation.player import Player
from reibench.run import RunSpec

LOCAL = "local"
"""Instead of an address: start Ray on this machine, and end it afterwards."""


class RayCluster:
    """A connection to a cluster; a process has at most one."""

    def __init__(self, address: str, workers: int = 0) -> None:
        """Connect.

        Args:
            address: `HOST:PORT`, `auto` for the cluster this machine belongs to, or `local`.
            workers: how many actors; 0 for one a node that opens a model, and else one a processor.

        Raises:
            ReibenchError: when Ray is not installed, or there is no such cluster.
        """
        os.environ["RAY_USAGE_STATS_ENABLED"] = "0"
        os.environ.setdefault("RAY_ACCEL_ENV_VAR_OVERRIDE_ON_ZERO", "0")
        try:
            import ray
        except ImportError:
            raise ReibenchError(
                "--ray needs Ray, which is not installed: pip install -r requirements-ray.txt."
            ) from None
        _check_reachable(address)
        settings: dict[str, Any] = {"logging_level": logging.ERROR, "log_to_driver": False}
        if address == LOCAL:
            settings |= {"include_dashboard": False, "num_cpus": workers or None}
        try:
            ray.init(address=address, **settings)
        except (ConnectionError, RuntimeError, ValueError) as problem:
            said = " ".join(str(problem).split())
            raise ReibenchError(
                f"No Ray cluster can be used at {address!r}: {said} It should be HOST:PORT of"
                " a head node (`ray start --head` says it), auto, or local."
            ) from None
        self._workers = workers
        self._ray: Any = ray

    def close(self) -> None:
        """Disconnect; actors still there end."""
        self._ray.shutdown()

    def size(self, spec: RunSpec) -> int:
        """Return how many workers to have for a model."""
        processors = self._processors()
        return self._workers or (len(processors) if spec.model else sum(processors)) or 1

    def hire(self, spec: RunSpec, *, frames: bool) -> Callable[[int], Worker]:
        """Return what makes the workers for a model."""
        share = 1
        if spec.model and not self._workers:
            share = min(self._processors(), default=1)
        gpus = 1 if spec.model and "GPU" in self._ray.cluster_resources() else 0

        def one(place: int) -> Worker:
            needs = {"num_cpus": share, "num_gpus": gpus, "scheduling_strategy": "SPREAD"}
            return RayWorker(self._ray, spec, frames=frames, needs=needs)

        return one

    def _processors(self) -> list[int]:
        """Return the processors of each node that has any to give."""
        counts = [int(n["Resources"].get("CPU", 0)) for n in self._ray.nodes() if n["Alive"]]
        return [count for count in counts if count]


def _check_reachable(address: str) -> None:
    """Refuse an address where nothing answers: Ray itself would try again for minutes."""
    host, _, port = address.removeprefix("ray://").rpartition(":")
    if not host or not port.isdecimal():
        return
    try:
        socket.create_connection((host, int(port)), timeout=5).close()
    except OSError as problem:
        raise ReibenchError(
            f"No Ray cluster answers at {address!r} ({problem}); it should be HOST:PORT of a head"
            " node, as `ray start --head` says it, auto, or local."
        ) from None


class RayWorker:
    """Has an actor somewhere in the cluster play, and notices when it or its node dies."""

    def __init__(self, ray: Any, spec: RunSpec, *, frames: bool, needs: dict[str, Any]) -> None:
        self._ray = ray
        self._spec = spec
        self._frames = frames
        self._actor = ray.remote(**needs)(Seat).remote()
        self._node = ""

    def open(self) -> None:
        """Wait until the cluster has room and the actor has opened model and world."""
        self._node = self._asked(self._actor.node.remote())
        self._asked(self._actor.open.remote(self._spec, self._frames))

    def play(self, job: Job) -> Played:
        """Have one job played."""
        played: Played = self._asked(self._actor.play.remote(job))
        return played

    def close(self) -> None:
        """End the actor, whatever it does."""
        with contextlib.suppress(self._ray.exceptions.RayError):
            self._ray.kill(self._actor)

    def _asked(self, reference: Any) -> Any:
        try:
            answer = self._ray.get(reference)
        except self._ray.exceptions.RayTaskError:
            raise  # our own mistake
        except self._ray.exceptions.RayError as problem:
            if self._node:
                what = f"the actor on node {self._node} is gone ({type(problem).__name__})"
            else:
                what = f"an actor cannot start: {' '.join(str(problem).split())}"
            raise WorkerLost(what) from None
        if isinstance(answer, ReibenchError):
            raise type(answer)(f"On node {self._node}: {answer}")
        return answer


class Seat:
    """The actor: a player on some node. Mistakes are answers, so that the node can be named."""

    def __init__(self) -> None:
        self._player: Player | None = None

    def node(self) -> str:
        """Return the node's name and address."""
        from ray.util import get_node_ip_address

        address = get_node_ip_address()  # type: ignore[no-untyped-call]
        return f"{socket.gethostname()} ({address})"

    def open(self, spec: RunSpec, frames: bool) -> ReibenchError | None:
        """Open model and world."""
        try:
            _check_code(spec)
            self._player = Player(spec, frames=frames)
        except ReibenchError as problem:
            files = " Files must be on every node, under the same absolute path, or models on its"
            return type(problem)(f"{problem}{files} shelf (`models get`).")
        return None

    def play(self, job: Job) -> Played | ReibenchError:
        """Play one job to its end."""
        if self._player is None:
            raise RuntimeError("an actor plays only once it is open")
        try:
            _check_code(job.spec)
        except ReibenchError as problem:
            return problem
        return self._player.play(job)


def _check_code(spec: RunSpec) -> None:
    """Refuse to play for a run what is other code, or other rooms, than it says."""
    here = spec.versioned().code
    if here != spec.code:
        raise ReibenchError(
            f"The code or the rooms that decide this run are others ({here}) than where it was"
            f" started ({spec.code}); the same checkout and imported rooms must be on every node."
        )
