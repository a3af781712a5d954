"""How planners that read text are told what to do: the same words for every one of them."""

from reibench.methods import Instruction

PREVIOUS = "Human previous inquiry (not required to execute): "
PENDING = "Human pending instruction: "
"""Both are the published code's."""


def told(instruction: Instruction) -> str:
    """Return what a planner's prompt says of the task, whatever method prepared it.

    In this order, each ending its line: the method's demonstrations, the dialogue as far as the
    method leaves it to the planner, the pending instruction, what the robot noted about it.
    """
    shown = f"{instruction.demonstrations.rstrip()}\n\n" if instruction.demonstrations else ""
    before = "".join(f"{PREVIOUS}{said}\n" for said in instruction.context)
    notes = f"{instruction.notes.rstrip()}\n" if instruction.notes else ""
    return f"{shown}{before}{PENDING}{instruction.text}\n{notes}"
