"""Samples: balanced over levels and task types, the same for the same seed."""

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from random import Random

from reibench.dataset.seeds import PROPORTIONS, shares
from reibench.dialogue import LEVELS, Vagueness
from reibench.episode import Episode, TaskType
from reibench.errors import ReibenchError

Cell = tuple[TaskType, Vagueness]


def stratified(
    episodes: Sequence[Episode], number: int, seed: int, *, once: bool = False
) -> list[Episode]:
    """Choose episodes in the paper's type proportions, each type spread over the nine levels.

    A thousand of the shipped ones have the counts of the paper's evaluation subset (appendix A.2).

    Args:
        episodes: to choose from, each once.
        number: how many.
        seed: decides among equals.
        once: whether a seed task may come at most once, as for one person.

    Raises:
        ReibenchError: when there are not enough.
    """
    choose = Random(seed)
    used: Counter[str] = Counter()
    cells = _cells(episodes)
    chosen: list[Episode] = []
    for (task_type, level), count in _quota(number, choose).items():
        fresh = [e for e in cells[task_type, level] if not once or not used[e.task.id]]
        if len(fresh) < count:
            raise ReibenchError(
                f"There are {len(fresh)} {task_type.short} tasks left at {level}, but {count} are"
                f" needed for a sample of {number}; ask for fewer."
            )
        choose.shuffle(fresh)
        fresh.sort(key=lambda episode: used[episode.task.id])
        chosen += fresh[:count]
        used.update(episode.task.id for episode in fresh[:count])
    place = {episode.id: number for number, episode in enumerate(episodes)}
    return sorted(chosen, key=lambda episode: place[episode.id])


def _cells(episodes: Sequence[Episode]) -> Mapping[Cell, list[Episode]]:
    cells: dict[Cell, list[Episode]] = defaultdict(list)
    for episode in episodes:
        cells[episode.task.goal.task_type, episode.vagueness].append(episode)
    return cells


def _quota(number: int, choose: Random) -> dict[Cell, int]:
    """Return how many of each type at each level: types as in the paper, levels within one."""
    quota: dict[Cell, int] = {}
    totals: Counter[Vagueness] = Counter()
    order = list(LEVELS)
    choose.shuffle(order)
    for task_type, share in shares(number).items():
        whole, rest = divmod(share, len(LEVELS))
        extra = sorted(order, key=lambda level: totals[level])[:rest]
        for level in LEVELS:
            quota[task_type, level] = whole + (level in extra)
            totals[level] += quota[task_type, level]
    return quota


def for_people(
    episodes: Sequence[Episode], people: int, trials: int, seed: int
) -> list[list[Episode]]:
    """Choose `trials` episodes for each of some people: no seed task twice for anyone.

    Each person meets the levels as evenly as `trials` allows and as many task types as may be;
    over all people the episodes are used evenly.
    """
    choose = Random(seed)
    used: Counter[str] = Counter()
    cells = _cells(episodes)
    types = list(PROPORTIONS)
    lists = []
    for person in range(people):
        met: set[str] = set()
        mine: list[Episode] = []
        for trial in range(trials):
            level = LEVELS[(person + trial) % len(LEVELS)]
            task_type = types[(person // len(LEVELS) + trial) % len(types)]
            fresh = [e for e in cells[task_type, level] if e.task.id not in met]
            if not fresh:
                raise ReibenchError(
                    f"Only {trial} trials can be had without a seed task coming twice for one"
                    f" person, not {trials}."
                )
            choose.shuffle(fresh)
            episode = min(fresh, key=lambda each: used[each.id])
            used[episode.id] += 1
            met.add(episode.task.id)
            mine.append(episode)
        lists.append(mine)
    return lists
