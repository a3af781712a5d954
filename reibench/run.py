"""Runs: a named choice of parts, played over episodes."""

import hashlib
import json
import logging
from collections.abc import Callable, Iterable, Iterator
from dataclasses import asdict, dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

from reibench.backends import Backend, backends, check_adapter
from reibench.episode import Episode
from reibench.errors import StoreUnavailable
from reibench.methods import Instruction, methods
from reibench.models.presets import full_name
from reibench.planners import Planner, planners
from reibench.rollout import MAX_STEPS, Record, Rollout, Step, drive
from reibench.version import code_version
from reibench.worlds import Announce, Event, World, silently, worlds
from reibench.worlds.naming import create_world, resolve_world
from reibench.worlds.rules import rules_called

if TYPE_CHECKING:
    from reibench.store import Store

log = logging.getLogger(__name__)


@dataclass(frozen=True)
class RunSpec:
    """Everything that decides a run's outcome; stored with each of its records."""

    planner: str = "saycan"
    method: str = "none"
    model: str = ""
    """`llama-cpp:NAME` and the like; empty for planners that ask no model."""
    world: str = "embedded"
    """`ai2thor:stand-in`, `ai2thor:PATH` and so on once resolved; see `versioned`."""
    rules: str = "strict"
    max_steps: int = MAX_STEPS
    seed: int = 0
    """Added to every episode's own seed, which decides where the robot starts."""
    code: str = ""
    """Digest of the code that decides the run, when it was made; see `versioned`."""

    @property
    def id(self) -> str:
        """Twelve hex digits; the same for the same spec."""
        text = json.dumps(asdict(self), sort_keys=True)
        return hashlib.sha256(text.encode()).hexdigest()[:12]

    @property
    def actor(self) -> str:
        """The label of this planner in records and tables."""
        if not self.model:
            return self.planner
        return f"{self.planner}+{self.method}/{self.model}"

    def versioned(self) -> "RunSpec":
        """Return this spec with full names of model and world, and the code that plays it now."""
        parts = [planners.get(self.planner).__module__] if self.planner in planners.names() else []
        model = full_name(self.model)
        if model:
            backend = model.partition(":")[0]
            parts += [methods.get(self.method).__module__, backends.get(backend).__module__]
        kind = self.world.partition(":")[0]
        code = code_version("reibench.rollout", worlds.get(kind).__module__, *parts)
        return replace(self, code=code, model=model, world=resolve_world(self.world))

    def check(self) -> None:
        """Refuse unknown names before anything is loaded; raises UnknownName."""
        planners.get(self.planner)
        methods.get(self.method)
        resolve_world(self.world)
        rules_called(self.rules)


def check_method(spec: RunSpec, backend: Backend) -> None:
    """Refuse a model that cannot do what the method asks of it; raises ModelUnavailable."""
    check_adapter(getattr(methods.get(spec.method), "adapter", ""), backend)


def needs_model(planner: str) -> bool:
    """Whether a planner asks a language model."""
    return not getattr(planners.get(planner), "reads_goal", False)


def make_world(spec: RunSpec, *, frames: bool = False, announce: Announce = silently) -> World:
    """Make the world a run is played in, which renders `frames` if it can."""
    rules = rules_called(spec.rules)
    return create_world(spec.world, rules, frames=frames, announce=announce)


def make_planner(spec: RunSpec, episode: Episode, backend: Backend | None) -> Planner:
    """Make the planner; only one that reads goals is told the goal."""
    if needs_model(spec.planner):
        return planners.create(spec.planner, backend=backend)
    return planners.create(spec.planner, goal=episode.task.goal)


def instruct(spec: RunSpec, episode: Episode, backend: Backend | None) -> Instruction:
    """Let the method restate the episode's instruction, or not."""
    if backend is None:
        said = episode.dialogue.instruction.text
        return Instruction(text=said, original=said)
    return methods.create(spec.method).instruct(episode.dialogue, backend)


def play(spec: RunSpec, rollout: Rollout, backend: Backend | None) -> Iterator[Step]:
    """Play one started episode, step by step."""
    rollout.instruction = instruct(spec, rollout.episode, backend)
    planner = make_planner(spec, rollout.episode, backend)
    yield from drive(rollout, planner, rollout.instruction)


def seeded(spec: RunSpec, episode: Episode) -> Episode:
    """Return the episode as this run plays it: its seed decides where the robot starts.

    Episodes that say themselves where the robot starts, as ALFRED's trials do, are as they were.
    """
    if not spec.seed or episode.task.setup.start:
        return episode
    setup = replace(episode.task.setup, seed=episode.task.setup.seed + spec.seed)
    return replace(episode, task=replace(episode.task, setup=setup))


def attempt(
    spec: RunSpec,
    rollout: Rollout,
    backend: Backend | None,
    started: Callable[[Event], object],
    stepped: Callable[[Step], object],
) -> str:
    """Play one episode to its end, whatever breaks, and return what broke, or nothing.

    `started` and `stepped` are told what happened as soon as it has.
    """
    try:
        started(rollout.start())
        for step in play(spec, rollout, backend):
            stepped(step)
    except StoreUnavailable:
        raise
    except Exception as problem:
        # A lost episode would flatter the success rate: it is recorded as an error.
        log.warning("%s broke: %s", rollout.episode.id, problem, exc_info=True)
        return f"{type(problem).__name__}: {problem}"
    return ""


def evaluate(
    spec: RunSpec,
    episodes: Iterable[Episode],
    backend: Backend | None,
    world: World,
    store: "Store",
    *,
    retry: bool = False,
) -> Iterator[Record]:
    """Play `episodes` in turn; each begun leaves one record in `store`, even if it breaks.

    Episodes this spec has finished already are not repeated, but for those that broke if `retry`;
    one that was cut short is played again from its start, under the same record.
    """
    finished = store.finished(spec, but_errors=retry)
    for chosen in episodes:
        if chosen.id in finished:
            continue
        episode = seeded(spec, chosen)
        record_id = store.begin(spec, episode)
        rollout = Rollout(episode, world, max_steps=spec.max_steps)
        error = attempt(
            spec,
            rollout,
            backend,
            partial(store.started, record_id),
            partial(store.add_step, record_id, rollout),
        )
        yield store.finish(record_id, rollout, spec.actor, error=error)
