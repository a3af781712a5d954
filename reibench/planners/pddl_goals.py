"""PDDL goals: what they may say, how they are read, and a grammar that allows no other.

A goal is a conjunction, `(:goal (and (hot potato) (in potato dining-table)))`, of the predicates
below over the objects of a room.
"""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from types import MappingProxyType
from typing import Literal, TypeAlias

from reibench.errors import InvalidGoal, unknown

Role = Literal["thing", "place", "heatable", "coolable", "washable", "sliceable", "lamp"]
"""What an object must be to stand in a place of a predicate."""
PREDICATES: Mapping[str, tuple[Role, ...]] = MappingProxyType(
    {
        "in": ("thing", "place"),
        "hot": ("heatable",),
        "cold": ("coolable",),
        "clean": ("washable",),
        "sliced": ("sliceable",),
        "lit": ("thing", "lamp"),
        "holding": ("thing",),
    }
)
"""What goals may say, with the roles of the arguments."""
TREATMENTS = ("hot", "cold", "clean", "sliced")
HELD = ("lit", "holding")
HAND = "the hand"
MOST = 5
"""Conditions a goal may have."""
ROLES = MappingProxyType(
    {
        "thing": "a thing that can be picked up",
        "place": "a place that things can be put in or on",
        "heatable": "a thing that can be heated here",
        "coolable": "a thing that can be cooled here",
        "washable": "a thing that can be washed here",
        "sliceable": "a thing that can be sliced here",
        "lamp": "a lamp",
    }
)

_TOKEN = re.compile(r"[()]|[^\s()]+")
_COMMENT = re.compile(r";[^\n]*")
Nested: TypeAlias = "str | list[Nested]"


@dataclass(frozen=True)
class Fact:
    """A predicate and what it is said of."""

    predicate: str
    arguments: tuple[str, ...]

    def __str__(self) -> str:
        return f"({' '.join((self.predicate, *self.arguments))})"


@dataclass(frozen=True)
class Vocabulary:
    """The objects of a room that a goal may name, and what the room allows to be done to them."""

    objects: Mapping[Role, tuple[str, ...]]
    """Those that may stand where a role is wanted."""
    fitting: Mapping[str, tuple[str, ...]]
    """The places that each thing can be put in or on."""

    @property
    def names(self) -> list[str]:
        """Every object, sorted."""
        return sorted({name for names in self.objects.values() for name in names})

    @property
    def predicates(self) -> list[str]:
        """What can be said of something in this room."""
        return [
            predicate
            for predicate, roles in PREDICATES.items()
            if all(self.objects[role] for role in roles)
        ]


def in_pddl(facts: Iterable[Fact]) -> str:
    """Return the goal that consists of `facts`."""
    return f"(:goal (and {' '.join(map(str, facts))}))"


def read_goal(text: str, vocabulary: Vocabulary) -> tuple[Fact, ...]:
    """Return what the first `(:goal …)` of `text` asks for.

    Raises:
        InvalidGoal: saying what is wrong, and what would be right.
    """
    begin = text.find("(:goal")
    if begin < 0:
        raise InvalidGoal("There is no (:goal ...) in the answer.")
    said = _nested(text[begin:])
    if len(said) != 2:
        raise InvalidGoal(
            f"(:goal ...) must hold one condition, or (and ...); not {len(said) - 1}."
        )
    facts = tuple(_facts(said[1], vocabulary))
    if not 1 <= len(facts) <= MOST:
        raise InvalidGoal(f"A goal has 1 to {MOST} conditions, not {len(facts)}.")
    facts = tuple(dict.fromkeys(facts))
    _check_together(facts)
    return facts


def _check_together(facts: Sequence[Fact]) -> None:
    """Refuse what cannot hold at once; a planner would search for long before it gave up."""
    placed = [(fact, place) for fact in facts if (place := _place(fact))]
    for (one, here), (other, there) in combinations(placed, 2):
        same = one.arguments[0] == other.arguments[0]
        if same and here != there:
            raise InvalidGoal(f"{one} and {other} cannot both hold; keep the one asked for.")
        if not same and here == there == HAND:
            raise InvalidGoal(f"{one} and {other} cannot both hold: the robot has one hand.")


def _place(fact: Fact) -> str:
    """Return where a fact says its thing is; empty if it does not."""
    if fact.predicate == "in":
        return fact.arguments[1]
    return HAND if fact.predicate in HELD else ""


