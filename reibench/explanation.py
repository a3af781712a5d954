"""Why an episode failed, in a sentence or two a reader of the record would write.

Which referent was missed, or which condition never came true or was lost, and at which step. It
rests on the same facts as `faults`, the finer kinds of failure, and never on prompts.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from reibench.dataset.forms import names
from reibench.dialogue import ReferringExpression
from reibench.episode import Goal, TaskType
from reibench.faults import STUCK, TOOLS, FaultKind, fault_kind
from reibench.goals import Condition, preposition
from reibench.rollout import Record, Step
from reibench.skill import PICKABLE, Verb, in_words, with_article
from reibench.verdict import omitted

TREATED = {TaskType.HEAT: "heated", TaskType.COOL: "cooled", TaskType.CLEAN: "cleaned"}


def explain(record: Record) -> str:
    """Return why `record` failed; of a success, what holds at its end."""
    if record.status == "error":
        return _sentence(record.error or "no reason was recorded")
    if record.status == "success":
        goals = record.steps[-1].event.goals if record.steps else ()
        return _sentence(goals[-1].text if goals else "the instruction is carried out")
    missing = omitted(record)
    if missing:
        return " ".join(_omission(record, missing))
    kind = fault_kind(record)
    assert kind is not None
    return _EXECUTION[kind](_Failure(record))


# object omission


def _omission(record: Record, missing: tuple[str, ...]) -> list[str]:
    """Return what was taken instead of what was meant, or why nothing was."""
    goal = record.episode.task.goal
    lamps = [
        name for name in missing if goal.task_type is TaskType.EXAMINE and name not in PICKABLE
    ]
    things = [name for name in missing if name not in lamps]
    parts = []
    if things:
        parts.append(_missed(record, things[0], _instead(record)))
        parts += [f"No {_word(name)} was picked up either." for name in things[1:]]
    elif lamps:
        parts.append(_unlit(record, lamps[0]))
    return parts


def _missed(record: Record, name: str, instead: tuple[str, int] | None) -> str:
    """Return why a thing was not picked up."""
    said = expression_for(record, name)
    vague = said is not None and not said.explicit
    tries = [s for s in record.steps if _is(s, Verb.PICK_UP, name) and not s.event.success]
    if tries:
        refused = _refused(f"picking up the {_word(name)}", tries)
        more = f"; it went for {_a(instead[0])} at step {instead[1]}" if instead else ""
        return _sentence(refused + more)
    if instead and said and vague:
        taken, step = instead
        return _sentence(
            f"“{said.text}” was taken for {_a(taken)} at step {step}; it means the {_word(name)}"
        )
    if instead:
        return f"At step {instead[1]} it went for {_a(instead[0])}, not the {_word(name)}."
    picked = any(_does(s, Verb.PICK_UP) and s.event.success for s in record.steps)
    found = next((s.number for s in record.steps if _is(s, Verb.FIND, name) and s.event.success), 0)
    if said and vague:
        meant = f"“{said.text}” means the {_word(name)}, but none was ever picked up"
    else:
        meant = f"no {_word(name)} was ever picked up"
    if found:
        meant += f", though it was found at step {found}"
    elif not picked:
        meant += ", nor was anything else"
    stuck = _stuck(record)
    return _sentence(f"{meant}; {_refused(*stuck)}" if stuck else meant)


def _instead(record: Record) -> tuple[str, int] | None:
    """Return what was handled that nobody asked for, and the step that first names it."""
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


def taken(record: Record) -> str:
    """Return the type of what was taken for the object that was meant: it, another, or nothing."""
    meant = record.episode.task.goal.object
    if meant not in omitted(record):
        return meant
    instead = _instead(record)
    return instead[0] if instead else ""


def _unlit(record: Record, lamp: str) -> str:
    tries = [s for s in record.steps if _is(s, Verb.TURN_ON, lamp) and not s.event.success]
    if tries:
        return _sentence(_refused(f"turning on the {_word(lamp)}", tries))
    words = f"the {_word(record.episode.task.goal.object)} was picked up, but no {_word(lamp)}"
    words += " was turned on"
    other = next((s for s in record.steps if _does(s, Verb.TURN_ON) and s.event.success), None)
    if other:
        words += f"; {_a(other.decision.skill.object)} was, at step {other.number}"
    return _sentence(words)


def expression_for(record: Record, name: str) -> ReferringExpression | None:
    """Return the expression that means a thing: of the instruction, or else the latest before."""
    for utterance in reversed(record.episode.dialogue.utterances):
        found = [one for one in utterance.expressions if one.referent == name]
        if found:
            vague = [one for one in found if not one.explicit]
            return (vague or found)[0]
    return None


# execution errors


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
        held, lost = _holds(start.goals if start else (), name), None
        for step in self.record.steps:
            holds = _holds(step.event.goals, name)
            if held and not holds:
                lost = step.number
            held = holds
        return None if held else lost

    def since(self, name: str) -> int | None:
        """Return the first step after which a condition holds; None if it never does."""
        return next((s.number for s in self.record.steps if _holds(s.event.goals, name)), None)

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
                f"{preposition(places[0])} {_a(places[0])}" if places else "nowhere in particular"
            )
            wanted = _wanted(goal, name, failure.carried)
            return _sentence(f"the {_word(name)} was left {where} at step {step}, not {wanted}")
    return _never(failure)


def _wanted(goal: Goal, name: str, carried: str) -> str:
    place = goal.destination if name == carried else goal.movable_receptacle
    return f"{preposition(place)} the {_word(place)}"


def _last_put(record: Record, name: str) -> tuple[int, list[str]] | None:
    """Return the step that last put a thing of this type down, and what it then lay in."""
    last, before = None, record.start
    for step in record.steps:
        held = before.scene.held if before else None
        if held and _base(held.type) == name and step.event.success:
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
            return _sentence(
                f"“{condition.text}” held from step {since} and was lost at step {lost}"
                f" ({failure.skill(lost)})"
            )
    treated = TREATED.get(failure.goal.task_type, "")
    placed, at = failure.since("placed"), failure.since(treated)
    if placed and at and at > placed:
        return _sentence(
            f"it was put in its place at step {placed} and {treated} only at step {at}; it was not"
            " put there again"
        )
    apart = [
        f"“{c.text}” since step {failure.since(c.name)}" for c in failure.conditions if c.holds
    ]
    if not apart:
        return _never(failure)
    last = failure.missing[-1].text
    return _sentence(f"{', '.join(apart)}, but of different things: “{last}” never came true")


def _without_a_step(failure: _Failure) -> str:
    """Return which step was left out before a thing was put where it should be."""
    goal = failure.goal
    treated = TREATED.get(goal.task_type)
    word = _word(failure.carried)
    if goal.sliced and not failure.since("sliced"):
        return _sentence(f"the {_word(goal.object)} was never sliced")
    if treated and failure.since(treated) is None:
        return _sentence(f"the {word} {_brought(failure)}, but never {treated}")
    placed = failure.since("placed") or failure.since("carrier-placed")
    if goal.task_type is TaskType.STACK and failure.since("stacked") is None:
        on = preposition(goal.movable_receptacle)
        thing = _word(goal.object)
        if placed:
            return _sentence(
                f"the {word} was put in its place at step {placed} without the {thing} {on} it"
            )
        return _sentence(f"the {thing} was never put {on} the {word}")
    return _never(failure)


def _brought(failure: _Failure) -> str:
    """Return how what was to be carried came to its place, or that it did not."""
    goal, start = failure.goal, failure.record.start
    where = f"{preposition(goal.destination)} the {_word(goal.destination)}"
    last = _last_put(failure.record, failure.carried)
    if last and {goal.destination, f"{goal.destination}Basin"} & set(last[1]):
        return f"was put {where} at step {last[0]}"
    if start and _holds(start.goals, "placed") and failure.since("placed") == 1:
        return f"lay {where} from the start"
    return "was carried"


def _again_and_again(failure: _Failure) -> str:
    """Return which skill was refused again and again, and what was still to come true."""
    stuck = _stuck(failure.record)
    if stuck is None:
        return _never(failure)
    return _sentence(
        f"{_refused(*stuck)}; {_still(failure)}" if failure.missing else _refused(*stuck)
    )


def _stuck(record: Record) -> tuple[str, list[Step]] | None:
    """Return the skill that was refused most often without ever working again, and those steps."""
    refused: dict[str, list[Step]] = {}
    for step in record.steps:
        skill = f"“{step.decision.skill.text}”"
        refused[skill] = [] if step.event.success else [*refused.get(skill, []), step]
    meant = record.episode.task.goal.objects

    def telling(item: tuple[str, list[Step]]) -> tuple[int, bool]:
        return len(item[1]), bool(item[1]) and item[1][0].decision.skill.object in meant

    skill, steps = max(refused.items(), key=telling, default=("", []))
    return (skill, steps) if len(steps) >= STUCK else None


def _refused(what: str, steps: list[Step]) -> str:
    """Return that something was refused, how often, from which step on and why at last."""
    why = f": {steps[-1].event.message}" if steps[-1].event.message else ""
    if len(steps) == 1:
        return f"{what} was refused at step {steps[0].number}{why}"
    return f"{what} was refused {_times(len(steps))}, from step {steps[0].number} on{why}"


def _never(failure: _Failure) -> str:
    """Return how it ended, and the first condition that was still to come true."""
    if not failure.missing:
        return _sentence(f"{failure.ended}, and the goal does not hold")
    return _sentence(f"{failure.ended}; {_still(failure)}")


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


# words


def _holds(conditions: tuple[Condition, ...], name: str) -> bool:
    return any(one.name == name and one.holds for one in conditions)


def _does(step: Step, verb: Verb) -> bool:
    return step.decision.skill.verb is verb


def _is(step: Step, verb: Verb, name: str) -> bool:
    return _does(step, verb) and step.decision.skill.object == name


def _base(object_type: str) -> str:
    return object_type.removesuffix("Sliced").removesuffix("Cracked").removesuffix("Basin")


def _word(object_type: str) -> str:
    return in_words(_base(object_type))


def _a(object_type: str) -> str:
    known = names().get(_base(object_type))
    mass = known is not None and known.number == "mass"
    return _word(object_type) if mass else with_article(_word(object_type))


def _times(count: int) -> str:
    return {1: "once", 2: "twice"}.get(count, f"{count} times")


def _sentence(words: str) -> str:
    return words[:1].upper() + words[1:] + ("" if words.endswith((".", "!", "?")) else ".")
