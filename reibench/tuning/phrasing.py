"""Phrasing: what people say when they say clearly what they want, out of a small grammar."""

import csv
import re
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from random import Random

from reibench.dataset.forms import names
from reibench.episode import Goal, TaskType
from reibench.goals import preposition
from reibench.skill import in_words

FOLDER = Path(__file__).parents[2] / "assets" / "tuning"
SEVERAL: Mapping[str, Sequence[str]] = {
    "table": ("DiningTable", "CoffeeTable", "SideTable", "Desk"),
    "table top": ("DiningTable", "CoffeeTable", "SideTable"),
    "chair": ("ArmChair", "Sofa"),
    "lamp": ("DeskLamp", "FloorLamp"),
    "light": ("DeskLamp", "FloorLamp"),
}
"""Words for places and lamps that several types go by, in the order in which they are tried."""
SLICES = ("slice of {}", "slice of {}", "piece of {}", "{} slice", "cut {}", "sliced {}")
DETAILED = 0.15
"""How often people say what a thing or place looks like."""
LOCATED = 0.12
"""How often they say where it is."""
_CHOICE = re.compile(r"\[([^\[\]]*)\]")


@dataclass(frozen=True)
class Called:
    """What the things of a request are called in it."""

    object: str
    """With its article, or an expression for it."""
    bare: str = ""
    """Without; empty where nothing but an expression is to be used."""
    plural: bool = False
    movable: str = ""
    """With its article, or an expression for it."""
    movable_bare: str = ""
    place: str = ""
    """Without an article."""


@dataclass(frozen=True)
class Manner:
    """How a request is dressed up, from 0 (never) to 1."""

    politeness: float = 0.5
    chatter: float = 0.4
    carelessness: float = 0.25
    """How often capitals or the full stop are missing."""
    meanings: Mapping[str, Sequence[str]] = field(default_factory=dict)


@lru_cache(maxsize=1)
def grammar() -> Mapping[str, Sequence[str]]:
    """Return the rules by name: one for each task type, and what goes around them."""
    table = tomllib.loads((FOLDER / "requests.toml").read_text(encoding="utf-8"))
    around = table.pop("around")
    asides = table.pop("aside")["human"]
    return {**table, **around, **table.pop("details"), "aside": asides}


@lru_cache(maxsize=1)
def things() -> Mapping[str, Sequence[str]]:
    """Return what people call each thing that can be picked up, one of it."""
    return _words("things.csv")


@lru_cache(maxsize=1)
def places() -> Mapping[str, Sequence[str]]:
    """Return what people call each place and lamp, the usual word more than once."""
    return _words("places.csv")


def _words(file_name: str) -> Mapping[str, Sequence[str]]:
    with (FOLDER / file_name).open(encoding="utf-8", newline="") as file:
        return {row["object_type"]: row["words"].split(";") for row in csv.DictReader(file)}


def place_word(object_type: str, choose: Random) -> str:
    """Choose a word for a place or lamp."""
    return choose.choice(places().get(object_type, (in_words(object_type),)))


def expand(rule: str, choose: Random) -> str:
    """Choose one of each `[a|b|]`."""
    while found := _CHOICE.search(rule):
        rule = rule[: found.start()] + choose.choice(found[1].split("|")) + rule[found.end() :]
    return " ".join(rule.split()).replace(" ,", ",")


def named(goal: Goal, choose: Random, place: str = "") -> Called:
    """Choose names for everything in `goal`."""
    thing, bare, plural = _noun(goal.object, choose)
    if goal.sliced:
        usual = bare
        bare = choose.choice(SLICES).format(usual)
        thing = f"{choose.choice(('a', 'the', 'a'))} {bare}"
    if choose.random() < DETAILED and not plural:
        bare, thing = _described(bare, thing, choose)
    if choose.random() < LOCATED:
        thing = f"{thing} {_whereabouts(goal, choose)}"
    other, other_bare = "", ""
    if goal.movable_receptacle:
        other, other_bare, _ = _noun(goal.movable_receptacle, choose, article="the")
        thing = thing if goal.sliced else f"the {bare}"
    word = place or place_word(goal.destination, choose)
    if choose.random() < DETAILED:
        word = f"{choose.choice(grammar()['looks'])} {word}"
    if choose.random() < LOCATED:
        word = f"{word} {choose.choice(grammar()['position'])}"
    return Called(thing, bare, plural, other, other_bare, word)


