"""Object omission: what was taken instead of what was meant, or why nothing was."""

from reibench.dialogue import ReferringExpression
from reibench.episode import TaskType
from reibench.explanation.words import a, does, is_skill, refused, sentence, stuck_on, word
from reibench.faults import instead
from reibench.rollout import Record
from reibench.skill import PICKABLE, Verb
from reibench.verdict import omitted


def omission(record: Record, missing: tuple[str, ...]) -> list[str]:
    """Return what was taken instead of what was meant, or why nothing was."""
    goal = record.episode.task.goal
    lamps = [
        name for name in missing if goal.task_type is TaskType.EXAMINE and name not in PICKABLE
    ]
    things = [name for name in missing if name not in lamps]
    parts = []
    if things:
        parts.append(_missed(record, things[0]))
        parts += [f"No {word(name)} was picked up either." for name in things[1:]]
    elif lamps:
        parts.append(_unlit(record, lamps[0]))
    return parts


def _missed(record: Record, name: str) -> str:
    """Return why a thing was not picked up."""
    said, other = expression_for(record, name), instead(record)
    vague = said is not None and not said.explicit
    tries = [s for s in record.steps if is_skill(s, Verb.PICK_UP, name) and not s.event.success]
    if tries:
        said_no = refused(f"picking up the {word(name)}", tries)
        more = f"; it went for {a(other[0])} at step {other[1]}" if other else ""
        return sentence(said_no + more)
    if other and said and vague:
        taken, step = other
        return sentence(
            f"“{said.text}” was taken for {a(taken)} at step {step}; it means the {word(name)}"
        )
    if other:
        return f"At step {other[1]} it went for {a(other[0])}, not the {word(name)}."
    picked = any(does(s, Verb.PICK_UP) and s.event.success for s in record.steps)
    found = next(
        (s.number for s in record.steps if is_skill(s, Verb.FIND, name) and s.event.success), 0
    )
    if said and vague:
        meant = f"“{said.text}” means the {word(name)}, but none was ever picked up"
    else:
        meant = f"no {word(name)} was ever picked up"
    if found:
        meant += f", though it was found at step {found}"
    elif not picked:
        meant += ", nor was anything else"
    stuck = stuck_on(record)
    return sentence(f"{meant}; {refused(*stuck)}" if stuck else meant)


def taken(record: Record) -> str:
    """Return the type of what was taken for the object that was meant: it, another, or nothing."""
    meant = record.episode.task.goal.object
    if meant not in omitted(record):
        return meant
    other = instead(record)
    return other[0] if other else ""


def _unlit(record: Record, lamp: str) -> str:
    tries = [s for s in record.steps if is_skill(s, Verb.TURN_ON, lamp) and not s.event.success]
    if tries:
        return sentence(refused(f"turning on the {word(lamp)}", tries))
    words = f"the {word(record.episode.task.goal.object)} was picked up, but no {word(lamp)}"
    words += " was turned on"
    other = next((s for s in record.steps if does(s, Verb.TURN_ON) and s.event.success), None)
    if other:
        words += f"; {a(other.decision.skill.object)} was, at step {other.number}"
    return sentence(words)


def expression_for(record: Record, name: str) -> ReferringExpression | None:
    """Return the expression that means a thing: of the instruction, or else the latest before."""
    for utterance in reversed(record.episode.dialogue.utterances):
        found = [one for one in utterance.expressions if one.referent == name]
        if found:
            vague = [one for one in found if not one.explicit]
            return (vague or found)[0]
    return None
