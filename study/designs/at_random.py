"""Random: any tasks, each at any of its levels."""

from collections import defaultdict
from collections.abc import Sequence

from reibench.episode import Episode
from study.designs import Comer, designs


@designs.register("random")
class AtRandom:
    """Draw tasks, and for each a level."""

    def check(self, pool: Sequence[Episode]) -> None:
        """Accept any episodes."""

    def assign(self, pool: Sequence[Episode], trials: int, comer: Comer) -> list[Episode]:
        """Return episodes drawn by the participant's own seed."""
        of_task: dict[str, list[Episode]] = defaultdict(list)
        for episode in pool:
            of_task[episode.task.id].append(episode)
        return [
            comer.choose.choice(of_task[task])
            for task in comer.choose.sample(sorted(of_task), trials)
        ]