def _described(bare: str, thing: str, choose: Random) -> tuple[str, str]:
    """Return a name with a word about its looks, without its article and with."""
    looks = choose.choice(grammar()["looks"])
    return f"{looks} {bare}", thing.replace(bare, f"{looks} {bare}", 1)


def _whereabouts(goal: Goal, choose: Random) -> str:
    """Return where somebody thinks that a thing is: not where it should go."""
    others = [name for name in places() if name != goal.destination and not name.endswith("Lamp")]
    other = choose.choice(others)
    where = choose.choice(
        (preposition(other), "from", "off" if preposition(other) == "on" else "from")
    )
    return f"{where} the {place_word(other, choose)}"


def _noun(name: str, choose: Random, article: str = "") -> tuple[str, str, bool]:
    """Return a name with its article and without, and whether it is plural."""
    known = names()[name]
    plural = bool(known.plural) and known.number == "plural" and choose.random() < 0.7
    if plural or not known.singular:
        bare = choose.choice(known.plural)
        return f"{choose.choice(('the', 'the', 'my', 'some'))} {bare}", bare, True
    bare = choose.choice(things()[name])
    article = article or choose.choice(("the", "the", "the", "the", "a", "a", "my", "that"))
    if article == "that" or (article == "a" and known.number == "mass"):
        article = "the"
    return f"{article} {bare}", bare, False


def request(goal: Goal, called: Called, choose: Random) -> str:
    """Return a bare request for `goal`, without capital and full stop."""
    rules = list(grammar()[goal.task_type.short])
    if goal.destination == "GarbageCan" and goal.task_type is TaskType.PICK:
        rules += list(grammar()["bin"]) * 4
    if not called.bare:
        rules = [rule for rule in rules if "{n}" not in rule and "{nm}" not in rule]
    rule = expand(choose.choice(rules), choose)
    inside = preposition(goal.destination)
    of_movable = preposition(goal.movable_receptacle) if goal.movable_receptacle else ""
    text = rule.format(
        o=called.object,
        n=called.bare,
        it="them" if called.plural else "it",
        m=called.movable,
        nm=called.movable_bare,
        p=f"the {called.place}",
        l=f"the {called.place}",
        **{"in": inside, "into": f"{inside}to", "in_m": of_movable, "into_m": f"{of_movable}to"},
    )
    if goal.sliced and choose.random() < 0.35:
        whole = names()[goal.object].singular[0]
        first = choose.choice(("slice", "cut", "cut up", "slice up", "use a knife to slice"))
        text = f"{first} the {whole}{choose.choice((', then', ' and', ', and then', ','))} {text}"
    return re.sub(r"\b([Aa]) (?=[aeiou])", r"\1n ", text)


def dressed(text: str, choose: Random, manner: Manner) -> str:
    """Return a request as somebody says it: polite or not, with chatter, more or less tidy."""
    around = grammar()
    if text.startswith("to "):
        text = choose.choice(("I want you ", "your task is ", "be ready ", "")) + text
    elif choose.random() < manner.politeness:
        if choose.random() < 0.5 and not text.startswith("I "):
            text = f"{choose.choice(around['before'])} {text}"
        else:
            text = f"{text}, {choose.choice(around['after'])}"
    end = "?" if text.lower().startswith(("could", "can ", "would", "will you", "may")) else "."
    text = text[0].upper() + text[1:] + end
    if choose.random() < manner.chatter:
        if choose.random() < 0.75:
            text = f"{choose.choice(around['lead'])} {text}"
        if choose.random() < 0.35:
            text = f"{text} {choose.choice(around['tail'])}"
    if choose.random() < manner.carelessness:
        text = choose.choice((text.lower(), text.rstrip("."), text.lower().rstrip(".")))
    return text


def aside(things: Sequence[str], choose: Random) -> str:
    """Return a remark about something that is there and not asked for."""
    name = choose.choice(list(things))
    bare = choose.choice(names()[name].singular or names()[name].plural)
    text: str = choose.choice(grammar()["aside"]).format(x=f"the {bare}")
    return text[0].upper() + text[1:]
