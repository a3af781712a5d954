"""SayCan as LoTA-Bench and the paper run it: one constrained selection among the skills per step.

There is no learned value function (reading note 14), and the model's choice is the greedy walk of
`Backend.choose`, as in the published code.
"""

from collections.abc import Sequence
from typing import Literal

from reibench.backends import Backend, Prompt, adapters_of
from reibench.methods import Instruction
from reibench.planners import Closing, Decision, Plan, planners
from reibench.planners.examples import Example, fixed_set, nearest
from reibench.planners.telling import PENDING, told
from reibench.skill import DONE, Skill, parse_skill
from reibench.worlds import Event

TAUGHT = "planner"
"""The adapter that was taught this planner's prompt (`reibench/tuning`)."""
HEADER = """\
A robot works in a home. A human asks it for something, and it tells, in order, each of the \
actions that do it: it goes to a thing with "find" before it uses it, and has one hand. If an \
action failed, it does what was missing and tries again. It says "done" at the end.
"""


@planners.register("saycan")
class SayCan:
    """Choose one skill at a time, telling the model which ones failed and why."""

    title = "SayCan"
    summary = "one choice among the skills after another"

    def __init__(
        self, backend: Backend, *, examples: Literal["nearest", "fixed"] = "nearest"
    ) -> None:
        """Prepare the prompt.

        A model with an adapter for planning is shown no examples: it was taught by some.

        Args:
            backend: the language model.
            examples: `nearest` shows those of the task type a keyword rule finds in the
                instruction (see `nearest_type`), `fixed` the same two of every type.
        """
        self._backend = backend
        self._examples = examples
        self._adapter = TAUGHT if TAUGHT in adapters_of(backend) else ""

    def plan(self, instruction: Instruction, start: Event, skills: tuple[Skill, ...]) -> Plan:
        """Yield skills until the model chooses `done`; reads no scene."""
        options = [f" {skill}" for skill in skills] + [f" {DONE}"]
        prefix = "" if self._adapter else introduction(self._shown(instruction))
        text = f"{prefix}{told(instruction)}Robot:"
        while True:
            prompt = Prompt(text, fixed=len(prefix), adapter=self._adapter)
            selection = self._backend.choose(prompt, options)
            asked = selection.prompt or text
            if selection.text.strip() == DONE:
                return Closing(asked, selection.usage, selection.alternatives)
            skill = parse_skill(selection.text, skills)
            event = yield Decision(skill, asked, selection.usage, selection.alternatives)
            failure = "" if event.success else f" (this action failed: {event.message})"
            text += f" {skill}{failure},"

    def _shown(self, instruction: Instruction) -> Sequence[Example]:
        return nearest(instruction.text) if self._examples == "nearest" else fixed_set()


def introduction(examples: Sequence[Example]) -> str:
    """Return what the prompt begins with, the same for every instruction of a kind."""
    solved = (f"{PENDING}{one.instruction}\nRobot: {one.plan}, {DONE}\n" for one in examples)
    return "\n".join((HEADER, *solved, ""))
