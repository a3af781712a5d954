"""What lists call an episode: its goal in one line, said clearly."""

from typing import Any

from reibench.dataset.files import episode_from_json
from reibench.episode import Goal, TaskType
from reibench.goals import preposition
from reibench.skill import in_words, with_article

_TREATED = {TaskType.HEAT: "heated", TaskType.COOL: "chilled", TaskType.CLEAN: "clean"}


def title(goal: Goal) -> str:
    """Return a goal as a clear request, e.g. `Put a heated tomato in the fridge`."""
    thing = in_words(goal.object)
    if goal.sliced:
        thing = f"sliced {thing}"
    if goal.task_type is TaskType.EXAMINE:
        return f"Look at {with_article(thing)} under the {in_words(goal.destination)}"
    treated = _TREATED.get(goal.task_type)
    what = with_article(f"{treated} {thing}" if treated else thing)
    if goal.movable_receptacle:
        holder = with_article(in_words(goal.movable_receptacle))
        what = f"{holder} with {what} {preposition(goal.movable_receptacle)} it"
    return f"Put {what} {preposition(goal.destination)} the {in_words(goal.destination)}"


def told(episode: dict[str, Any]) -> tuple[str, str, str]:
    """Return title, meant object and all words, in lower case, of an episode as it is kept."""
    read = episode_from_json(episode)
    goal = read.task.goal
    objects = map(in_words, filter(None, (goal.object, goal.destination, goal.movable_receptacle)))
    turns = (utterance.text for utterance in read.dialogue.utterances)
    return title(goal), goal.object, " ".join([read.id, title(goal), *objects, *turns]).lower()
