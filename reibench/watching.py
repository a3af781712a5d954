"""Watching: a planner acts in an episode for a visitor, one committed step after another."""

import logging
import threading
from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import dataclass, replace

from reibench.backends import Backend
from reibench.episode import Episode
from reibench.errors import ReibenchError
from reibench.methods import Instruction
from reibench.planners import Closing
from reibench.rollout import Rollout, Status, Step, drive
from reibench.run import RunSpec, instruct, make_planner, make_world
from reibench.skill import Skill
from reibench.store import Store
from reibench.worlds import Camera, Event
from reibench.worlds.naming import renders

log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Sitting:
    """What the page shows of an episode in progress or just over."""

    id: str
    """The record's id."""
    visitor: str
    episode: Episode
    actor: str
    """`person`, or the planner's label."""
    start: Event
    steps: tuple[Step, ...]
    max_steps: int
    status: Status | None
    """None while in progress."""
    phase: str = "acting"
    """acting · loading model · restating · planning · over · stopped."""
    instruction: Instruction | None = None
    closing: Closing | None = None
    """What led the planner to say done."""
    error: str = ""
    world: str = "embedded"
    cameras: tuple[Camera, ...] = ()
    """Those whose frames are kept for every step."""
    recorded: bool = False
    """Whether it is of the gallery, and nobody's own."""

    @property
    def event(self) -> Event:
        """The latest event."""
        return self.steps[-1].event if self.steps else self.start


class Watching:
    """Planners at work for visitors, and the models they ask, loaded when first needed."""

    def __init__(self, store: Store, open_model: Callable[[str], Backend], spec: RunSpec) -> None:
        self._store = store
        self._open_model = open_model
        self._spec = spec
        self._stops: dict[str, int] = {}
        self._solutions: dict[str, tuple[Skill, ...]] = {}
        self._models: dict[str, Backend] = {}
        self._coming: set[str] = set()
        self._lock = threading.Lock()

    def watch(self, visitor: str, episode: Episode, spec: RunSpec) -> Iterator[Sitting]:
        """Let a planner act, and yield after each thing that happened; the last has a status.

        However it ends, by itself, by `stop`, by an error or because nobody looks any more, the
        record is closed.
        """
        world = make_world(spec, frames=renders(spec.world))
        rollout = Rollout(episode, world, max_steps=spec.max_steps)
        try:
            start = rollout.start()
        except ReibenchError:
            world.close()
            raise
        record_id = self._store.begin(spec, episode, origin="demo", visitor=visitor)
        self._store.started(record_id, start)
        sitting = replace(
            Sitting(record_id, visitor, episode, spec.actor, start, (), spec.max_steps, None),
            world=spec.world,
            cameras=tuple(frame.camera for frame in start.frames),
        )
        error = f"{spec.actor} was left before its end"
        try:
            for phase in self._act(record_id, rollout, spec, self._stops.get(visitor, 0)):
                steps, told = tuple(rollout.steps), rollout.instruction
                sitting = replace(sitting, phase=phase, steps=steps, instruction=told)
                if phase == "stopped":
                    break
                yield sitting
            error = "" if sitting.phase != "stopped" else "stopped by the visitor"
        except ReibenchError as problem:
            error = str(problem)
        finally:
            record = self._store.finish(record_id, rollout, spec.actor, error=error)
            world.close()
        phase = "stopped" if sitting.phase == "stopped" else "over"
        yield replace(
            sitting,
            phase=phase,
            status=record.status,
            error=error,
            steps=record.steps,
            closing=record.closing,
        )

    def _act(self, record_id: str, rollout: Rollout, spec: RunSpec, stops: int) -> Iterator[str]:
        """Load, restate and plan; yield what is going on after each change."""
        episode = rollout.episode
        visitor = self._store.entries("id = ?", [record_id])[0].visitor or ""
        backend = None
        if spec.model:
            if not self.model_ready(spec.model):
                yield "loading model"
            backend = self._model(spec.model)
            yield "restating"
        rollout.instruction = instruct(spec, episode, backend)
        self._store.instructed(record_id, rollout)
        yield "planning"
        for step in drive(rollout, make_planner(spec, episode, backend), rollout.instruction):
            self._store.add_step(record_id, rollout, step)
            if self._stops.get(visitor, 0) != stops:
                yield "stopped"
                return
            yield "planning"

    def stop(self, visitor: str) -> None:
        """End this visitor's running watches after the step they are at."""
        self._stops[visitor] = self._stops.get(visitor, 0) + 1

    def model_ready(self, model: str) -> bool:
        """Whether the model is loaded already."""
        return model in self._models

    def prepare(self, model: str) -> None:
        """Begin to load a model that will be wanted soon, unless it is on its way already."""
        if model and model not in self._models and model not in self._coming:
            self._coming.add(model)
            threading.Thread(target=self._prepare, args=(model,), daemon=True).start()

    def _prepare(self, model: str) -> None:
        try:
            self._model(model)
        except ReibenchError as problem:
            log.info("%s is not loaded ahead: %s", model, problem)  # whoever asks it is told
        finally:
            self._coming.discard(model)

    def solution(self, episode: Episode) -> tuple[Skill, ...]:
        """Return the expert's skills for an episode, those that worked."""
        if episode.id not in self._solutions:
            spec = replace(self._spec, planner="expert", method="none", model="")
            world = make_world(spec)
            rollout = Rollout(episode, world, max_steps=spec.max_steps)
            with closing(world):
                rollout.start()
                told = instruct(spec, episode, None)
                steps = list(drive(rollout, make_planner(spec, episode, None), told))
            self._solutions[episode.id] = tuple(
                step.decision.skill for step in steps if step.event.success
            )
        return self._solutions[episode.id]

    def _model(self, model: str) -> Backend:
        with self._lock:
            if model not in self._models:
                self._models[model] = self._open_model(model)
            return self._models[model]
