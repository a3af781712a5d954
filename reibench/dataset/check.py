"""Checking episodes: spans, the nine levels' counting rule, and that the room fits the task."""

from collections.abc import Iterable, Iterator, Sequence

from reibench.dialogue import EXPLICIT_ALONE, ReferringExpression, Utterance
from reibench.episode import Episode, TaskType
from reibench.errors import ReibenchError
from reibench.household import Room, load_room
from reibench.household.objects import object_type

NOISE_MENTIONS = 3
"""How often the ambiguous name stands in a noised or short context (appendix B.2)."""


def problems(episode: Episode) -> list[str]:
    """Return everything wrong with `episode`, one sentence each; an empty list if it is sound."""
    return [*_span_problems(episode), *_level_problems(episode), *_room_problems(episode)]


def _span_problems(episode: Episode) -> Iterator[str]:
    utterances = episode.dialogue.utterances
    if not utterances or utterances[-1].speaker != "human":
        yield "the last utterance must be the human's instruction"
    for number, utterance in enumerate(utterances, start=1):
        if not utterance.text.strip():
            yield f"utterance {number} is empty"
        end = 0
        for expression in utterance.expressions:
            if not end <= expression.start < expression.end <= len(utterance.text):
                yield (
                    f"utterance {number}: the span {expression.start}–{expression.end} does not"
                    f" fit its {len(utterance.text)} characters or overlaps the one before"
                )
            end = max(end, expression.end)


def _counts(utterances: Iterable[Utterance], referent: str) -> tuple[int, int]:
    """Count the explicit and implicit expressions for `referent`."""
    marks = [e for u in utterances for e in u.expressions if referent in e.referent.split("+")]
    explicit = sum(mark.explicit for mark in marks)
    return explicit, len(marks) - explicit


def _level_problems(episode: Episode) -> Iterator[str]:
    """Apply the counting rule (appendix B.4; its table's swapped headers read as they must be)."""
    goal, level = episode.task.goal, episode.vagueness
    if level == EXPLICIT_ALONE:
        return  # people's own words, not made to any rule, and not marked
    for referent in filter(None, (goal.object, goal.movable_receptacle)):
        before, after = (
            _counts(episode.dialogue.context, referent),
            _counts([episode.dialogue.instruction], referent),
        )
        named, unnamed = after
        if level.reference == "explicit" and (named < 1 or unnamed):
            yield f"the instruction must name the {referent} and not paraphrase it"
        if level.reference != "explicit" and (named or unnamed < 1):
            yield f"the instruction must mention the {referent} without naming it"
        if complaint := _context_problem(level.reference, level.context == "short", before):
            yield f"the context {complaint} for the {referent}, but has {before[0]} and {before[1]}"
    yield from _noise_problems(episode)


def _context_problem(reference: str, short: bool, counts: tuple[int, int]) -> str:
    """Say which counts of named and unnamed mentions the context needs, if these are wrong.

    In short contexts the rule held before removal; what must still hold is weaker.
    """
    named, unnamed = counts
    if reference == "implicit":
        if short:
            return "needs no named mention" if named else ""
        return "" if named >= 1 and unnamed >= 2 else "needs 1 named and 2 unnamed mentions"
    least = 1 if short else 3
    return "" if named >= least and not unnamed else f"needs {least} named and 0 unnamed mentions"


def _noise_problems(episode: Episode) -> Iterator[str]:
    noise = [e for u in episode.dialogue.context for e in u.expressions if e.is_noise]
    wanted = 0 if episode.vagueness.context == "standard" else NOISE_MENTIONS
    if len(noise) != wanted:
        yield f"the ambiguous name stands {len(noise)} times in the context, not {wanted}"
    if len({_name(each) for each in noise}) > 1:
        yield "more than one ambiguous name is used"


def _name(expression: ReferringExpression) -> str:
    return expression.referent


def _room_problems(episode: Episode) -> Iterator[str]:
    goal = episode.task.goal
    try:
        room = load_room(episode.task.setup.room)
    except ReibenchError as problem:
        yield str(problem).rstrip(".")
        return
    types = {thing.type for thing in room.objects}
    needed = [goal.object, goal.destination, *filter(None, [goal.movable_receptacle])]
    for name in [*needed, *episode.candidates]:
        try:
            object_type(name)
        except ReibenchError as problem:
            yield str(problem).rstrip(".")
        else:
            if name not in types:
                yield f"the room {room.name} has no {name}"
    yield from _placing_problems(episode, room)


def _placing_problems(episode: Episode, room: Room) -> Iterator[str]:
    goal = episode.task.goal
    carried = goal.movable_receptacle or goal.object
    if goal.task_type is not TaskType.EXAMINE and not object_type(carried).belongs(
        goal.destination
    ):
        yield f"a {carried} may not be put in or on a {goal.destination}"
    if goal.movable_receptacle and not object_type(goal.object).belongs(goal.movable_receptacle):
        yield f"a {goal.object} may not be put in a {goal.movable_receptacle}"
    ids = {thing.id for thing in room.objects}
    for placement in episode.task.setup.placements:
        for object_id in (placement.object_id, placement.receptacle_id):
            if object_id not in ids:
                yield f"the room {room.name} has no object {object_id}"


def disagreeing_tasks(episodes: Sequence[Episode]) -> list[str]:
    """Return a sentence for each task id that stands for two different tasks."""
    seen = {episode.task.id: episode.task for episode in reversed(episodes)}
    return [
        f"{episode.id} disagrees with {episode.task.id}'s other episodes about the task"
        for episode in episodes
        if episode.task != seen[episode.task.id]
    ]
