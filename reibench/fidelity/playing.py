"""Playing a trial: its own plan, or our expert, in the embedded world."""

from collections.abc import Callable, Generator
from dataclasses import dataclass, replace
from typing import TypeAlias

from reibench.dataset.alfred import PlanInSkills, Trial, task_of
from reibench.errors import ReibenchError
from reibench.household import Room
from reibench.methods import Instruction
from reibench.planners.expert import Expert
from reibench.rollout import MAX_STEPS
from reibench.skill import SKILLS, Skill
from reibench.worlds import Event, World
from reibench.worlds.embedded import EmbeddedSimulator
from reibench.worlds.rules import Rules, say_precisely
from reibench.worlds.thor import ThorWorld

Rooms: TypeAlias = Callable[[str], Room]
"""Finds a room by its name."""
Moves: TypeAlias = Generator[Skill, Event, None]


class RoomsFrom(EmbeddedSimulator):
    """The embedded simulator over rooms that need not be imported."""

    def __init__(self, rooms: Rooms) -> None:
        super().__init__()
        self._rooms = rooms

    def room_called(self, name: str) -> Room:
        """Return the room of that name."""
        return self._rooms(name)


@dataclass(frozen=True)
class Played:
    """How one play went."""

    steps: tuple[tuple[Skill, str], ...]
    """Each skill with why it was refused, or nothing."""
    reason: str
    """Why the goal was not reached; empty if it was."""


def world_with(rooms: Rooms, rules: Rules) -> World:
    """Make a world that gives every refusal's precise reason; neither plan nor expert reads it."""
    return ThorWorld(RoomsFrom(rooms), replace(rules, say=say_precisely))


def play_plan(world: World, trial: Trial) -> Played:
    """Carry out the trial's own plan."""
    return _play(world, trial, PlanInSkills(trial.plan).moves)


def play_expert(world: World, trial: Trial) -> Played:
    """Let our expert solve the trial."""

    def moves(start: Event) -> Moves:
        goal = task_of(trial, 0).goal
        plan = Expert(goal).plan(Instruction(text="", original=""), start, SKILLS)
        decision = next(plan, None)
        while decision is not None:
            event = yield decision.skill
            try:
                decision = plan.send(event)
            except StopIteration:
                return

    return _play(world, trial, moves)


def _play(world: World, trial: Trial, actor: Callable[[Event], Moves]) -> Played:
    steps: list[tuple[Skill, str]] = []
    try:
        event = world.reset(task_of(trial, 0))
        moves = actor(event)
        skill = next(moves, None)
        while skill is not None and len(steps) < MAX_STEPS:
            event = world.step(skill)
            steps.append((skill, event.message))
            try:
                skill = moves.send(event)
            except StopIteration:
                skill = None
    except ReibenchError as problem:
        return Played(tuple(steps), str(problem))
    if event.solved:
        return Played(tuple(steps), "")
    return Played(tuple(steps), _reason(steps, event, out_of_steps=skill is not None))


def _reason(steps: list[tuple[Skill, str]], event: Event, *, out_of_steps: bool) -> str:
    """Say what went wrong first, and what is missing in the end."""
    missing = "; ".join(each.text for each in event.goals if not each.holds)
    refused = next((f"{skill.text}: {why}" for skill, why in steps if why), "")
    if out_of_steps:
        refused = f"more than {MAX_STEPS} steps" + (f"; {refused}" if refused else "")
    return f"{refused or 'everything was carried out'} (not so: {missing})"
