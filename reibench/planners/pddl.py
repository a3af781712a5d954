"""Fast Downward through unified-planning: plans for problems of the household domain.

The one module that loads these packages, when a plan is first wanted.
"""

import logging
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from threading import Lock
from typing import Any

from reibench.errors import InvalidGoal, ReibenchError

DOMAIN = Path(__file__).parents[2] / "assets" / "pddl" / "household.pddl"
SECONDS = 20.0
"""How long Fast Downward may take; for our rooms it takes about one."""
SEARCH = "eager_wastar([ff()],preferred=[ff()],w=3)"
"""Of the searches that are quick in every room this one makes the fewest detours. Plain A* is
three times slower where something is sliced, and `lama-first` walks about."""

log = logging.getLogger(__name__)
_READING = Lock()


@dataclass(frozen=True)
class Action:
    """One action of a plan with what it is done to."""

    name: str
    arguments: tuple[str, ...]

    def __str__(self) -> str:
        return f"({' '.join((self.name, *self.arguments))})"


def solve(problem: str, *, seconds: float = SECONDS) -> tuple[Action, ...]:
    """Return a plan for `problem`, the PDDL text of a problem in the household domain.

    Fast Downward runs in a process of its own, needs no network, prints nothing and leaves no
    files. What was solved lately is not solved again: many episodes ask the same of a room.

    Raises:
        InvalidGoal: when nothing reaches the goal, or nothing was found in `seconds`.
        ReibenchError: when Fast Downward does not run here.
    """
    return _solved(problem, seconds)


@lru_cache(maxsize=256)
def _solved(problem: str, seconds: float) -> tuple[Action, ...]:
    from unified_planning.io import PDDLReader  # heavy: only when a plan is wanted

    with _READING:  # the reader keeps what it knows in one place for all threads
        domain = DOMAIN.read_text(encoding="utf-8")
        parsed = PDDLReader().parse_problem_string(domain, problem)
        engine = _engine()(fast_downward_search_config=SEARCH)
    result = engine.solve(parsed, timeout=seconds)
    if result.plan is not None:
        return tuple(
            Action(step.action.name, tuple(str(each) for each in step.actual_parameters))
            for step in result.plan.actions
        )
    status = result.status.name
    log.debug("Fast Downward ended with %s", status)
    if status == "TIMEOUT":
        raise InvalidGoal(f"No plan for the goal was found within {seconds:g} seconds.")
    if status.startswith("UNSOLVABLE"):
        raise InvalidGoal("Nothing the robot can do reaches this goal.")
    said = " ".join(each.message for each in result.log_messages or ())
    raise ReibenchError(f"Fast Downward does not run here: {status}, {said.strip()[-300:]!r}.")


@lru_cache(maxsize=1)
def _engine() -> Any:
    """Return the engine, made to keep its intermediate file out of the working directory."""
    from up_fast_downward.fast_downward import FastDownwardPDDLPlanner

    class TidyFastDownward(FastDownwardPDDLPlanner):  # type: ignore[misc]
        def _base_cmd(self, plan_filename: str) -> list[str]:
            # beside the plan, in a temporary folder: several may plan at a time
            command: list[str] = super()._base_cmd(plan_filename)
            return [*command, "--sas-file", f"{plan_filename}.sas"]

    return TidyFastDownward
