"""Errors a user can act on; anything else that escapes is a bug."""

from collections.abc import Iterable
from difflib import get_close_matches


class ReibenchError(Exception):
    """Base of every error this library raises on purpose; its text is one clear sentence."""


class UnknownName(ReibenchError):
    """Nothing of that kind is called that: a planner, model, episode, room, an object type."""


class UnknownSkill(ReibenchError):
    """Text that is none of the skills."""


class InvalidEpisode(ReibenchError):
    """An episode, task or manifest file says something impossible."""


class InvalidTrial(ReibenchError):
    """An ALFRED trial or a file of the official split lacks something or is damaged."""


class InvalidGoal(ReibenchError):
    """A PDDL goal that cannot be read, or that no plan reaches."""


class InvalidRoom(ReibenchError):
    """A room or scene file says something impossible."""


class ModelUnavailable(ReibenchError):
    """A language model's file is missing or broken, or its source cannot be reached."""


class WorldUnavailable(ReibenchError):
    """A world cannot be had here: something is not installed, or cannot be downloaded."""


class WorldBroken(ReibenchError):
    """A world's simulator died, hung or talked nonsense; the next reset starts a fresh one."""


class WorkerLost(ReibenchError):
    """A process or machine that played an episode for a run died."""


class StoreUnavailable(ReibenchError):
    """The database cannot be opened, read or written."""


class StaleStep(ReibenchError):
    """A click that expected another step number than the one the episode is at."""


def unknown(kind: str, name: str, known: Iterable[str], *, most: int = 40) -> UnknownName:
    """Say that no `kind` is called `name`, with the nearest known name and what there is."""
    names = list(known)
    lower = {candidate.lower(): candidate for candidate in names}
    near = get_close_matches(name.lower(), lower, n=1)
    hint = f" Did you mean {lower[near[0]]!r}?" if near else ""
    listed = ", ".join(names[:most]) + (f", … ({len(names)} in all)" if len(names) > most else "")
    return UnknownName(f"No {kind} called {name!r}.{hint} Known: {listed or 'none'}.")
