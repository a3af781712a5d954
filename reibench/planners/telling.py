"""How planners that read text are told what to do: the same words for every one of them."""

from reibench.methods import Instruction
from reibench.methods.wording import PENDING, PREVIOUS

__all__ = ["PENDING", "PREVIOUS", "told"]


def told(instruction: Instruction) -> str:
    """Return what a planner's prompt says of the task, whatever method prepared it.

    In this order, each ending its line: the method's demonstrations, the dialogue as far as the
    method leaves it to the planner, the pending instruction, what the robot noted about it.
    """
    shown = f"{instruction.demonstrations.rstrip()}\n\n" if instruction.demonstrations else ""
    before = "".join(f"{PREVIOUS}{said}\n" for said in instruction.context)
    notes = f"{instruction.notes.rstrip()}\n" if instruction.notes else ""
    return f"{shown}{before}{PENDING}{instruction.text}\n{notes}"
