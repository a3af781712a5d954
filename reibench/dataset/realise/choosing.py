"""Choosing what is said: parts that follow each other, in somebody's mouth."""

import re
from dataclasses import replace
from random import Random

from reibench.dataset.forms import names, says
from reibench.dataset.realise.nouns import Name, ambiguous_names
from reibench.dataset.realise.parts import Part, Role, parts
from reibench.dataset.seeds import kind_of
from reibench.episode import Goal, TaskType

_BASINS = ("Sink", "SinkBasin", "Bathtub", "BathtubBasin")
_UNEXPECTED = {
    TaskType.HEAT: ("Fridge", *_BASINS),
    TaskType.COOL: ("Microwave", *_BASINS),
    TaskType.CLEAN: _BASINS,
}
"""Where nobody expects a thing after its treatment."""
LEAST_WORDS = 20
"""In each turn of the context (appendix B.1)."""
WORKING_AGE = (18, 65)
"""Who has colleagues."""
NOISE = 3
"""Sentences with the ambiguous name (appendix B.2)."""


class Chooser:
    """Chooses parts, names and noise for a goal; keeps what suits each."""

    def __init__(self) -> None:
        self._pools: dict[tuple[Role, str, Goal], tuple[Part, ...]] = {}

    def parts_for(self, goal: Goal, choose: Random) -> list[Part] | None:
        """Choose an opening and what follows it; None when its speaker has nothing to say."""
        opening = choose.choice(self._pool("opening", "", goal))
        age = age_of(opening)
        roles: tuple[Role, ...] = ("intro", "advice", "exchange", "plan", "place", "request")
        least = {
            "intro": LEAST_WORDS - opening.words(0),
            "advice": LEAST_WORDS - opening.words(1),
        }
        chosen = [opening]
        for role in roles:
            pool = [
                part
                for part in self._pool(role, kind_of(goal.object), goal)
                if part.least_age <= age and part.words() >= least.get(role, 0)
            ]
            if not pool:
                return None
            chosen.append(choose.choice(pool))
        return chosen

    def noise_for(self, goal: Goal, name: Name, age: int, choose: Random) -> list[str]:
        """Choose three sentences with the name; none where so few suit the speaker's age."""
        suited = [p for p in self._pool("noise", name.category, goal) if p.least_age <= age]
        if len(suited) < NOISE:
            return []
        return [part.text.replace("{name}", name.text) for part in choose.sample(suited, NOISE)]

    def _pool(self, role: Role, kind: str, goal: Goal) -> tuple[Part, ...]:
        """Return the parts that may be used, which give away none of the task objects."""
        key = (role, kind, replace(goal, destination=_setting(goal)))
        if key not in self._pools:
            words = [word for name in counted(goal) for word in names()[name].words]
            mine = [
                part
                for part in parts()
                if part.role == role
                and goal.task_type in part.tasks
                and not any(says(part.text, word) for word in words)
            ]
            setting = "sliced" if goal.sliced and role == "request" else _setting(goal)
            special = [part for part in mine if setting in part.kinds]
            self._pools[key] = tuple(
                special
                or (part for part in mine if not part.kinds or part.kinds & {kind, goal.object})
            )
        return self._pools[key]


def counted(goal: Goal) -> tuple[str, ...]:
    """Return the task objects whose mentions are counted."""
    return tuple(filter(None, (goal.object, goal.movable_receptacle)))


def age_of(opening: Part) -> int:
    """Return the age of who speaks, at the least: 70 for `retired postman, 70s`."""
    return int(re.findall(r"\d+", opening.who)[-1])


def name_for(goal: Goal, present: frozenset[str], choose: Random, age: int) -> Name | None:
    """Choose an ambiguous name that looks like something there, but not like a task object."""
    words = [word for name in counted(goal) for word in names()[name].words]
    works = WORKING_AGE[0] <= age < WORKING_AGE[1]
    there = present - {*counted(goal), goal.destination}
    fitting = [
        name
        for name in ambiguous_names()
        if name.decoy in there
        and (works or name.category != "colleague")
        and not any(says(name.text, word) for word in words)
    ]
    return choose.choice(fitting) if fitting else None


def _setting(goal: Goal) -> str:
    """Return which setting a goal is in, where it is in any."""
    if goal.destination == "GarbageCan":
        return "bin"
    return "odd" if goal.destination in _UNEXPECTED.get(goal.task_type, ()) else ""
