"""Least filled: whoever comes gets what has been played least, counting those who are at it."""

from collections import Counter
from collections.abc import Mapping, Sequence
from random import Random

from reibench.dialogue import Vagueness
from reibench.episode import Episode
from study.designs import designs


@designs.register("least-filled")
class LeastFilled:
    """Fill the emptiest level first, and in it the emptiest episode."""

    def check(self, pool: Sequence[Episode]) -> None:
        """Accept any episodes."""

    def assign(
        self,
        pool: Sequence[Episode],
        trials: int,
        slot: int,
        filled: Mapping[str, int],
        choose: Random,
    ) -> list[Episode]:
        """Return the emptiest episodes, of as many tasks."""
        order = list(pool)
        choose.shuffle(order)
        levels: Counter[Vagueness] = Counter({episode.vagueness: 0 for episode in pool})
        for episode in pool:
            levels[episode.vagueness] += filled.get(episode.id, 0)
        chosen: list[Episode] = []
        while len(chosen) < trials:
            met = {episode.task.id for episode in chosen}
            left = [episode for episode in order if episode.task.id not in met]
            fewest = min(left, key=lambda one: (levels[one.vagueness], filled.get(one.id, 0)))
            chosen.append(fewest)
            levels[fewest.vagueness] += 1
        choose.shuffle(chosen)
        return chosen
