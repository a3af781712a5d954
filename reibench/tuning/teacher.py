"""The teacher: knows the goal, but acts on nothing except what the learner is told too.

The expert looks into closed cupboards; a learner that reads only messages cannot imitate that. The
teacher tries, reads why something failed, and does what was missing, so that each of its steps
follows from the words before it.
"""

import re
from collections.abc import Generator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

from reibench.episode import Goal, TaskType
from reibench.planners import Decision, Plan
from reibench.skill import FINDABLE, OPENABLE, Skill, Verb, in_words
from reibench.worlds import Event

Moves: TypeAlias = Generator[Skill, Event, bool]
"""Yields skills, is sent their events, and returns whether it got what it wanted."""
KNIFE = "Knife"
TRIES = 4
"""How often the teacher mends one thing before it gives up."""
SHUT = ("Cabinet", "Drawer", "Fridge", "Microwave", "Safe")
"""What is opened before something is put in, since it is usually shut."""
ASIDE = ("CounterTop", "DiningTable", "SideTable", "CoffeeTable", "Desk", "Dresser", "Bed")
"""Where to leave what is in the hand and not wanted."""
_NAMES = {in_words(name): name for name in FINDABLE} | {name.lower(): name for name in FINDABLE}
_HOLDER = re.compile(r"(?:is in|because it is in) (?:the )?(?P<name>[A-Za-z ]+?)(?:, which|$)")
_SHUT = re.compile(r"^the (?P<name>[A-Za-z ]+) is closed$")
_HELD = re.compile(r"(?:already holding|currently holding) (?:the )?(?P<name>[A-Za-z ]+)$")


@dataclass(frozen=True)
class Wish:
    """A goal, and what its words may mean where they do not decide."""

    goal: Goal
    meanings: Mapping[str, Sequence[str]] = field(default_factory=dict)
    """By object type: the types its word could stand for, in the order in which to try them."""

    def types(self, name: str) -> Sequence[str]:
        """Return what to look for when `name` is asked for."""
        if name == KNIFE:
            return (KNIFE, "ButterKnife")
        return self.meanings.get(name, (name,))


class Teacher:
    """Carry out a wish, one step after another, by what the messages say."""

    def __init__(self, wish: Wish) -> None:
        self._wish = wish

    def plan(self, instruction: object, start: Event, skills: Sequence[Skill]) -> Plan:
        """Plan without a look at any scene."""
        moves = self._solve()
        skill = next(moves, None)
        while skill is not None:
            event = yield Decision(skill)
            try:
                skill = moves.send(event)
            except StopIteration:
                break
        return None

    def _solve(self) -> Moves:
        goal = self._wish.goal
        if goal.sliced and not (yield from self._cut(goal.object)):
            return False
        if not (yield from self._fetch(goal.object)):
            return False
        if goal.task_type is TaskType.EXAMINE:
            return (yield from self._light(goal.destination))
        if goal.task_type in TREATMENTS:
            if not (yield from self._treat(goal)):
                return False
        elif goal.task_type is TaskType.STACK:
            yield from self._put(goal.object, goal.movable_receptacle)
            if not (yield from self._take(goal.movable_receptacle)):
                return False
        return (yield from self._put(goal.movable_receptacle or goal.object, goal.destination))

    def _fetch(self, name: str) -> Moves:
        if (yield from self._find(name)) is None:
            return False
        return (yield from self._take(name))

    def _find(self, name: str) -> Generator[Skill, Event, str | None]:
        """Go to what `name` may mean, and return which of its meanings is there."""
        for meaning in self._wish.types(name):
            event = yield Skill(Verb.FIND, meaning)
            if event.success:
                return meaning
        return None

    def _take(self, name: str) -> Moves:
        """Pick up what was gone to; open what it is in, empty the hand, go there again."""
        for _ in range(TRIES):
            event = yield Skill(Verb.PICK_UP, name)
            if event.success:
                return True
            held = _named(_HELD, event.message)
            if held == name:
                return True
            if held:
                yield from self._put_aside(held)
                yield Skill(Verb.FIND, name)
                continue
            holder = _named(_HOLDER, event.message)
            if holder in OPENABLE:
                yield Skill(Verb.OPEN, holder)
            else:
                yield Skill(Verb.FIND, name)
        return False

    def _put_aside(self, held: str) -> Moves:
        for place in ASIDE:
            event = yield Skill(Verb.FIND, place)
            if event.success:
                event = yield Skill(Verb.PUT_DOWN, held)
                return event.success
        return False

    def _put(self, name: str, place: str) -> Moves:
        """Go to a place and put there what is in the hand; mend what stands in the way."""
        found = yield from self._find(place)
        if found is None:
            return False
        if found in SHUT:
            yield Skill(Verb.OPEN, found)
        for _ in range(TRIES):
            event = yield Skill(Verb.PUT_DOWN, name)
            if event.success:
                return True
            shut = _named(_SHUT, event.message)
            if shut in OPENABLE:  # what was gone to, or what that is in: a plate in a cabinet
                yield Skill(Verb.OPEN, shut)
                continue
            # under the official rules what could not be put down lies on the floor
            lost = "not holding any" in event.message or event.message == "put down failed"
            if lost and not (yield from self._fetch(name)):
                return False
            yield Skill(Verb.FIND, found)
            if found in SHUT:
                yield Skill(Verb.OPEN, found)
        return False

    def _treat(self, goal: Goal) -> Moves:
        place, verbs = TREATMENTS[goal.task_type]
        if not (yield from self._put(goal.object, place)):
            return False
        for skill in verbs:
            event = yield skill
            if not event.success and "not in reach" in event.message:
                yield Skill(Verb.FIND, skill.object)
                yield skill
        return (yield from self._take(goal.object))

    def _cut(self, name: str) -> Moves:
        knife = yield from self._find(KNIFE)
        if knife is None or not (yield from self._take(knife)):
            return False
        yield Skill(Verb.FIND, name)
        for _ in range(TRIES):
            event = yield Skill(Verb.SLICE, name)
            if event.success:
                return (yield from self._put_aside(knife))
            holder = _named(_HOLDER, event.message)
            yield Skill(Verb.OPEN, holder) if holder in OPENABLE else Skill(Verb.FIND, name)
        return False

    def _light(self, lamp: str) -> Moves:
        found = yield from self._find(lamp)
        if found is None:
            return False
        event = yield Skill(Verb.TURN_ON, found)
        return event.success or "already on" in event.message


TREATMENTS = {
    TaskType.HEAT: (
        "Microwave",
        (
            Skill(Verb.CLOSE, "Microwave"),
            Skill(Verb.TURN_ON, "Microwave"),
            Skill(Verb.TURN_OFF, "Microwave"),
            Skill(Verb.OPEN, "Microwave"),
        ),
    ),
    TaskType.COOL: ("Fridge", (Skill(Verb.CLOSE, "Fridge"), Skill(Verb.OPEN, "Fridge"))),
    TaskType.CLEAN: ("Sink", (Skill(Verb.TURN_ON, "Faucet"), Skill(Verb.TURN_OFF, "Faucet"))),
}
"""Where a thing is treated and what is done there, while it lies there."""


def _named(pattern: re.Pattern[str], message: str) -> str:
    """Return the object type that a message names, or nothing."""
    found = pattern.search(message)
    return _NAMES.get(found["name"].strip().lower(), "") if found else ""
