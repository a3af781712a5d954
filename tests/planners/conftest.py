"""A room played by hand: events that say whether a skill worked, and nothing else."""

from collections.abc import Callable, Sequence

import pytest

from reibench.methods import Instruction
from reibench.planners import Closing, Decision, Planner
from reibench.scene import Pose, Scene, Vector
from reibench.skill import SKILLS
from reibench.worlds import Event

EMPTY = Scene("nowhere", (), Pose(Vector(0, 0, 0), 0))
WORKED = Event(True, "", EMPTY, ())


@pytest.fixture
def asked() -> Instruction:
    return Instruction("Put the apple in the fridge.", "Put the fruit in the fridge.")


@pytest.fixture
def played() -> Callable[..., tuple[list[Decision], Closing]]:
    """Play a planner to its end in a room where everything works but what `refusals` says."""

    def play(
        planner: Planner, instruction: Instruction, refusals: Sequence[tuple[str, str]] = ()
    ) -> tuple[list[Decision], Closing]:
        left = list(refusals)
        plan = planner.plan(instruction, WORKED, SKILLS)
        decisions: list[Decision] = []
        event = None
        try:
            while True:
                decision = plan.send(event)
                decisions.append(decision)
                event = WORKED
                if left and left[0][0] == decision.skill.text:
                    event = Event(False, left.pop(0)[1], EMPTY, ())
        except StopIteration as end:
            assert not left, f"never tried: {left}"
            return decisions, end.value

    return play
