"""A memory bank: what a robot that reads only text knows of the room and of its own doings.

Entries are written and read by rules, from skills, whether they worked, and the feedback if not.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

from reibench.skill import Skill, Verb, in_words

MOST_FAILURES = 3
"""Failures remembered: the latest."""
INSIDE = re.compile(r"^(?:the )?(.+?) is (?:not visible because it is )?in (?:the )?([\w ]+)")
ABSENT = re.compile(r"^there is no (.+) in this room|^Cannot find (\w+)$")
HOLDING = re.compile(r"^the robot is (?:already )?holding the ([\w ]+)|currently holding (\w+)")
SHUT = re.compile(r"^the (.+) is closed$")


@dataclass
class MemoryBank:
    """What is known now; lists keep the order in which things came to be known."""

    holding: str = ""
    at: str = ""
    """What the robot went to last."""
    opened: list[str] = field(default_factory=list)
    running: list[str] = field(default_factory=list)
    places: dict[str, str] = field(default_factory=dict)
    """Where things are, as far as the robot put them or was told."""
    absent: list[str] = field(default_factory=list)
    failures: dict[str, str] = field(default_factory=dict)
    """Skills that failed and have not worked since, with the feedback."""
    finished: list[str] = field(default_factory=list)
    """Sub-goals that are done."""

    def write(self, skill: Skill, *, success: bool, message: str = "") -> None:
        """Note what came of `skill`."""
        if success:
            self.failures.pop(skill.text, None)
            self._worked(skill.verb, in_words(skill.object))
        else:
            self.failures.pop(skill.text, None)
            self.failures[skill.text] = message
            self._heard(message)

    def finish(self, subgoal: str) -> None:
        """Note that a sub-goal is done; failures on the way to it no longer matter."""
        self.finished.append(subgoal)
        self.failures.clear()

    def entries(self) -> tuple[tuple[str, str], ...]:
        """Return what is worth telling, as pairs of a heading and words."""
        failures = list(self.failures.items())[-MOST_FAILURES:]
        told = (
            ("holding", f"the {self.holding}" if self.holding else "nothing"),
            ("at", f"the {self.at}" if self.at else "no place yet"),
            ("open", ", ".join(f"the {each}" for each in self.opened)),
            ("on", ", ".join(f"the {each}" for each in self.running)),
            ("seen", ", ".join(f"the {thing} {where}" for thing, where in self.places.items())),
            ("not here", ", ".join(self.absent)),
            ("failed", "; ".join(f"{skill} ({why})" for skill, why in failures)),
            ("finished", "; ".join(self.finished)),
        )
        return tuple((heading, words) for heading, words in told if words)

    def _worked(self, verb: Verb, name: str) -> None:
        match verb:
            case Verb.FIND:
                self.at = name
            case Verb.PICK_UP:
                self.holding = name
                self.places.pop(name, None)
            case Verb.PUT_DOWN:
                self.holding = ""
                if self.at and self.at != name:
                    self.places[name] = f"at the {self.at}"
            case Verb.OPEN:
                _add(self.opened, name)
            case Verb.CLOSE:
                _remove(self.opened, name)
            case Verb.TURN_ON:
                _add(self.running, name)
            case Verb.TURN_OFF:
                _remove(self.running, name)
            case Verb.SLICE:
                self.places[name] = "sliced"

    def _heard(self, message: str) -> None:
        if found := INSIDE.match(message):
            thing, where = _spoken(found[1]), _spoken(found[2])
            if where == "robot":  # "the apple is in the robot's hand"
                self.holding = thing
            else:
                self.places[thing] = f"in the {where}"
                _remove(self.opened, where)
        if found := SHUT.match(message):
            _remove(self.opened, found[1])
        for name in said_absent(message):
            _add(self.absent, name)
        if found := HOLDING.search(message):
            self.holding = _spoken(found[1] or found[2])
        elif "not holding any" in message:
            self.holding = ""


def said_absent(message: str) -> Iterator[str]:
    """Yield the name, in words, of what feedback says is not in the room, if it says so."""
    if found := ABSENT.match(message):
        yield _spoken(found[1] or found[2])


def _add(names: list[str], name: str) -> None:
    if name not in names:
        names.append(name)


def _remove(names: list[str], name: str) -> None:
    if name in names:
        names.remove(name)


def _spoken(name: str) -> str:
    """Return a name in words, as the official feedback gives object types."""
    return in_words(name) if name[:1].isupper() and name != "CD" else name
