"""Execution errors: which condition never came true or was lost, and at which step."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from reibench.episode import Goal, TaskType
from reibench.explanation.words import a, base, holds, refused, sentence, stuck_on, word
from reibench.faults import TOOLS, FaultKind, fault_kind
from reibench.goals import Condition, preposition
from reibench.rollout import Record
from reibench.skill import Verb

TREATED = {TaskType.HEAT: "heated", TaskType.COOL: "cooled", TaskType.CLEAN: "cleaned"}


def execution(record: Record) -> str:
    """Return why `record` failed though everything was identified."""
    kind = fault_kind(record)
    assert kind is not None
    return _EXECUTION[kind](_Failure(record))


@dataclass(frozen=True)
class _Failure:
    """What the sentences about execution errors need of a record."""

    record: Record

    @property
    def goal(self) -> Goal:
        return self.record.episode.task.goal

    @property
    def carried(self) -> str:
        """What was to get to its place."""
        return self.goal.movable_receptacle or self.goal.object

    @property
    def conditions(self) -> tuple[Condition, ...]:
        return self.record.steps[-1].event.goals if self.record.steps else ()

    def lost(self, name: str) -> int | None:
        """Return the step at which a condition that had held was lost for good."""
        start = self.record.start
        held, lost = holds(start.goals if start else (), name), None
        for step in self.record.steps:
            now = holds(step.event.goals, name)
            if held and not now:
                lost = step.number
            held = now
        return None if held else lost

    def since(self, name: str) -> int | None:
        """Return the first step after which a condition holds; None if it never does."""
        return next((s.number for s in self.record.steps if holds(s.event.goals, name)), None)

    @property
    def missing(self) -> list[Condition]:
        """The conditions that do not hold at the end."""
        return [one for one in self.conditions if not one.holds]

    def skill(self, number: int) -> str:
        return str(self.record.steps[number - 1].decision.skill)

    @property
    def ended(self) -> str:
        """How the episode ended, as the beginning of a sentence."""
        taken = len(self.record.steps)
        if self.record.said_done:
            return f"it was said to be done after step {taken}"
        if self.record.expired:
            return f"the time was up after step {taken}"
        return f"all {taken} steps were used"


def _put_elsewhere(failure: _Failure) -> str:
    """Return where a thing was left that should be somewhere else."""
    goal = failure.goal
    right = {goal.destination, f"{goal.destination}Basin", *TOOLS.get(goal.task_type, ())}
    for name in dict.fromkeys((failure.carried, goal.object)):
        allowed = right | {goal.movable_receptacle} if name != failure.carried else right
        last = _last_put(failure.record, name)
        if last and not allowed & set(last[1]):
            step, places = last
            where = (
                f"{preposition(places[0])} {a(places[0])}" if places else "nowhere in particular"
            )
            wanted = _wanted(goal, name, failure.carried)
            return sentence(f"the {word(name)} was left {where} at step {step}, not {wanted}")
    return _never(failure)


def _wanted(goal: Goal, name: str, carried: str) -> str:
    place = goal.destination if name == carried else goal.movable_receptacle
    return f"{preposition(place)} the {word(place)}"


def _last_put(record: Record, name: str) -> tuple[int, list[str]] | None:
    """Return the step that last put a thing of this type down, and what it then lay in."""
    last, before = None, record.start
    for step in record.steps:
        held = before.scene.held if before else None
        if held and base(held.type) == name and step.event.success:
            lying = step.event.scene.by_id.get(held.id)
            if step.decision.skill.verb is Verb.PUT_DOWN and lying and not lying.held:
                scene = step.event.scene
                parents = [scene.by_id[one].type for one in lying.parents if one in scene.by_id]
                last = (step.number, parents)
        before = step.event
    return last


def _in_wrong_order(failure: _Failure) -> str:
    """Return which condition held and was lost again; or that the parts held of several things."""
    for condition in failure.missing:
        lost, since = failure.lost(condition.name), failure.since(condition.name)
        if lost and "-and-" not in condition.name:
            return sentence(
                f"“{condition.text}” held from step {since} and was lost at step {lost}"
                f" ({failure.skill(lost)})"
            )
    treated = TREATED.get(failure.goal.task_type, "")
    placed, at = failure.since("placed"), failure.since(treated)
    if placed and at and at > placed:
        return sentence(
            f"it was put in its place at step {placed} and {treated} only at step {at}; it was not"
            " put there again"
        )
    apart = [
        f"“{c.text}” since step {failure.since(c.name)}" for c in failure.conditions if c.holds
    ]
    if not apart:
        return _never(failure)
    last = failure.missing[-1].text
    return sentence(f"{', '.join(apart)}, but of different things: “{last}” never came true")


def _without_a_step(failure: _Failure) -> str:
    """Return which step was left out before a thing was put where it should be."""
    goal = failure.goal
    treated = TREATED.get(goal.task_type)
    carried = word(failure.carried)
    if goal.sliced and not failure.since("sliced"):
        return sentence(f"the {word(goal.object)} was never sliced")
    if treated and failure.since(treated) is None:
        return sentence(f"the {carried} {_brought(failure)}, but never {treated}")
    placed = failure.since("placed") or failure.since("carrier-placed")
    if goal.task_type is TaskType.STACK and failure.since("stacked") is None:
        on = preposition(goal.movable_receptacle)
        thing = word(goal.object)
        if placed:
            return sentence(
                f"the {carried} was put in its place at step {placed} without the {thing} {on} it"
            )
        return sentence(f"the {thing} was never put {on} the {carried}")
    return _never(failure)


def _brought(failure: _Failure) -> str:
    """Return how what was to be carried came to its place, or that it did not."""
    goal, start = failure.goal, failure.record.start
    where = f"{preposition(goal.destination)} the {word(goal.destination)}"
    last = _last_put(failure.record, failure.carried)
    if last and {goal.destination, f"{goal.destination}Basin"} & set(last[1]):
        return f"was put {where} at step {last[0]}"
    if start and holds(start.goals, "placed") and failure.since("placed") == 1:
        return f"lay {where} from the start"
    return "was carried"


def _again_and_again(failure: _Failure) -> str:
    """Return which skill was refused again and again, and what was still to come true."""
    stuck = stuck_on(failure.record)
    if stuck is None:
        return _never(failure)
    return sentence(f"{refused(*stuck)}; {_still(failure)}" if failure.missing else refused(*stuck))


def _never(failure: _Failure) -> str:
    """Return how it ended, and the first condition that was still to come true."""
    if not failure.missing:
        return sentence(f"{failure.ended}, and the goal does not hold")
    return sentence(f"{failure.ended}; {_still(failure)}")


def _still(failure: _Failure) -> str:
    """Return the first condition that does not hold, and at which step it was lost if it was."""
    parts = [one for one in failure.missing if "-and-" not in one.name] or failure.missing
    never = [one for one in parts if not failure.lost(one.name)]
    if never:
        return f"“{never[0].text}” never came true"
    lost = failure.lost(parts[0].name) or 1
    return f"“{parts[0].text}” was lost at step {lost} ({failure.skill(lost)})"


_EXECUTION: Mapping[FaultKind, Callable[[_Failure], str]] = {
    FaultKind.WRONG_OBJECT: _never,
    FaultKind.REPEATED_FAILURE: _again_and_again,
    FaultKind.WRONG_RECEPTACLE: _put_elsewhere,
    FaultKind.WRONG_ORDER: _in_wrong_order,
    FaultKind.MISSING_STEP: _without_a_step,
    FaultKind.STOPPED_EARLY: _never,
    FaultKind.BUDGET_SPENT: _never,
}
