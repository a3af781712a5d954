"""Workers that are processes of this machine, each with its own model and world."""

import contextlib
import logging
import os
import signal
from collections.abc import Iterator
from multiprocessing import get_context
from multiprocessing.connection import Connection
from queue import SimpleQueue
from threading import Thread
from typing import Any

from reibench.errors import ReibenchError, WorkerLost
from reibench.evaluation import Job, Played
from reibench.evaluation.player import Player
from reibench.run import RunSpec

GRACE = 10.0
"""Seconds an idle process has to free its model before it is killed."""


class ProcessWorker:
    """Has a process of its own play, and notices when it dies."""

    def __init__(
        self, spec: RunSpec, *, frames: bool, processors: frozenset[int] = frozenset()
    ) -> None:
        """Prepare a worker, limited to these processors where the system can do that."""
        self._spec = spec
        self._frames = frames
        self._processors = processors
        self._pipe: Any = None
        self._process: Any = None
        self._idle = False

    def open(self) -> None:
        """Start the process, and wait until it has opened model and world."""
        context = get_context("spawn")
        self._pipe, theirs = context.Pipe()
        self._process = context.Process(
            target=serve,
            args=(theirs, self._spec, self._frames, self._processors),
            daemon=True,
        )
        with _without_interrupts():
            self._process.start()
        theirs.close()
        self._received()
        self._idle = True

    def play(self, job: Job) -> Played:
        """Have one job played."""
        self._idle = False
        try:
            self._pipe.send(job)
            played: Played = self._received()
        except (BrokenPipeError, ConnectionResetError):
            raise self._lost() from None
        self._idle = True
        return played

    def close(self) -> None:
        """End the process: an idle one may free its model, any other is killed."""
        if self._process is None or self._process.pid is None:
            return
        if self._idle:
            with contextlib.suppress(OSError):
                self._pipe.send(None)
            self._process.join(GRACE)
        self._process.kill()
        self._process.join()

    def _received(self) -> Any:
        try:
            answer = self._pipe.recv()
        except (EOFError, ConnectionResetError):
            raise self._lost() from None
        if isinstance(answer, ReibenchError):
            raise answer
        return answer

    def _lost(self) -> WorkerLost:
        self._process.join(GRACE)
        return WorkerLost(f"the process that played died (exit code {self._process.exitcode})")


def serve(
    pipe: "Connection[Any, Any]", spec: RunSpec, frames: bool, processors: frozenset[int]
) -> None:
    """Play the jobs that come through `pipe`, until None comes or the other end is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the other end's business
    logging.basicConfig(level=logging.ERROR, format="%(message)s")  # as the command line has it
    if processors and hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, processors)
    jobs: SimpleQueue[Job | None] = SimpleQueue()
    Thread(target=_listen, args=(pipe, jobs), daemon=True).start()
    try:
        player = Player(spec, frames=frames)
    except ReibenchError as problem:
        pipe.send(problem)
        return
    pipe.send(None)
    for job in iter(jobs.get, None):
        pipe.send(player.play(job))
    player.close()


def _listen(pipe: "Connection[Any, Any]", jobs: "SimpleQueue[Job | None]") -> None:
    """Pass jobs on; a process that nobody listens to any more ends at once, whatever it does."""
    while True:
        try:
            jobs.put(pipe.recv())
        except (EOFError, OSError):
            os._exit(1)


@contextlib.contextmanager
def _without_interrupts() -> Iterator[None]:
    """Let a process start deaf to Ctrl-C, which the terminal sends to every process."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def shares_of_processors(workers: int) -> list[frozenset[int]]:
    """Deal this machine's processors out to local models; each gets all where there are too few.

    llama.cpp takes as many threads as it may use processors, and threads that wait for each other
    on shared processors are many times slower.
    """
    usable = getattr(os, "sched_getaffinity", None)
    processors = sorted(usable(0)) if usable else []
    if len(processors) < workers:
        return [frozenset()] * workers
    return [frozenset(processors[place::workers]) for place in range(workers)]
