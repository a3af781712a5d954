"""Designs: which participant meets which episodes."""

from collections.abc import Mapping, Sequence
from random import Random
from typing import Protocol

from reibench.episode import Episode
from reibench.registry import Registry


class Design(Protocol):
    """A rule that gives a participant episodes, each of another task."""

    def check(self, pool: Sequence[Episode]) -> None:
        """Raise ReibenchError if it cannot work with these episodes."""
        ...

    def assign(
        self,
        pool: Sequence[Episode],
        trials: int,
        slot: int,
        filled: Mapping[str, int],
        choose: Random,
    ) -> list[Episode]:
        """Return a participant's episodes; no two are of the same task.

        Args:
            pool: what there is.
            trials: how many.
            slot: the least number that nobody who finished or takes part has.
            filled: how often each episode is played or being played by others, by id.
            choose: decides among equals; the participant's own.
        """
        ...


designs: Registry[Design] = Registry("design", __name__)
