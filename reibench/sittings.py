"""Sittings: a visitor and an episode in progress, acted on by the visitor or watched.

The database is the truth: each step is committed before anything is shown, and whatever is only
in memory (the world) is rebuilt from it by replaying the steps.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from reibench.backends import Backend
from reibench.episode import Episode
from reibench.errors import ReibenchError, StaleStep, unknown
from reibench.planners import Decision
from reibench.pool import Lease, Pool
from reibench.rollout import Record, Rollout
from reibench.run import RunSpec, make_world
from reibench.skill import Skill, parse_skill
from reibench.store import Entry, Origin, Store
from reibench.watching import Sitting, Watching
from reibench.worlds import World
from reibench.worlds.naming import renders, resolve_world
from reibench.worlds.preparing import Preparation

PERSON = "person"
WORLDS_KEPT = 64
"""Worlds kept ready for visitors who may click again; others are rebuilt by replay."""
PROCESSES_KEPT = 4
"""The same for worlds that are a process each."""
IDLE = 600.0
"""Seconds after which a world that nobody uses is given up."""


@dataclass
class _Live:
    """A rollout with the world it happens in."""

    rollout: Rollout
    world: World


class Sittings:
    """All visitors' sittings on one server."""

    def __init__(
        self,
        episodes: Sequence[Episode],
        store: Store,
        open_model: Callable[[str], Backend],
        *,
        spec: RunSpec | None = None,
        origin: Origin = "demo",
        more: Callable[[str], Episode | None] = lambda episode_id: None,
    ) -> None:
        """Serve `episodes`; `spec` says which rules, world and budget everyone plays with.

        `origin` is what their records are kept as; `more` finds episodes that came since, by id.
        """
        self._origin: Origin = origin
        self.episodes: Mapping[str, Episode] = {each.id: each for each in episodes}
        self._more = more
        self._store = store
        self._open_model = open_model
        spec = spec or RunSpec()
        self._spec = replace(spec, world=resolve_world(spec.world))
        self._preparation = Preparation(self._spec.world)
        size = PROCESSES_KEPT if renders(self._spec.world) else WORLDS_KEPT
        self._live: Pool[_Live] = Pool(size, lambda live: live.world.close(), idle=IDLE)
        self._watching = Watching(store, open_model, self._spec)

    # acting oneself

    def open(self, visitor: str, episode_id: str, *, afresh: bool = False) -> Sitting:
        """Begin an episode for this visitor, or go on with the unfinished one."""
        episode = self.episode(episode_id)
        if not afresh:
            for entry in reversed(self._entries(visitor)):
                if entry.episode == episode_id and entry.actor == PERSON:
                    if self._goes_on(entry):
                        return self._show(entry.id, visitor)
                    break
        spec = replace(self._spec, planner=PERSON, method="none", model="").versioned()
        live = self._make(episode, spec)  # first, so that a world that fails leaves no record
        record_id = self._store.begin(
            spec,
            episode,
            actor=PERSON,
            origin=self._origin,
            visitor=visitor,
            start=live.rollout.first_event,
        )
        self._live.lend(record_id, lambda: live)
        return self._show(record_id, visitor)

    def current(self, visitor: str) -> Sitting | None:
        """Return what this visitor did last, so that a reload continues there."""
        entries = [entry for entry in self._entries(visitor) if entry.actor == PERSON]
        return self._show(entries[-1].id, visitor) if entries else None

    def find(self, sitting_id: str, visitor: str) -> Sitting:
        """Return a sitting of this visitor's or the gallery's; raises UnknownName for another's."""
        return self._show(sitting_id, visitor)

    def watched(self, visitor: str, episode_id: str) -> dict[str, Sitting]:
        """Return this visitor's latest finished watch of an episode by each planner, by label."""
        latest = {
            entry.actor: entry.id
            for entry in self._entries(visitor)
            if entry.episode == episode_id and entry.actor != PERSON and entry.status is not None
        }
        return {actor: self._show(record_id, visitor) for actor, record_id in latest.items()}

    def recorded(self, episode_id: str) -> dict[str, Sitting]:
        """Return the gallery's runs of an episode by each planner, by label."""
        entries = self._store.entries("origin = 'gallery' and episode = ?", [episode_id])
        return {entry.actor: self._show(entry.id, "") for entry in entries}

    def step(
        self,
        sitting_id: str,
        visitor: str,
        skill_text: str,
        expected: int,
        seconds: float | None = None,
    ) -> Sitting:
        """Carry out a skill as step number `expected`, and commit it before returning.

        Args:
            sitting_id: from the sitting that is shown.
            visitor: must be whose sitting it is.
            skill_text: e.g. `find an apple`.
            expected: the number the page thinks this step has.
            seconds: from when the page was shown to the click, by the browser's clock.

        Raises:
            UnknownSkill: for text that is no skill.
            StaleStep: when the episode has moved on or is over; nothing is done.
            StoreUnavailable: when the step could not be saved; nothing is done.
        """
        decision = Decision(parse_skill(skill_text))
        entry = self._entry(sitting_id, visitor)
        lease = self._lease(entry)
        with lease.lock:
            rollout = lease.value.rollout
            self._refuse_if_over(entry)
            try:
                step = rollout.step(decision, expected=expected, seconds=seconds)
                self._store.add_step(sitting_id, rollout, step)
            except StaleStep:
                raise
            except ReibenchError:
                self._live.take_back(sitting_id)
                raise
            if rollout.exhausted:
                self._store.finish(sitting_id, rollout, PERSON)
        return self._show(sitting_id, visitor)

    def done(self, sitting_id: str, visitor: str, expected: int) -> Sitting:
        """End the episode; `expected` is the number the next step would have."""

        def say_done(rollout: Rollout) -> None:
            now = len(rollout.steps) + 1
            if expected != now:
                raise StaleStep(f"This tab was behind: the episode is at step {now}.")
            rollout.finish()

        return self._end(sitting_id, visitor, say_done)

    def expire(self, sitting_id: str, visitor: str) -> Sitting:
        """End an episode whose time is up, which is not the visitor saying done."""
        return self._end(sitting_id, visitor, Rollout.expire)

    # watching a planner

    def solution(self, episode_id: str) -> tuple[Skill, ...]:
        """Return the expert's skills for an episode."""
        return self._watching.solution(self.episode(episode_id))

    def watch(
        self, visitor: str, episode_id: str, method: str, model: str, planner: str = "saycan"
    ) -> Iterator[Sitting]:
        """Let a planner act, and yield after each thing that happened; the last has a status."""
        spec = replace(self._spec, planner=planner, method=method, model=model)
        spec.check()
        return self._watching.watch(visitor, self.episode(episode_id), spec.versioned())

    def stop(self, visitor: str) -> None:
        """End this visitor's running watches after the step they are at."""
        self._watching.stop(visitor)

    def prepare(self, model: str) -> None:
        """Begin to load a model that somebody is about to watch."""
        self._watching.prepare(model)

    def model_ready(self, model: str) -> bool:
        """Whether the model is loaded already."""
        return self._watching.model_ready(model)

    def close(self) -> None:
        """Free every world; the database goes on knowing what happened in them."""
        self._live.close()

    # helpers

    def _end(self, sitting_id: str, visitor: str, end: Callable[[Rollout], None]) -> Sitting:
        entry = self._entry(sitting_id, visitor)
        lease = self._lease(entry)
        with lease.lock:
            self._refuse_if_over(entry)
            end(lease.value.rollout)
            self._store.finish(sitting_id, lease.value.rollout, PERSON)
        self._live.take_back(sitting_id)
        return self._show(sitting_id, visitor)

    def _goes_on(self, entry: Entry) -> bool:
        """Whether an episode is unfinished and can be gone on with here."""
        if entry.status is not None or entry.world != self._spec.world:
            return False
        return self._store.has_start(entry.id)  # a server may have been killed before there was one

    def episode(self, episode_id: str) -> Episode:
        """Return an episode; raises UnknownName."""
        found = self.episodes.get(episode_id) or self._more(episode_id)
        if found is None:
            raise unknown("episode", episode_id, self.episodes)
        return found

    def knows(self, episode_id: str) -> bool:
        """Whether there is an episode of that id."""
        return episode_id in self.episodes or self._more(episode_id) is not None

    def _make(self, episode: Episode, spec: RunSpec) -> _Live:
        if spec.world == self._spec.world:
            self._preparation.require()
        world = make_world(spec, frames=renders(spec.world))
        rollout = Rollout(episode, world, max_steps=spec.max_steps)
        try:
            rollout.start()
        except ReibenchError:
            world.close()
            raise
        return _Live(rollout, world)

    def _lease(self, entry: Entry) -> Lease[_Live]:
        def rebuild() -> _Live:
            made = replace(self._spec, world=entry.world, rules=entry.rules)
            live = self._make(self._store.episode_of(entry.id), made)
            for decision, seconds in self._store.skills_done(entry.id):
                live.rollout.step(decision, seconds=seconds)
            return live

        return self._live.lend(entry.id, rebuild)

    def _entries(self, visitor: str) -> list[Entry]:
        return self._store.entries("visitor = ? and origin = ?", [visitor, self._origin])

    def _entry(self, sitting_id: str, visitor: str) -> Entry:
        """Return the record's entry; another visitor's is as unknown as one that never was."""
        found = self._store.entries(
            "id = ? and (visitor = ? or origin = 'gallery')", [sitting_id, visitor]
        )
        if not found:
            raise unknown("sitting", sitting_id, ())
        return found[0]

    def _refuse_if_over(self, entry: Entry) -> None:
        if self._entry(entry.id, entry.visitor or "").status is not None:
            raise StaleStep("This episode is over; start it again to go on acting.")

    def _live_record(self, entry: Entry) -> Record | None:
        """Return an unfinished record from memory, where that is as far as the database is.

        Reading it anew would take longer with every step, and make other objects of every scene.
        """
        live = self._live.peek(entry.id)
        if live is None or live.rollout.said_done or live.rollout.expired:
            return None
        record = live.rollout.record(entry.id, entry.actor)
        return record if len(record.steps) == self._store.steps_done(entry.id) else None

    def _show(self, sitting_id: str, visitor: str) -> Sitting:
        entry = self._entry(sitting_id, visitor)
        over = entry.status is not None
        record = None if over else self._live_record(entry)
        record = record or self._store.record(sitting_id)
        if record.start is None:
            raise RuntimeError(f"record {sitting_id} has no start scene")
        return Sitting(
            id=record.id,
            visitor=visitor,
            episode=record.episode,
            actor=record.actor,
            start=record.start,
            steps=record.steps,
            max_steps=entry.max_steps,
            status=record.status if over else None,
            phase="over" if over else "acting",
            instruction=record.instruction,
            closing=record.closing,
            error=record.error,
            world=entry.world,
            cameras=self._store.frames.cameras(record.id, len(record.steps)),
            recorded=entry.origin == "gallery",
        )
