"""Seed instructions: a task, and the clear sentence that asks for it."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from reibench.dataset.forms import names
from reibench.dataset.grammar import article
from reibench.dataset.realise.nouns import nouns, place_words
from reibench.dataset.scripts import parse_goal
from reibench.dataset.seeds import Seed
from reibench.episode import Goal, SceneSetup, Task, TaskType
from reibench.errors import InvalidEpisode, ReibenchError
from reibench.goals import preposition
from reibench.household import load_room

_LINE = re.compile(r"([^|]+)\|\s*([^,|]+?)\s*(?:,\s*(\d+))?\s*(?:\|(.+))?")


@dataclass(frozen=True)
class SeedInstruction:
    """A seed task as somebody would put it who names everything."""

    task: Task
    present: tuple[str, ...]
    """The object types of the room."""
    text: str

    @property
    def counted(self) -> tuple[str, ...]:
        """The types whose mentions are counted."""
        goal = self.task.goal
        return tuple(filter(None, (goal.object, goal.movable_receptacle)))


def in_a_sentence(seed: Seed) -> SeedInstruction:
    """Return a seed task in one plain sentence, as annotators write them."""
    return SeedInstruction(seed.task, seed.present, plainly(seed.task.goal))


def plainly(goal: Goal) -> str:
    """Return what a goal asks for in one plain sentence."""
    thing = nouns()[goal.object][0].later[0]
    number = names()[goal.object].number
    a_thing = f"{article(thing)} {thing}" if number == "count" else thing
    place = place_words(goal.destination)
    where = f"{preposition(goal.destination)} the {place}"
    if goal.task_type is TaskType.EXAMINE:
        return f"Pick up {a_thing} and turn on the {place}."
    if goal.task_type is TaskType.STACK:
        holder = nouns()[goal.movable_receptacle][0].later[0]
        inside = f"{preposition(goal.movable_receptacle)} {article(holder)} {holder}"
        return f"Put {a_thing} {inside} and put the {holder} {where}."
    treated = {TaskType.HEAT: "Heat", TaskType.COOL: "Chill", TaskType.CLEAN: "Wash"}
    verb = treated.get(goal.task_type)
    if verb:
        return f"{verb} the {thing} and put the {thing} {where}."
    return f"Put {a_thing} {where}."


def read_seeds(path: Path) -> Iterator[SeedInstruction]:
    """Yield the seeds of a file, one a line: `heat Potato > DiningTable | kitchen-2, 4 | Heat …`.

    The sentence may be missing; the number, which decides where the robot starts, too.

    Raises:
        InvalidEpisode: naming the line that is wrong.
    """
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as problem:
        raise InvalidEpisode(f"The seed file {path} cannot be read: {problem}.") from problem
    for number, line in enumerate(lines, start=1):
        if line.strip() and not line.startswith("#"):
            try:
                yield _read(line, f"{path.stem}_{number}")
            except (ValueError, ReibenchError) as problem:
                raise InvalidEpisode(f"{path}, line {number}: {problem}") from problem


def _read(line: str, name: str) -> SeedInstruction:
    found = _LINE.fullmatch(line.strip())
    if found is None:
        raise ValueError(f"{line!r} is not like 'heat Potato > DiningTable | kitchen-2, 4'.")
    goal = parse_goal(found[1].strip())
    room = load_room(found[2])
    task = Task(name, SceneSetup(room.name, int(found[3] or 0)), goal)
    present = tuple(sorted({thing.type for thing in room.objects}))
    return SeedInstruction(task, present, (found[4] or plainly(goal)).strip())
