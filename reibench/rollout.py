"""The episode engine: the one place where a decision meets a world.

A planner is driven by `drive`; a person's clicks call `Rollout.step`. Both leave the same record.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from time import perf_counter
from typing import Literal

from reibench.episode import Episode
from reibench.errors import StaleStep
from reibench.methods import Instruction
from reibench.planners import Closing, Decision, Planner
from reibench.worlds import Event, World

MAX_STEPS = 30
"""Step budget of the published configuration, for people and planners alike."""

Status = Literal["success", "failure", "truncated", "error"]


@dataclass(frozen=True)
class Step:
    """One decision and what came of it."""

    number: int
    """From 1."""
    decision: Decision
    event: Event
    seconds: float
    """Thinking time: from the last event to this decision, for people and planners alike."""


@dataclass(frozen=True)
class Record:
    """A finished episode; every episode begun leaves exactly one."""

    id: str
    episode: Episode
    actor: str
    """`person`, or planner, method and model."""
    status: Status
    """success: the goal holds at the end. failure: it doesn't, and the actor said done.
    truncated: it doesn't, and the budget of steps or the time is spent. error: something broke."""
    start: Event | None
    """The event of the reset; None if the room could not be set up."""
    steps: tuple[Step, ...]
    said_done: bool = False
    """Whether the actor ended the episode itself."""
    expired: bool = False
    """Whether it ended because the time was up, with steps left."""
    instruction: Instruction | None = None
    """What the planner was told; None for people, who read the dialogue."""
    closing: Closing | None = None
    """What led to saying done, where a planner that asks a model said it."""
    error: str = ""


class Rollout:
    """One episode in progress."""

    def __init__(self, episode: Episode, world: World, *, max_steps: int = MAX_STEPS) -> None:
        self.episode = episode
        self.skills = world.skills
        self.max_steps = max_steps
        self.steps: list[Step] = []
        self.said_done = False
        self.expired = False
        self.instruction: Instruction | None = None
        self.closing: Closing | None = None
        self.first_event: Event | None = None
        self._world = world
        self._clock = perf_counter()

    def start(self) -> Event:
        """Set the scene and start the clock."""
        self.first_event = self._world.reset(self.episode.task)
        self._clock = perf_counter()
        return self.first_event

    @property
    def last_event(self) -> Event:
        """The latest event; the reset's before the first step."""
        if self.steps:
            return self.steps[-1].event
        if self.first_event is None:
            raise RuntimeError("the rollout has not been started; call start first")
        return self.first_event

    def step(
        self, decision: Decision, *, expected: int | None = None, seconds: float | None = None
    ) -> Step:
        """Carry out `decision` and note what came of it.

        Args:
            decision: the skill, and what led to it.
            expected: the number this step should get; a stale or doubled click has another.
            seconds: thinking time where it is known better than by this clock (replay, browser).

        Raises:
            StaleStep: when `expected` is not the next number, or the episode is over.
        """
        number = len(self.steps) + 1
        if expected is not None and expected != number:
            raise StaleStep(f"The episode is at step {number}, but step {expected} was asked for.")
        if self.over:
            raise StaleStep(f"The episode is over after {len(self.steps)} steps.")
        thought = perf_counter() - self._clock if seconds is None else seconds
        event = self._world.step(decision.skill)
        self._clock = perf_counter()
        # to a tenth of a millisecond, as the database keeps it
        self.steps.append(Step(number, decision, event, round(thought, 4)))
        return self.steps[-1]

    def finish(self, closing: Closing | None = None) -> None:
        """Note that the actor said done, and what led to it."""
        self.said_done = True
        self.closing = closing

    def expire(self) -> None:
        """Note that the time there was is spent, which says nothing of what the actor thought."""
        self.expired = True

    @property
    def exhausted(self) -> bool:
        """Whether the step budget is spent."""
        return len(self.steps) >= self.max_steps

    @property
    def over(self) -> bool:
        """Whether no further step may follow."""
        return self.said_done or self.exhausted or self.expired

    @property
    def status(self) -> Status:
        """How the episode would be recorded if it ended now."""
        if self.first_event and self.last_event.solved:
            return "success"
        spent = self.exhausted or self.expired
        return "truncated" if spent and not self.said_done else "failure"

    def record(self, record_id: str, actor: str, *, error: str = "") -> Record:
        """Close the episode, which was `actor`'s to solve."""
        return Record(
            id=record_id,
            episode=self.episode,
            actor=actor,
            status="error" if error else self.status,
            start=self.first_event,
            steps=tuple(self.steps),
            said_done=self.said_done,
            expired=self.expired,
            instruction=self.instruction,
            closing=self.closing,
            error=error,
        )


def drive(rollout: Rollout, planner: Planner, instruction: Instruction) -> Iterator[Step]:
    """Let `planner` act until it returns or the step budget is spent."""
    rollout.instruction = instruction
    plan = planner.plan(instruction, rollout.last_event, rollout.skills)
    try:
        decision = next(plan)
        while True:
            step = rollout.step(decision)
            yield step
            if rollout.exhausted:
                plan.close()
                return
            decision = plan.send(step.event)
    except StopIteration as end:
        rollout.finish(end.value)