def _nested(text: str) -> list[Nested]:
    """Return the first parenthesised expression of `text` as lists of lists of words."""
    open_lists: list[list[Nested]] = []
    for token in _TOKEN.findall(_COMMENT.sub("", text).lower()):
        if token == "(":
            open_lists.append([])
        elif token != ")":
            open_lists[-1].append(token)
        else:
            whole = open_lists.pop()
            if not open_lists:
                return whole
            open_lists[-1].append(whole)
    missing = len(open_lists)
    raise InvalidGoal(f"The goal breaks off: {missing} closing parentheses are missing.")


def _facts(said: Nested, vocabulary: Vocabulary) -> Iterator[Fact]:
    if isinstance(said, str) or not said or not isinstance(said[0], str):
        raise InvalidGoal(f"{written(said)} is no condition; one reads like (hot potato).")
    if said[0] == "and":
        for each in said[1:]:
            yield from _facts(each, vocabulary)
        return
    predicate, arguments = said[0], said[1:]
    if predicate not in PREDICATES:
        raise InvalidGoal(str(unknown("predicate", predicate, PREDICATES)))
    roles = PREDICATES[predicate]
    if len(arguments) != len(roles) or not all(isinstance(each, str) for each in arguments):
        form = f"({' '.join((predicate, *(f'?{role}' for role in roles)))})"
        raise InvalidGoal(f"{written(said)} should read like {form}.")
    names = tuple(str(each) for each in arguments)
    for name, role in zip(names, roles, strict=True):
        _check(name, role, vocabulary)
    if len(set(names)) < len(names):
        raise InvalidGoal(f"{written(said)} says something of {names[0]} and itself.")
    if predicate == "in" and names[1] not in vocabulary.fitting[names[0]]:
        places = ", ".join(vocabulary.fitting[names[0]]) or "nowhere in this room"
        raise InvalidGoal(f"{names[0]} does not go in or on {names[1]}; it goes to: {places}.")
    yield Fact(predicate, names)


def _check(name: str, role: Role, vocabulary: Vocabulary) -> None:
    if name in vocabulary.objects[role]:
        return
    if name not in vocabulary.names:
        raise InvalidGoal(str(unknown("object", name, vocabulary.objects[role])))
    fitting = ", ".join(vocabulary.objects[role]) or "none is in this room"
    raise InvalidGoal(f"{name} is not {ROLES[role]}; such are: {fitting}.")


def written(said: Nested) -> str:
    """Return nested words as PDDL again."""
    return said if isinstance(said, str) else f"({' '.join(map(written, said))})"


def grammar(vocabulary: Vocabulary) -> str:
    """Return the GBNF of what may follow `(:goal (and`, up to its last parenthesis.

    It is narrower than `read_goal`, for small models like to go on: one thing is put somewhere,
    or put in a carrier that is, or held, as in all task types of REI-Bench; what else was done to
    it may stand before and after, at most twice each.
    """
    sayable = vocabulary.predicates
    treated, held = (
        " | ".join(_condition(name) for name in names if name in sayable) or '""'
        for names in (TREATMENTS, HELD)
    )
    some = '(" " treated)? (" " treated)?' if set(TREATMENTS) & set(sayable) else ""
    used = dict.fromkeys(role for name in sayable for role in PREDICATES[name])
    rules = (
        'root ::= (placed | taken) "))"',
        f'placed ::= {some} " " ({" | ".join(("put", *_carried(vocabulary)))}) {some}',
        f'taken ::= {some} " " held',
        f"put ::= {_condition('in')}",
        f"treated ::= {treated}",
        f"held ::= {held}",
        *(f"{role} ::= {_alternatives(vocabulary.objects[role])}" for role in used),
    )
    return "\n".join(rules)


def _condition(predicate: str) -> str:
    roles = ' " " '.join(PREDICATES[predicate])
    return f'"({predicate} " {roles} ")"'


def _carried(vocabulary: Vocabulary) -> Iterator[str]:
    """Yield, for each thing that is a place too, what puts something in it and it somewhere."""
    for name in vocabulary.objects["place"]:
        if name in vocabulary.objects["thing"]:
            yield f'"(in " thing " {name}) (in {name} " place ")"'


def _alternatives(names: Iterable[str]) -> str:
    return " | ".join(f'"{name}"' for name in names)
