"""Least filled: whoever comes gets what has been played least, counting those who are at it."""

from collections import Counter
from collections.abc import Sequence

from reibench.dialogue import Vagueness
from reibench.episode import Episode
from study.designs import Comer, designs


@designs.register("least-filled")
class LeastFilled:
    """Fill the emptiest level first, and in it the emptiest episode."""

    def check(self, pool: Sequence[Episode]) -> None:
        """Accept any episodes."""

    def assign(self, pool: Sequence[Episode], trials: int, comer: Comer) -> list[Episode]:
        """Return the emptiest episodes, of as many tasks."""
        order = list(pool)
        comer.choose.shuffle(order)
        levels: Counter[Vagueness] = Counter({episode.vagueness: 0 for episode in pool})
        for episode in pool:
            levels[episode.vagueness] += comer.filled.get(episode.id, 0)
        chosen: list[Episode] = []
        while len(chosen) < trials:
            met = {episode.task.id for episode in chosen}
            left = [episode for episode in order if episode.task.id not in met]
            fewest = min(left, key=lambda one: (levels[one.vagueness], comer.filled.get(one.id, 0)))
            chosen.append(fewest)
            levels[fewest.vagueness] += 1
        comer.choose.shuffle(chosen)
        return chosen
