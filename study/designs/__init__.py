"""Designs: which participant meets which episodes."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from random import Random
from typing import Protocol

from reibench.episode import Episode
from reibench.registry import Registry


@dataclass(frozen=True)
class Comer:
    """Who has just come, as a design sees them."""

    slot: int
    """The least number that nobody who finished or takes part has."""
    filled: Mapping[str, int]
    """How often each episode is played or being played by others, by id."""
    choose: Random
    """Decides among equals; the participant's own."""


class Design(Protocol):
    """A rule that gives a participant episodes, each of another task."""

    def check(self, pool: Sequence[Episode]) -> None:
        """Raise ReibenchError if it cannot work with these episodes."""
        ...

    def assign(self, pool: Sequence[Episode], trials: int, comer: Comer) -> list[Episode]:
        """Return a participant's episodes; no two are of the same task.

        Args:
            pool: what there is.
            trials: how many.
            comer: who has just come.
        """
        ...


designs: Registry[Design] = Registry("design", __name__)
