"""Marking: where a text names its things, and what another text says in their place."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from reibench.dataset.build.asking import Unfit
from reibench.dataset.forms import is_plural, names, says
from reibench.dataset.realise.nouns import place_words
from reibench.dataset.scripts import Mention
from reibench.skill import in_words

_DETERMINERS = "the|a|an|my|your|our|his|her|their|this|that|these|those|some|any|another"
_NO_ADJECTIVE = "and|or|of|in|on|to|for|with|from|at|by|is|are|was|were|has|have|as|than|not|but"
_BEFORE = rf"(?:\b(?:{_DETERMINERS})\s+(?:(?!(?:{_NO_ADJECTIVE})\b)[\w'-]+\s+){{0,2}})?"
_SINGULAR = re.compile(r"\b(it|its|this one|that one)\b", re.IGNORECASE)
_PLURAL = re.compile(r"\b(they|them|their|those|these)\b", re.IGNORECASE)


@dataclass(frozen=True)
class Named:
    """A stretch of a text that names something."""

    start: int
    end: int
    text: str
    of: str
    """`object`, `movable` or `destination`."""


def named_mentions(text: str, things: Sequence[tuple[str, str]]) -> list[Named]:
    """Return where `text` names things, in order; a longer name hides a shorter one inside it.

    Args:
        text: what is searched.
        things: pairs of what mentions are of (`object`, `movable`, `destination`) and object type.
    """
    found = [
        Named(match.start(), match.end(), match[0], of)
        for of, name in things
        for match in _pattern(name, of).finditer(text)
    ]
    found.sort(key=lambda each: (each.start, -each.end))
    kept: list[Named] = []
    for each in found:
        if not kept or each.start >= kept[-1].end:
            kept.append(each)
    return kept


@lru_cache(maxsize=512)
def _pattern(name: str, of: str) -> re.Pattern[str]:
    if of == "destination":
        words = {place_words(name), in_words(name), *_OTHER_PLACES.get(name, ())}
    else:
        words = set(names()[name].words)
    either = "|".join(re.escape(word) for word in sorted(words, key=len, reverse=True))
    return re.compile(rf"{_BEFORE}(?<![\w-])(?:{either})(?![\w-])", re.IGNORECASE)


_OTHER_PLACES = {
    "Fridge": ("refrigerator",),
    "CounterTop": ("countertop", "kitchen counter", "counter"),
    "GarbageCan": ("trash can", "garbage can", "bin"),
    "Sofa": ("couch",),
    "ArmChair": ("armchair", "arm chair", "chair", "recliner"),
    "DiningTable": ("table", "dining room table", "kitchen table"),
    "CoffeeTable": ("table",),
    "SideTable": ("table", "end table", "night stand", "nightstand"),
    "FloorLamp": ("lamp", "standing lamp", "light", "lamplight", "lamp light"),
    "DeskLamp": ("lamp", "table lamp", "light", "lamplight", "lamp light"),
    "StoveBurner": ("stove", "burner", "stove top"),
    "Sink": ("basin", "sink basin"),
    "Bathtub": ("bathtub", "bath tub", "tub"),
    "Shelf": ("shelves",),
    "Cabinet": ("cupboard",),
    "Dresser": ("chest of drawers",),
    "Ottoman": ("footstool",),
    "CoffeeMachine": ("coffee maker", "coffeemaker", "coffee pot"),
    "ToiletPaperHanger": ("toilet paper holder", "toilet paper hanger", "toilet paper dispenser"),
    "BathtubBasin": ("bathtub", "bath tub", "tub"),
    "SinkBasin": ("basin",),
}
"""What else people call destinations and lamps."""


def stray_pronoun(text: str, mentions: Sequence[Named], things: Sequence[tuple[str, str]]) -> str:
    """Return a pronoun that may stand for a task object named before it in `text`, or nothing."""
    types = dict(things)
    for mention in mentions:
        if mention.of == "destination":
            continue
        several = is_plural(mention.text, types[mention.of])
        found = (_PLURAL if several else _SINGULAR).search(text, mention.end)
        if found and not re.match(
            r"\s+(?:is|was)\s+(?:late|time|cold out|raining)", text[found.end() :]
        ):
            return found[0]
    return ""


def replaced(
    explicit: str, mentions: Sequence[Named], vague: str, things: Sequence[tuple[str, str]]
) -> list[str]:
    """Return what `vague` says in place of each counted mention of `explicit`.

    Raises:
        Unfit: when the two differ elsewhere, or a mention is still named.
    """
    counted = [mention for mention in mentions if mention.of != "destination"]
    for tight in (False, True):
        pattern, end = "", 0
        for mention in counted:
            start = mention.start + (_noun_start(mention) if tight else 0)
            pattern += re.escape(explicit[end:start]) + "(.+?)"
            end = mention.end
        found = re.fullmatch(pattern + re.escape(explicit[end:]), vague, re.IGNORECASE)
        if found:
            break
    else:
        raise Unfit(
            "changes more than the expressions",
            "Only the words for the object may change; everything else must stay letter for letter:"
            f" {explicit!r} became {vague!r}.",
        )
    words = list(found.groups())
    if tight:
        words = [m.text[: _noun_start(m)] + w for m, w in zip(counted, words, strict=True)]
    types = dict(things)
    for mention, new in zip(counted, words, strict=True):
        if any(says(new, word) for word in names()[types[mention.of]].words):
            raise Unfit("still named", f"{new!r} still names the object; describe it instead.")
    return words


def _noun_start(mention: Named) -> int:
    """Return where the name itself begins in a mention with its article and adjectives."""
    return len(mention.text) - len(
        re.split(rf"^(?:{_DETERMINERS})\s+", mention.text, flags=re.I)[-1]
    )


def as_mention(named: Named, unnamed: str) -> Mention:
    """Return a mention for a script; an unnamed form begins small but for `I`."""
    if unnamed and named.text[0].isupper() and not re.match(r"I\b", unnamed):
        unnamed = unnamed[0].lower() + unnamed[1:]
    return Mention(named.text, unnamed, named.of)
