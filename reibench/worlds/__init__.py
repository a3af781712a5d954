"""Worlds: where skills happen. A world sets up a task's room, carries out skills and reports."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal, Protocol

from reibench.episode import Task
from reibench.goals import Condition, satisfied
from reibench.registry import Registry
from reibench.scene import Scene
from reibench.skill import Skill

Camera = Literal["robot", "above"]
"""Where a frame is taken from: the robot's eye, or over the room, looking down."""
Announce = Callable[[str], object]
"""Told what takes long before a world can be used, e.g. a download."""


@dataclass(frozen=True)
class Frame:
    """What a camera saw."""

    camera: Camera
    png: bytes


@dataclass(frozen=True)
class Event:
    """What the world reports after a skill; the word is AI2-THOR's."""

    success: bool
    message: str
    """What is wrong if it failed; what happened, in a short sentence, or nothing if it worked."""
    scene: Scene
    goals: tuple[Condition, ...]
    frames: tuple[Frame, ...] = field(default=(), compare=False, repr=False)
    """Pictures, where the world renders and was asked for them; they decide nothing."""

    @property
    def solved(self) -> bool:
        """Whether every goal condition holds now."""
        return satisfied(self.goals)


class World(Protocol):
    """A room that carries out skills."""

    @property
    def skills(self) -> tuple[Skill, ...]:
        """Every skill, in a fixed order, the same in every room."""
        ...

    def reset(self, task: Task) -> Event:
        """Set up `task`; raises InvalidEpisode if its room cannot be set up as it says."""
        ...

    def step(self, skill: Skill) -> Event:
        """Carry out `skill`; one that can't be done is an event, not an error."""
        ...

    def close(self) -> None:
        """Free the simulator."""
        ...


def silently(text: str) -> None:
    """Tell nobody."""


worlds: Registry[World] = Registry("world", __name__)
"""Factories take `rules`, `variant` (what a name has after its colon), `frames` (whether to
render) and `announce`; those with variants also have `resolve` and `check`, see `naming`."""
