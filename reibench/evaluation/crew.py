"""The crew: shares jobs out among workers, and loses none when a worker dies."""

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from queue import Empty, SimpleQueue
from threading import Thread

from reibench.errors import ReibenchError, WorkerLost
from reibench.evaluation import Job, Played, Worker
from reibench.rollout import Record
from reibench.worlds import Announce

PATIENCE = 60.0
"""Seconds after which it is said that nobody is ready to play."""

Reported = Played | BaseException | None
"""What a hand says: that a job is done, why it stopped, or that it is ready."""


@dataclass(eq=False)
class Hand:
    """One worker, served by a thread of this process, and what it is at."""

    place: int
    worker: Worker
    inbox: "SimpleQueue[Job | None]"
    job: Job | None = None


class Crew:
    """Some workers, of which those that die are replaced.

    A job whose worker dies is given to another once; if that one dies too, it comes back as an
    error. Jobs are handed out and results taken in one thread, that of whoever iterates `work`.
    """

    def __init__(self, hire: Callable[[int], Worker], size: int, announce: Announce) -> None:
        """Plan a crew of `size`; `hire` makes the worker of a place."""
        self._hire = hire
        self._size = size
        self._announce = announce
        self._reports: SimpleQueue[tuple[Hand, Reported]] = SimpleQueue()
        self._hands: list[Hand] = []
        self._ready: list[Hand] = []
        self._deaths = 0
        """Since a job was last finished."""

    def work(self, jobs: Iterable[Job], begin: Callable[[Job], object]) -> Iterator[Played]:
        """Yield each job once it is done; `begin` is told of a job before it is handed out.

        Raises:
            ReibenchError: when model or world cannot be had, or all workers keep dying.
        """
        waiting, retried = deque(jobs), set[tuple[str, str]]()
        try:
            for place in range(min(self._size, len(waiting))):
                self._engage(place)
            while waiting or any(hand.job for hand in self._hands):
                while waiting and self._ready:
                    begin(waiting[0])
                    self._hand_out(waiting.popleft())
                hand, report = self._next_report()
                if isinstance(report, BaseException):
                    lost = self._leave(hand, report)
                    if lost and lost.key not in retried:
                        retried.add(lost.key)
                        waiting.appendleft(lost)
                    elif lost:
                        yield Played(lost, _lost_record(lost, report), 0.0)
                    if lost and waiting:
                        self._engage(hand.place)
                    continue
                hand.job = None
                self._ready.append(hand)
                if report:
                    self._deaths = 0
                    yield report
        finally:
            for hand in self._hands:
                hand.inbox.put(None)
                hand.worker.close()

    def _engage(self, place: int) -> None:
        hand = Hand(place, self._hire(place), SimpleQueue())
        self._hands.append(hand)
        Thread(target=self._serve, args=(hand,), daemon=True).start()

    def _serve(self, hand: Hand) -> None:
        """Do what one worker is given, in a thread of its own."""
        try:
            hand.worker.open()
            self._reports.put((hand, None))
            for job in iter(hand.inbox.get, None):
                self._reports.put((hand, hand.worker.play(job)))
        except ReibenchError as problem:
            self._reports.put((hand, problem))
        except BaseException as problem:
            self._reports.put((hand, problem))
            raise

    def _hand_out(self, job: Job) -> None:
        hand = self._ready.pop(0)
        hand.job = job
        hand.inbox.put(job)

    def _next_report(self) -> tuple[Hand, Reported]:
        while True:
            try:
                return self._reports.get(timeout=PATIENCE)
            except Empty:
                if not self._ready and not any(hand.job for hand in self._hands):
                    self._announce("No worker is ready yet; waiting for one.")

    def _leave(self, hand: Hand, problem: BaseException) -> Job | None:
        """Let a worker that died go, and return the job it was at; raise anything else."""
        job, hand.job = hand.job, None
        self._hands.remove(hand)
        hand.worker.close()
        if not isinstance(problem, WorkerLost):
            raise problem
        self._deaths += 1
        if self._deaths > 2 * self._size or not (job or self._hands):
            raise WorkerLost(
                f"{self._deaths} workers died without finishing an episode, the last because"
                f" {problem}; is the memory enough for {self._size} at once? Fewer --workers need"
                " less."
            )
        if job is None:
            self._announce(f"A worker could not start: {problem}. Going on with fewer.")
            return None
        self._announce(f"{job.episode.id}: {problem}.")
        return job


def _lost_record(job: Job, problem: BaseException) -> Record:
    return Record(
        id="",
        episode=job.episode,
        actor=job.spec.actor,
        status="error",
        start=None,
        steps=(),
        error=f"WorkerLost: {problem}; so did the one before it",
    )
