"""Latin square: tasks against levels, so that each task meets each level equally often."""

from collections.abc import Sequence
from math import lcm

from reibench.episode import Episode
from reibench.errors import ReibenchError
from study.designs import Comer, designs


@designs.register("latin-square")
class LatinSquare:
    """Go along the diagonals of tasks against levels, each slot its own stretch of them.

    At any time levels are filled evenly but for one, and so are tasks; after as many trials as
    there are episodes each has been played once. Their order is the participant's own.
    """

    def check(self, pool: Sequence[Episode]) -> None:
        """Refuse episodes that are not every task at every level."""
        tasks = {episode.task.id for episode in pool}
        levels = {episode.vagueness for episode in pool}
        if len(pool) != len(tasks) * len(levels):
            raise ReibenchError(
                f"A latin square needs every task at every level, {len(tasks)} × {len(levels)}, but"
                f" there are {len(pool)} episodes; choose whole tasks, or the design least-filled."
            )

    def assign(self, pool: Sequence[Episode], trials: int, comer: Comer) -> list[Episode]:
        """Return the stretch that belongs to the slot."""
        cells = {(episode.task.id, episode.vagueness): episode for episode in pool}
        tasks = list(dict.fromkeys(episode.task.id for episode in pool))
        levels = sorted({episode.vagueness for episode in pool})
        turn = lcm(len(tasks), len(levels))
        numbers = range(comer.slot * trials, (comer.slot + 1) * trials)
        chosen = [
            cells[tasks[n % len(tasks)], levels[(n + n // turn) % len(levels)]] for n in numbers
        ]
        comer.choose.shuffle(chosen)
        return chosen
