"""Checking episodes: spans, the nine levels' counting rule, and that the room fits the task."""

from collections.abc import Iterable, Iterator, Sequence

from reibench.dataset.check_words import word_problems, words_of
from reibench.dataset.forms import says
from reibench.dialogue import EXPLICIT_ALONE, ReferringExpression, Utterance
from reibench.episode import Episode, TaskType
from reibench.errors import ReibenchError
from reibench.household import Room, load_room
from reibench.household.objects import object_type

TURNS = ("human", "robot") * 3 + ("human",)
LEAST_WORDS = 20
"""In each turn before the instruction, of the standard context (appendix B.1)."""
NOISE_MENTIONS = 3
"""How often the ambiguous name stands in a noised or short context (appendix B.2)."""


def problems(episode: Episode) -> list[str]:
    """Return everything wrong with `episode`, one sentence each; an empty list if it is sound."""
    if episode.vagueness == EXPLICIT_ALONE:
        # people's own words, not made to any rule, and not marked
        return [*_alone_problems(episode), *_span_problems(episode), *_room_problems(episode)]
    return [
        *_turn_problems(episode),
        *_span_problems(episode),
        *_level_problems(episode),
        *word_problems(episode),
        *_room_problems(episode),
        *_candidate_problems(episode),
    ]


def _alone_problems(episode: Episode) -> Iterator[str]:
    if [utterance.speaker for utterance in episode.dialogue.utterances] != ["human"]:
        yield "an instruction alone is one utterance, and the human's"


def _turn_problems(episode: Episode) -> Iterator[str]:
    utterances = episode.dialogue.utterances
    speakers = tuple(utterance.speaker for utterance in utterances)
    if speakers != TURNS:
        yield "the turns must be human and robot, three times each, and the human's instruction"
    if episode.vagueness.context == "standard":
        for number, utterance in enumerate(episode.dialogue.context, start=1):
            words = len(utterance.text.split())
            if words < LEAST_WORDS:
                yield f"turn {number} has {words} words; it needs {LEAST_WORDS} (appendix B.1)"


def _candidate_problems(episode: Episode) -> Iterator[str]:
    goal, left = episode.task.goal, episode.candidates
    if left and left[0] not in (goal.object, goal.movable_receptacle):
        yield f"the first candidate is {left[0]}, not what is meant"
    if episode.underdetermined != (len(left) > 1):
        marked = "underdetermined" if episode.underdetermined else "not underdetermined"
        yield f"it is marked {marked}, but has {len(left)} candidates"


def _span_problems(episode: Episode) -> Iterator[str]:
    utterances = episode.dialogue.utterances
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
            if expression.explicit == (expression.form in ("pronoun", "attributive")):
                kind = "explicit" if expression.explicit else "implicit"
                yield f"{expression.text!r} is marked {kind}, but as {expression.form}"


def _mentions(utterances: Iterable[Utterance], referent: str) -> Iterator[ReferringExpression]:
    return (e for u in utterances for e in u.expressions if referent in e.referent.split("+"))


def _counts(utterances: Iterable[Utterance], referent: str) -> tuple[int, int]:
    """Count the explicit and implicit expressions for `referent`."""
    marks = list(_mentions(utterances, referent))
    explicit = sum(mark.explicit for mark in marks)
    return explicit, len(marks) - explicit


def _level_problems(episode: Episode) -> Iterator[str]:
    """Apply the counting rule (appendix B.4; its table's swapped headers read as they must be)."""
    level = episode.vagueness
    for referent in _counted(episode):
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
        if level.reference == "implicit" and level.context != "short":
            first = next((e for e in _mentions(episode.dialogue.context, referent)), None)
            if first and not first.explicit:
                yield f"the first mention of the {referent}, {first.text!r}, must name it"
    yield from _noise_problems(episode)


def _context_problem(reference: str, short: bool, counts: tuple[int, int]) -> str:
    """Say which counts of named and unnamed mentions the context needs, if these are wrong.

    In short contexts the rule held before removal; what must still hold is weaker.
    """
    named, unnamed = counts
    if reference == "implicit":
        if short:
            return "needs no named mention" if named else ""
        return "" if named == 1 and unnamed >= 2 else "needs 1 named and 2 unnamed mentions"
    least = 1 if short else 3
    return "" if named >= least and not unnamed else f"needs {least} named and 0 unnamed mentions"


def _noise_problems(episode: Episode) -> Iterator[str]:
    noise = [e for u in episode.dialogue.context for e in u.expressions if e.is_noise]
    wanted = 0 if episode.vagueness.context == "standard" else NOISE_MENTIONS
    if len(noise) != wanted:
        yield f"the ambiguous name stands {len(noise)} times in the context, not {wanted}"
    if len({each.referent for each in noise}) > 1:
        yield "more than one ambiguous name is used"
    for utterance in episode.dialogue.utterances:
        spoken = [mark for mark in utterance.expressions if mark.is_noise]
        if spoken and (utterance.speaker == "robot" or utterance is episode.dialogue.instruction):
            yield f"{spoken[0].text!r} belongs into the human's turns of the context"
    words = [word for name in _counted(episode) for word in words_of(name)]
    for text in dict.fromkeys(mark.text for mark in noise):
        if any(says(text, word) for word in words):
            yield f"the ambiguous name {text!r} gives the task object away"


def _counted(episode: Episode) -> tuple[str, ...]:
    goal = episode.task.goal
    return tuple(filter(None, (goal.object, goal.movable_receptacle)))


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
