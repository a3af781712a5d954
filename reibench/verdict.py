"""Why an episode ended as it did: the paper's two error kinds, from what was done."""

from enum import StrEnum

from reibench.episode import TaskType
from reibench.rollout import Record
from reibench.skill import Verb


class ErrorKind(StrEnum):
    """The paper's two kinds of failure (section 4.3), and the one it never counted."""

    OMISSION = "object-omission"
    """Some task object of the goal was never picked up (a lamp: never turned on)."""
    EXECUTION = "execution-error"
    """Every task object was identified, but the goal does not hold at the end."""
    BREAKDOWN = "breakdown"
    """Model, world or program broke; the episode still counts as not solved."""


def identified(record: Record) -> frozenset[str]:
    """Return the types of what was picked up, and of the lamps that were turned on."""
    found: set[str] = set()
    for step in record.steps:
        if not step.event.success:
            continue
        held = step.event.scene.held
        if step.decision.skill.verb is Verb.PICK_UP and held:
            found.add(held.type.removesuffix("Sliced"))
        if step.decision.skill.verb is Verb.TURN_ON:
            found.add(step.decision.skill.object)
    return frozenset(found)


def omitted(record: Record) -> tuple[str, ...]:
    """Return the goal's task objects that the actor never identified (reading note 9)."""
    goal = record.episode.task.goal
    found = set(identified(record))
    if goal.task_type is TaskType.EXAMINE and goal.destination not in found:
        # A lamp that stood lit in view at some time needs no turning on.
        events = (record.start, *(step.event for step in record.steps))
        if any(c.name == "lit" and c.holds for event in events if event for c in event.goals):
            found.add(goal.destination)
    return tuple(name for name in goal.objects if name not in found)


def error_kind(record: Record) -> ErrorKind | None:
    """Return which kind of failure `record` is; None if it succeeded."""
    if record.status == "success":
        return None
    if record.status == "error":
        return ErrorKind.BREAKDOWN
    return ErrorKind.OMISSION if omitted(record) else ErrorKind.EXECUTION
