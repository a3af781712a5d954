"""Episodes of the realiser that nothing was taught on: for measuring adapters and other models."""

from reibench.dataset.levels import derive
from reibench.dataset.realise.compose import CannotRealise, Realiser
from reibench.dataset.realise.tasks import Solvable, tasks
from reibench.dialogue import LEVELS
from reibench.episode import Episode
from reibench.errors import ReibenchError
from reibench.household import load_room
from reibench.household.rooms import ROOMS
from reibench.tuning.restatements import untaught_lexicon

SEED = 2_000_000
"""Added to seeds: tasks that are taught have small ones."""


def held_out_episodes(number: int, seed: int, solvable: Solvable) -> list[Episode]:
    """Return made-up episodes, one a task, spread over the nine levels.

    Their rooms are the shipped ones, in which nothing is taught, and their vague expressions the
    part of the lexicon kept back; their sentences are the realiser's, as those taught are.
    `solvable` tells whether a task works out in its room.

    Raises:
        ReibenchError: when there are to be none.
    """
    if number < 1:
        raise ReibenchError(f"--n {number} makes no episode; ask for at least 1.")
    realiser = Realiser(untaught_lexicon())
    # rooms imported on this machine are no part of it
    rooms = [load_room(path.stem) for path in sorted(ROOMS.glob("*.json"))]
    levels = [level for level in LEVELS if level.context != "alone"]
    made: list[Episode] = []
    for found in tasks(rooms, SEED + seed, solvable):
        try:
            script = realiser.realise(found.task, found.present, found.task.id)
        except CannotRealise:
            continue
        made += derive(script, [levels[len(made) % len(levels)]])
        if len(made) == number:
            return sorted(made, key=lambda episode: levels.index(episode.vagueness))
    raise AssertionError("tasks never end")
