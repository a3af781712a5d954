"""Conducting an evaluation: model by model, alone or with a crew; records are kept only here."""

from collections.abc import Generator, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from time import perf_counter

from reibench.backends import Backend, is_concurrent
from reibench.backends.opening import open_backend
from reibench.evaluation import Job, Worker
from reibench.evaluation.crew import Crew
from reibench.evaluation.on_ray import RayCluster
from reibench.evaluation.processes import ProcessWorker, shares_of_processors
from reibench.evaluation.product import Share, by_model
from reibench.evaluation.threads import ThreadWorker
from reibench.rollout import Record
from reibench.run import RunSpec, check_method, evaluate, make_world, seeded
from reibench.store import Store
from reibench.worlds import Announce

Outcome = tuple[RunSpec, Record, float]
"""A run, a record of it that is in the database, and the seconds it took."""


@dataclass(frozen=True)
class Staff:
    """Who plays."""

    workers: int = 0
    """How many at once; 0 for one here, or what a cluster has room for."""
    ray: str = ""
    """The address of a Ray cluster, `local` to start one here, or nothing to do without."""
    frames: bool = False


class Conductor:
    """Plays what is left of some runs, one model after another."""

    def __init__(self, shares: Sequence[Share], staff: Staff) -> None:
        """Open each model once, so that a mistake shows before hours of playing, or the cluster.

        Raises:
            ReibenchError: when a model or the cluster cannot be had.
        """
        self._groups = by_model(shares)
        self._staff = staff
        self._cluster = RayCluster(staff.ray, staff.workers) if staff.ray else None
        self._backend: Backend | None = None
        if not self._cluster:
            for group in reversed(self._groups):
                self._open(group[0].spec.model)
                for share in group:
                    if self._backend:
                        check_method(share.spec, self._backend)

    def perform(self, store: Store, announce: Announce) -> Generator[Outcome, None, None]:
        """Play, and yield each record once it is kept.

        Raises:
            ReibenchError: when a model or world cannot be had, or workers keep dying.
        """
        for place, group in enumerate(self._groups):
            spec = group[0].spec
            if self._cluster:
                hire = self._cluster.hire(spec, frames=self._staff.frames)
                crew = Crew(hire, self._cluster.size(spec), announce)
                yield from _together(group, crew, store)
                continue
            if place:
                self._open(spec.model)
            if self._staff.workers > 1:
                crew = _crew(group, self._backend, self._staff, announce)
                yield from _together(group, crew, store)
            else:
                yield from _alone(group, self._backend, store, self._staff, announce)

    def close(self) -> None:
        """Let go of the model and the cluster."""
        self._open("")
        if self._cluster:
            self._cluster.close()

    def _open(self, model: str) -> None:
        """Have this model open and no other."""
        if self._backend:
            self._backend.close()
        self._backend = open_backend(model) if model else None


def _alone(
    group: Sequence[Share],
    backend: Backend | None,
    store: Store,
    staff: Staff,
    announce: Announce,
) -> Generator[Outcome, None, None]:
    """Play here, one after another, each step kept as it is made."""
    world = make_world(group[0].spec, frames=staff.frames, announce=announce)
    with closing(world):
        for share in group:
            begun = perf_counter()
            for record in evaluate(share.spec, share.left, backend, world, store, retry=True):
                yield share.spec, record, perf_counter() - begun
                begun = perf_counter()


def _crew(
    group: Sequence[Share], backend: Backend | None, staff: Staff, announce: Announce
) -> Crew:
    """Gather threads for a model that takes many calls at once, processes for any other."""
    spec, size = group[0].spec, staff.workers
    if backend and is_concurrent(backend):
        shared = backend
        return Crew(lambda _: ThreadWorker(spec, shared, frames=staff.frames), size, announce)
    processors = [frozenset[int]()] * size
    if backend:
        backend.close()  # each process opens its own
        processors = shares_of_processors(size)
        announce(
            f"{size} processes open {spec.model}, which takes {size} times its memory and is rarely"
            " faster than one on the same processors or GPU."
        )

    def hire(place: int) -> Worker:
        return ProcessWorker(spec, frames=staff.frames, processors=processors[place])

    return Crew(hire, size, announce)


def _together(group: Sequence[Share], crew: Crew, store: Store) -> Generator[Outcome, None, None]:
    """Have a crew play; a record is begun when its job is handed out, and kept when it is done."""
    jobs = [Job(share.spec, seeded(share.spec, one)) for share in group for one in share.left]
    ids: dict[tuple[str, str], str] = {}

    def begin(job: Job) -> None:
        ids[job.key] = store.begin(job.spec, job.episode)

    for played in crew.work(jobs, begin):
        record = replace(played.record, id=ids.pop(played.job.key))
        store.keep(record)
        yield played.job.spec, record, played.seconds
