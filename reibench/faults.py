"""What exactly went wrong in a failed episode: a finer kind below the paper's two, from the record.

The paper tells object omission from execution error (section 4.4, reading note 9). This says what a
reader of the record would say next. Nothing here reads message text or prompts.
"""

from collections import Counter
from collections.abc import Iterator
from enum import StrEnum

from reibench.episode import Goal, TaskType
from reibench.rollout import Record, Step
from reibench.skill import PICKABLE, Verb
from reibench.verdict import omitted

STUCK = 3
"""How often a skill must fail, and never work again, for the actor to be stuck on it."""
TOOLS = {
    TaskType.HEAT: ("Microwave",),
    TaskType.COOL: ("Fridge",),
    TaskType.CLEAN: ("Sink", "SinkBasin"),
}
"""Where things of a task type are put on the way."""


class FaultKind(StrEnum):
    """What a failed episode failed by; each failure has exactly one, the first that applies."""

    WRONG_OBJECT = "wrong-object"
    """A task object was never taken, and something else was taken or carried in its place."""
    REPEATED_FAILURE = "repeated-failure"
    """One and the same skill was refused again and again, and nothing came of it."""
    WRONG_RECEPTACLE = "wrong-receptacle"
    """What was to be carried ended somewhere else than was asked."""
    WRONG_ORDER = "wrong-order"
    """All that was asked held at some time, but not together at the end."""
    MISSING_STEP = "missing-step"
    """The thing got where it should, or was tried for, without a step that was needed before."""
    STOPPED_EARLY = "stopped-early"
    """The actor said done while it was still on the way."""
    BUDGET_SPENT = "budget-spent"
    """The steps were used up on the way, without being stuck on one."""


def fault_kind(record: Record) -> FaultKind | None:
    """Return what `record` failed by; None if it succeeded or broke down."""
    if record.status in ("success", "error"):
        return None
    kinds = _omission(record) if omitted(record) else _execution(record)
    ended = FaultKind.STOPPED_EARLY if record.said_done else FaultKind.BUDGET_SPENT
    return next(kinds, ended)


def _omission(record: Record) -> Iterator[FaultKind]:
    if instead(record):
        yield FaultKind.WRONG_OBJECT
    if _stuck(record):
        yield FaultKind.REPEATED_FAILURE
    if _tried_for_what_it_omitted(record):
        yield FaultKind.MISSING_STEP


def _execution(record: Record) -> Iterator[FaultKind]:
    if not record.said_done and _stuck(record):
        yield FaultKind.REPEATED_FAILURE
    if _left_elsewhere(record):
        yield FaultKind.WRONG_RECEPTACLE
    ever = {goal.name for step in record.steps for goal in step.event.goals if goal.holds}
    # the last condition is that the others hold of one and the same thing
    asked = [goal.name for goal in record.steps[-1].event.goals if "-and-" not in goal.name]
    if ever.issuperset(asked):
        yield FaultKind.WRONG_ORDER
    if ever & {"placed", "carrier-placed"} or _arrived(record):
        yield FaultKind.MISSING_STEP
    if _stuck(record):
        yield FaultKind.REPEATED_FAILURE


def instead(record: Record) -> tuple[str, int] | None:
    """Return the type of what was handled that nobody asked for, and the step that first names it.

    Nothing if there was none.
    """
    goal = record.episode.task.goal
    mine = {*goal.objects, goal.destination}
    if goal.sliced:
        mine |= {"Knife", "ButterKnife"}
    handling = (Verb.PICK_UP, Verb.PUT_DOWN, Verb.SLICE)
    for step in record.steps:
        name = step.decision.skill.object
        if step.decision.skill.verb in handling and name in PICKABLE and name not in mine:
            named = (s.number for s in record.steps if s.decision.skill.object == name)
            return name, next(named)
    return None


def _tried_for_what_it_omitted(record: Record) -> bool:
    missed = omitted(record)
    return any(
        step.decision.skill.verb in (Verb.PICK_UP, Verb.TURN_ON)
        and step.decision.skill.object in missed
        for step in record.steps
    )


def _stuck(record: Record) -> bool:
    """Whether some skill failed `STUCK` times after it last worked, without an end of that."""
    failures: Counter[str] = Counter()
    for step in record.steps:
        skill = step.decision.skill.text
        failures[skill] = 0 if step.event.success else failures[skill] + 1
    return any(count >= STUCK for count in failures.values())


def _carried(goal: Goal) -> str:
    return goal.movable_receptacle or goal.object


def _puts(record: Record, name: str) -> Iterator[tuple[Step, tuple[str, ...]]]:
    """Yield the steps that put a thing of this type down, and the types of what it lies in."""
    before = record.start
    for step in record.steps:
        held = before.scene.held if before else None
        if step.decision.skill.verb is Verb.PUT_DOWN and step.event.success and held:
            scene = step.event.scene
            lying = scene.by_id.get(held.id)
            if lying and held.type.removesuffix("Sliced") == name:
                parents = (scene.by_id[one] for one in lying.parents if one in scene.by_id)
                yield step, tuple(parent.type for parent in parents)
        before = step.event


def _left_elsewhere(record: Record) -> bool:
    """Whether what was to be carried was put down last, and lies, where nobody asked for it."""
    goal = record.episode.task.goal
    if goal.task_type is TaskType.EXAMINE:
        return False
    right = {goal.destination, f"{goal.destination}Basin", *TOOLS.get(goal.task_type, ())}
    for name in {_carried(goal), goal.object}:
        allowed = right | {goal.movable_receptacle} if name != _carried(goal) else right
        last = next(reversed([lying for _, lying in _puts(record, name)]), None)
        held = record.steps[-1].event.scene.held
        in_hand = held is not None and held.type.removesuffix("Sliced") == name
        if last is not None and not in_hand and not allowed & set(last):
            return True
    return False


def _arrived(record: Record) -> bool:
    """Whether the object was put straight where its carrier should have taken it."""
    goal = record.episode.task.goal
    return any(goal.destination in lying for _, lying in _puts(record, goal.object))
