"""Skills: the finite set of things the robot can be told to do, in LoTA-Bench's words."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property, lru_cache

from reibench.errors import UnknownSkill

DONE = "done"
"""The 214th choice: ends the episode, and is no skill."""


class Verb(StrEnum):
    """The eight skill verbs of LoTA-Bench, in its words."""

    FIND = "find"
    PICK_UP = "pick up"
    PUT_DOWN = "put down"
    OPEN = "open"
    CLOSE = "close"
    SLICE = "slice"
    TURN_ON = "turn on"
    TURN_OFF = "turn off"


PICKABLE = tuple(
    "AlarmClock Apple BaseballBat BasketBall Book Bottle Bowl Box Bread ButterKnife CD Candle"
    " CellPhone Cloth CreditCard Cup DishSponge Egg Fork HandTowel Kettle KeyChain Knife Ladle"
    " Laptop Lettuce Mug Newspaper Pan Pen Pencil PepperShaker Pillow Plate Plunger Pot Potato"
    " RemoteControl SaltShaker SoapBar SoapBottle Spatula Spoon SprayBottle Statue TennisRacket"
    " TissueBox ToiletPaper Tomato Vase Watch WateringCan WineBottle".split()
)
OPENABLE = ("Box", "Cabinet", "Drawer", "Fridge", "Laptop", "Microwave", "Safe")
SLICEABLE = ("Apple", "Bread", "Lettuce", "Potato", "Tomato")
TOGGLEABLE = ("DeskLamp", "Faucet", "FloorLamp", "Microwave")
RECEPTACLES = tuple(
    "ArmChair Bathtub Bed Bowl Box Cabinet Cart CoffeeMachine CoffeeTable CounterTop Cup Desk"
    " DiningTable Drawer Dresser Fridge GarbageCan Microwave Mug Ottoman Pan Plate Pot Safe Shelf"
    " SideTable Sink Sofa StoveBurner Toilet ToiletPaperHanger".split()
)
FINDABLE = tuple(
    sorted({*PICKABLE, *OPENABLE, *SLICEABLE, *TOGGLEABLE, *RECEPTACLES}, key=str.lower)
)
OBJECTS_OF = {
    Verb.FIND: FINDABLE,
    Verb.PICK_UP: PICKABLE,
    Verb.PUT_DOWN: PICKABLE,
    Verb.OPEN: OPENABLE,
    Verb.CLOSE: OPENABLE,
    Verb.SLICE: SLICEABLE,
    Verb.TURN_ON: TOGGLEABLE,
    Verb.TURN_OFF: TOGGLEABLE,
}


@lru_cache(maxsize=512)
def in_words(object_type: str) -> str:
    """Return how skills and messages call an object type: `KeyChain` → `key chain`.

    `Bottle` stays `glassbottle`, its name in ALFRED and in the published skill list.
    """
    if object_type in ("CD", "CDs"):
        return object_type
    if object_type == "Bottle":
        return "glassbottle"
    if object_type.startswith("TV"):
        return "TV " + in_words(object_type[2:])
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", object_type).lower()


def with_article(words: str) -> str:
    """Return `words` with `a` or `an` before it."""
    return f"{'an' if words[0].lower() in 'aeiou' else 'a'} {words}"


@dataclass(frozen=True)
class Skill:
    """One verb applied to one object type."""

    verb: Verb
    object: str
    """An object type in AI2-THOR 5's spelling, e.g. `KeyChain`."""

    def __str__(self) -> str:
        return self.text

    @cached_property
    def text(self) -> str:
        """The skill in words, e.g. `find an apple`, `put down the key chain`."""
        words = in_words(self.object)
        return f"{self.verb} {with_article(words) if self.verb is Verb.FIND else f'the {words}'}"


SKILLS = tuple(Skill(verb, name) for verb, names in OBJECTS_OF.items() for name in names)
"""All 213 in one fixed order; with `done` the 214 choices of the published skill list."""

_BY_TEXT = {skill.text.lower(): skill for skill in SKILLS}


def parse_skill(text: str, skills: Sequence[Skill] = SKILLS) -> Skill:
    """Return the skill whose wording is `text`, ignoring case and a final full stop.

    Raises:
        UnknownSkill: when none of `skills` reads like that.
    """
    skill = _BY_TEXT.get(" ".join(text.split()).rstrip(".").lower())
    if skill is None or skill not in skills:
        raise UnknownSkill(
            f"{text!r} is none of the {len(skills)} skills; they read like 'find an apple' or"
            " 'put down the key chain'."
        )
    return skill
