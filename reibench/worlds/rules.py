"""Strict and official rules, and all that differs between them.

`strict` is what the skills mean; `official` repeats the published evaluation (REI-Bench
`tasks.py` and `thor_connector.py`, after LoTA-Bench and ALFRED) for comparison with published
numbers, without its crashes. Nothing outside this module asks which rules apply.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import StrEnum

from reibench.errors import unknown
from reibench.goals import Matches
from reibench.scene import SceneObject
from reibench.skill import Skill, Verb, in_words


class Reason(StrEnum):
    """Why a skill is refused."""

    ABSENT = "absent"
    UNREACHABLE = "unreachable"
    HAND_FULL = "hand full"
    HAND_EMPTY = "hand empty"
    OTHER_HELD = "something else held"
    ALREADY_HELD = "already held"
    ENCLOSED = "enclosed"
    OUT_OF_REACH = "out of reach"
    NO_PLACE = "no place"
    NOT_A_PLACE = "not a place"
    CLOSED = "closed"
    NO_ROOM = "no room"
    NOT_ALLOWED = "not allowed"
    ALREADY_SO = "already so"
    MUST_BE_SHUT = "must be shut"
    IS_RUNNING = "is running"
    NO_KNIFE = "no knife"
    DROPPED = "dropped"
    SIMULATOR = "simulator"


@dataclass
class Refused(Exception):
    """A skill cannot be done; becomes an event, never an error."""

    reason: Reason
    thing: SceneObject | None = None
    """What stands in the way: what is held, the closed container, the place."""
    detail: str = ""


@dataclass(frozen=True)
class Rules:
    """How goals are matched, skills refused and put-downs done."""

    name: str
    matches: Matches
    """Whether an object counts as a wanted type in a goal."""
    say: Callable[[Skill, Refused], str]
    """The feedback for a refused skill."""
    repeated_find_moves_on: bool
    """Whether finding the same type again goes to the next one instead of the nearest again."""
    knife_to_slice: bool
    """Whether slicing needs a knife in hand, as in ALFRED's own executor."""
    noun_decides_put_down: bool
    """Whether `put down the X` needs X in hand."""
    failed_put_down_drops: bool
    """Whether a put-down that fails leaves the thing on the floor."""
    place_forgotten_by: frozenset[Verb] = field(default_factory=frozenset)
    """Verbs after which the robot no longer knows where it last went."""
    places_anything: bool = False
    """Whether anything may be put anywhere, past the lists of what goes where."""
    places_tried: int = 1
    """How many receptacles of the type gone to `put down` tries, nearest first."""


def matches_exactly(thing: SceneObject, wanted: str) -> bool:
    """Whether `thing` is of the wanted type; `Sink` and `Bathtub` stand for their basins too."""
    return thing.type == wanted or thing.type == _BASIN_OF.get(wanted)


def matches_by_substring(thing: SceneObject, wanted: str) -> bool:
    """Whether the object's id contains the wanted name, as ALFRED's `tasks.py` tests it.

    So a pencil is a pen, a butter knife a knife, and a slice of apple an apple.
    """
    return ("Glassbottle" if wanted == "Bottle" else wanted) in thing.id or wanted in thing.id


_BASIN_OF = {"Sink": "SinkBasin", "Bathtub": "BathtubBasin"}

_PRECISE = {
    Reason.ABSENT: "there is no {noun} in this room",
    Reason.UNREACHABLE: "the robot cannot get near the {noun}",
    Reason.HAND_FULL: "the robot is already holding the {thing}",
    Reason.HAND_EMPTY: "the robot is not holding anything",
    Reason.OTHER_HELD: "the robot is holding the {thing}, not the {noun}",
    Reason.ALREADY_HELD: "the {noun} is in the robot's hand",
    Reason.ENCLOSED: "the {noun} is in the {thing}, which is closed",
    Reason.OUT_OF_REACH: "the {noun} is not in reach; find it first",
    Reason.NO_PLACE: "the robot has not gone to a place to put it; find one first",
    Reason.NOT_A_PLACE: "nothing can be put in or on the {thing}",
    Reason.CLOSED: "the {thing} is closed",
    Reason.NO_ROOM: "there is no room left in or on the {thing}",
    Reason.NOT_ALLOWED: "the {noun} does not belong in or on the {thing}",
    Reason.ALREADY_SO: "the {noun} is already {detail}",
    Reason.MUST_BE_SHUT: "the {noun} is open; close it first",
    Reason.IS_RUNNING: "the {noun} is on; turn it off first",
    Reason.NO_KNIFE: "the robot needs a knife in its hand to slice",
    Reason.DROPPED: "the {noun} fell to the floor",
    Reason.SIMULATOR: "that did not work: {detail}",
}


def say_precisely(skill: Skill, refused: Refused) -> str:
    """Say what is wrong, naming what stands in the way."""
    thing = in_words(refused.thing.type) if refused.thing else ""
    noun = in_words(skill.object)
    return _PRECISE[refused.reason].format(noun=noun, thing=thing, detail=refused.detail)


def say_as_published(skill: Skill, refused: Refused) -> str:
    """Say it in the published evaluation's words (facts: LoTA/REI `thor_connector.py`)."""
    name, absent = skill.object, refused.reason is Reason.ABSENT
    if skill.verb is Verb.FIND:
        return f"Cannot find {name}" if absent else f"Cannot move to {name}"
    if skill.verb is Verb.PICK_UP:
        return _pick_up_as_published(name, refused)
    if skill.verb is Verb.PUT_DOWN:
        empty = refused.reason is Reason.HAND_EMPTY
        return "Robot is not holding any object" if empty else "put down failed"
    if absent:
        return f"Cannot find {name} to {skill.verb}"
    return f"{skill.verb.capitalize()} action failed"


def _pick_up_as_published(name: str, refused: Refused) -> str:
    if refused.reason is Reason.ABSENT:
        return f"Cannot find {name} to pick up"
    if refused.reason in (Reason.ENCLOSED, Reason.OUT_OF_REACH) and refused.thing:
        return f"{name} is not visible because it is in {refused.thing.type}"
    if refused.reason in (Reason.HAND_FULL, Reason.ALREADY_HELD) and refused.thing:
        return f"Robot is currently holding {refused.thing.type}"
    # The published text for every other failed pick-up, though the hand is empty.
    return "Robot is not holding any object"


STRICT = Rules(
    name="strict",
    matches=matches_exactly,
    say=say_precisely,
    repeated_find_moves_on=True,
    knife_to_slice=True,
    noun_decides_put_down=True,
    failed_put_down_drops=False,
)
OFFICIAL = Rules(
    name="official",
    matches=matches_by_substring,
    say=say_as_published,
    repeated_find_moves_on=False,
    knife_to_slice=False,
    noun_decides_put_down=False,
    failed_put_down_drops=True,
    place_forgotten_by=frozenset(Verb) - {Verb.FIND, Verb.OPEN, Verb.PUT_DOWN},
    places_anything=True,
    places_tried=2,
)
RULES = {rules.name: rules for rules in (STRICT, OFFICIAL)}


def rules_called(name: str) -> Rules:
    """Return the rules of that name; raises UnknownName."""
    if name not in RULES:
        raise unknown("rules", name, RULES)
    return RULES[name]
