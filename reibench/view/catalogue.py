"""Finding one's way among the episodes: by task type, room and vagueness level."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from random import Random

from reibench.dialogue import LEVELS, Vagueness
from reibench.episode import Episode, TaskType


@dataclass(frozen=True)
class Catalogue:
    """The episodes a page offers; each task comes in up to nine levels."""

    episodes: tuple[Episode, ...]

    @classmethod
    def of(cls, episodes: Iterable[Episode]) -> "Catalogue":
        """Return a catalogue of `episodes`, in their order."""
        return cls(tuple(episodes))

    @cached_property
    def task_types(self) -> tuple[TaskType, ...]:
        """The task types there are, in their fixed order."""
        present = {episode.task.goal.task_type for episode in self.episodes}
        return tuple(kind for kind in TaskType if kind in present)

    @cached_property
    def rooms(self) -> tuple[str, ...]:
        """The rooms there are episodes in, in natural order."""
        return tuple(sorted({e.task.setup.room for e in self.episodes}, key=_natural))

    @cached_property
    def by_id(self) -> dict[str, Episode]:
        """The episodes by their id."""
        return {episode.id: episode for episode in self.episodes}

    @property
    def first(self) -> Episode:
        """The episode a newcomer sees: vague, but as the paper's own examples are."""
        wanted = Vagueness("implicit", "standard")
        vague = [each for each in self.episodes if each.vagueness == wanted]
        heat = [each for each in vague if each.task.goal.task_type is TaskType.HEAT]
        return (heat or vague or list(self.episodes))[0]

    def tasks(self, kind: TaskType) -> tuple[tuple[str, str], ...]:
        """Return id and room of every task of this type, by room, `kitchen-9` before `-10`."""
        found = {
            episode.task.id: episode.task.setup.room
            for episode in self.episodes
            if episode.task.goal.task_type is kind
        }
        return tuple(sorted(found.items(), key=lambda task: _natural(task[1])))

    def levels(self, task: str) -> frozenset[Vagueness]:
        """Return the levels a task comes in."""
        return frozenset(each.vagueness for each in self.of_task.get(task, ()))

    @cached_property
    def of_task(self) -> dict[str, list[Episode]]:
        """The episodes of each task, by its id."""
        found: dict[str, list[Episode]] = {}
        for episode in self.episodes:
            found.setdefault(episode.task.id, []).append(episode)
        return found

    def change(
        self, current: Episode, *, kind: str = "", task: str = "", level: str = ""
    ) -> Episode:
        """Return the episode nearest to `current` that has what was chosen."""
        wanted = Vagueness.parse(level) if level else current.vagueness
        tasks = self.of_task.get(task or current.task.id, [])
        if kind:
            tasks = [each for each in self.episodes if each.task.goal.task_type == kind]
        if not tasks:
            return current
        first_task = tasks[0].task.id
        offered = [each for each in tasks if each.task.id == first_task]

        def distance(episode: Episode) -> int:
            at, goal = LEVELS.index(episode.vagueness), LEVELS.index(wanted)
            return abs(at // 3 - goal // 3) + abs(at % 3 - goal % 3)

        return min(offered, key=distance)

    def shuffled(self, current: Episode, seed: int) -> Episode:
        """Return another task's episode at random, of the same level if there is one."""
        others = [each for each in self.episodes if each.task.id != current.task.id]
        alike = [each for each in others if each.vagueness == current.vagueness]
        others = alike or others or [each for each in self.episodes if each.id != current.id]
        return Random(seed).choice(others) if others else current


def _natural(room: str) -> tuple[str, int]:
    """Order rooms by kind, then by number."""
    kind, _, number = room.rpartition("-")
    return (kind, int(number)) if number.isdecimal() else (room, 0)
