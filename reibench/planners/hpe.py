"""HPE, RoboCerebra's hierarchical planning and execution (Han et al. 2025), for a text-only robot.

As appendix A.1 adapts it: the model writes sub-goals, then chooses the steps of each; a memory
bank of what was seen and done, kept by rules, stands in its prompt instead of the whole history.
"""

from collections import Counter
from collections.abc import Generator, Sequence
from typing import Literal

from reibench.artefact import Artefact
from reibench.backends import Backend, Prompt
from reibench.methods import Instruction
from reibench.planners import Decision, Plan, planners
from reibench.planners.attempts import attempts, with_shut_place
from reibench.planners.examples import Example, fixed_set, nearest
from reibench.planners.memory import MemoryBank
from reibench.planners.notebook import Notebook
from reibench.planners.subgoals import read_subgoals, stretches
from reibench.planners.telling import PENDING, told
from reibench.skill import DONE, Skill, parse_skill
from reibench.worlds import Event

HEADER = """\
A robot works in a home. A human asks it for something. It first writes the sub-goals that lead \
there, then reaches one after another by its actions: it goes to a thing with "find" before it \
uses it, and has one hand. If an action failed, it does what was missing and tries again. It says \
"done" when the sub-goal is reached. Its memory tells what it has seen and done so far.
"""
SUBGOALS = "Sub-goals:"
WRONG = "Wrong: there is no sub-goal; they read like 'get the mug; put the mug on the table'.\n"
ASKED_AGAIN = 2
"""How often sub-goals are asked for again where none can be read."""
STEPS_EACH = 12
"""Steps for one sub-goal, after which the next one is tried."""
TRIES = 3
"""How often the same skill may fail for the same reason before the sub-goal is left."""
LONGEST = 96
"""Tokens of the sub-goals."""


@planners.register("hpe")
class HierarchicalPlanningAndExecution:
    """Write sub-goals, then choose step by step with a memory bank in the prompt."""

    title = "HPE"
    summary = "sub-goals first, then the steps of each, with a memory bank"

    def __init__(
        self, backend: Backend, *, examples: Literal["nearest", "fixed"] = "nearest"
    ) -> None:
        """Prepare the prompt; `examples` as in `SayCan`."""
        self._backend = backend
        self._examples = examples

    def plan(self, instruction: Instruction, start: Event, skills: tuple[Skill, ...]) -> Plan:
        """Yield the steps of one sub-goal after another; reads no scene."""
        shown = nearest(instruction.text) if self._examples == "nearest" else fixed_set()
        notebook = Notebook(self._backend)
        execution = Execution(notebook, introduction(shown), told(instruction), skills)
        subgoals = execution.divide()
        for subgoal in subgoals:
            yield from execution.reach(subgoal)
        return notebook.closing(*execution.shown())


class Execution:
    """One task on its way: its sub-goals, and what is remembered."""

    def __init__(
        self, notebook: Notebook, prefix: str, task: str, skills: tuple[Skill, ...]
    ) -> None:
        self._notebook = notebook
        self._prefix = prefix
        self._task = task
        self._skills = skills
        self._options = [f" {skill}" for skill in skills] + [f" {DONE}"]
        self._memory = MemoryBank()
        self._subgoals: tuple[str, ...] = ()
        self._current = ""
        self._left: list[str] = []

    def divide(self) -> tuple[str, ...]:
        """Let the model write the sub-goals; none if nothing it writes can be read."""
        text = f"{self._prefix}{self._task}{SUBGOALS}"
        for _ in range(ASKED_AGAIN + 1):
            prompt = Prompt(text, fixed=len(self._prefix))
            answer = self._notebook.generate(
                prompt,
                "Sub-goals as written",
                most=LONGEST,
                stop=("\n",),
            )
            self._subgoals = read_subgoals(answer)
            if self._subgoals:
                return self._subgoals
            self._notebook.note("Sub-goals refused", "No sub-goal can be read in the answer.")
            text += f"{answer}\n{WRONG}{SUBGOALS}"
        self._notebook.note("Given up", f"{ASKED_AGAIN + 1} answers in a row had no sub-goal.")
        return ()

    def reach(self, subgoal: str) -> Generator[Decision, Event, None]:
        """Yield the steps of one sub-goal until the model says it is done."""
        self._current = subgoal
        text = f"{self._prefix}{self._task}{SUBGOALS} {'; '.join(self._subgoals)}\n"
        text += question(self._memory, subgoal)
        failures: Counter[tuple[Skill, str]] = Counter()
        for _ in range(STEPS_EACH):
            chosen = self._notebook.choose(Prompt(text, fixed=len(self._prefix)), self._options)
            if chosen == DONE:
                self._memory.finish(subgoal)
                return
            skill = parse_skill(chosen, self._skills)
            event = yield self._notebook.decision(skill, *self.shown())
            self._memory.write(skill, success=event.success, message=event.message)
            text += step(skill, "" if event.success else event.message)
            failures[skill, event.message] += not event.success
            if failures[skill, event.message] >= TRIES:
                self._leave(f"{skill} failed {TRIES} times: {event.message}.")
                return
        self._leave(f"not done after {STEPS_EACH} steps.")

    def _leave(self, reason: str) -> None:
        self._left.append(self._current)
        self._notebook.note("Sub-goal left", f"{self._current}: {reason}")
        self._current = ""

    def shown(self) -> tuple[Artefact, ...]:
        """Return the sub-goals and the memory as they are now."""
        if not self._subgoals:
            return ()
        marks = dict.fromkeys(self._left, "left") | {self._current: "now"}
        marks |= dict.fromkeys(self._memory.finished, "done")
        lines = (f"{marks.get(each, 'to do')}: {each}" for each in self._subgoals)
        return (
            Artefact("plan", "Sub-goals", "\n".join(lines)),
            Artefact("memory", "Memory", written(self._memory, "\n")),
        )


def written(memory: MemoryBank, separator: str) -> str:
    """Return the entries of `memory` in words."""
    return separator.join(f"{heading}: {words}" for heading, words in memory.entries())


def question(memory: MemoryBank, subgoal: str) -> str:
    """Return what stands before the steps of a sub-goal."""
    return f"Memory: {written(memory, '. ')}\nSub-goal: {subgoal}\nRobot:"


def step(skill: Skill, failure: str) -> str:
    """Return a step as it stands in the prompt."""
    return f" {skill} (this action failed: {failure})," if failure else f" {skill},"


def introduction(examples: Sequence[Example]) -> str:
    """Return what the prompt begins with, the same for every instruction of a kind."""
    return "\n".join((HEADER, *map(_solved, with_shut_place(examples)), ""))


def _solved(example: Example) -> str:
    parts = list(stretches(example.task_type, attempts(example)))
    memory = MemoryBank()
    text = f"{PENDING}{example.instruction}\n"
    text += f"{SUBGOALS} {'; '.join(part.subgoal for part in parts)}\n"
    for part in parts:
        text += question(memory, part.subgoal)
        for attempt in part.attempts:
            text += step(attempt.skill, attempt.failure)
            memory.write(attempt.skill, success=not attempt.failure, message=attempt.failure)
        text += f" {DONE}\n"
        memory.finish(part.subgoal)
    return text
