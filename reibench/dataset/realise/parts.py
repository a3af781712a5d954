"""The marked parts that dialogues are recombined from (`assets/realiser`, its README)."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Literal, get_args

from reibench.dataset.scripts import Stay
from reibench.episode import TaskType
from reibench.errors import ReibenchError

PARTS = Path(__file__).parents[3] / "assets" / "realiser"
Role = Literal["opening", "intro", "advice", "exchange", "plan", "place", "request", "noise"]
"""Where in a dialogue a part stands."""
Way = Literal["the", "this", "they", "them", "that", "a", "my"]
"""How a slot speaks of its thing; see the table in the parts' README."""
Relation = Literal["at", "in", "into"]
"""A preposition that depends on the destination (`at`) or on the holder."""


@dataclass(frozen=True)
class Slot:
    """A place for a mention."""

    way: Way
    of: Literal["object", "movable"]
    capital: bool


@dataclass(frozen=True)
class Agreement:
    """A word that depends on the number of the object."""

    singular: str
    plural: str


@dataclass(frozen=True)
class Destination:
    """A place for the destination's name."""

    capital: bool


@dataclass(frozen=True)
class Preposition:
    """A place for a preposition."""

    relation: Relation


Token = str | Slot | Agreement | Destination | Preposition


@dataclass(frozen=True)
class Piece:
    """One or more sentences of a part that come and go together."""

    stay: Stay
    tokens: tuple[Token, ...]


@dataclass(frozen=True)
class Part:
    """Something to say, in one turn or in two."""

    role: Role
    kinds: frozenset[str]
    """Kinds of things or object types it suits, or noise's categories; empty for all."""
    tasks: frozenset[TaskType]
    least_age: int
    """How old who says it must be, at least."""
    who: str
    """The speaker, where it says who speaks."""
    turns: tuple[tuple[Piece, ...], ...]
    text: str
    """As the file has it."""

    def words(self, turn: int = 0) -> int:
        """Return how many words its turn has at least, however its slots are filled."""
        return self._lengths[turn]

    @cached_property
    def _lengths(self) -> tuple[int, ...]:
        return tuple(
            sum(_words(token) for piece in turn for token in piece.tokens) for turn in self.turns
        )


def _words(token: Token) -> int:
    if isinstance(token, str):
        # a comma after a slot is no word
        return sum(bool(re.search(r"\w", word)) for word in token.split())
    if isinstance(token, Agreement):
        return min(len(token.singular.split()), len(token.plural.split()))
    if isinstance(token, Slot):
        return 2 if token.way in ("the", "this", "my") else 1
    return 1


Header = tuple[Role, frozenset[str], frozenset[TaskType]]
"""What a line `== role | kinds | tasks` says of the lines below it."""
_ROLES = get_args(Role)
_AGES = re.compile(r"(\d+)\+ ")
_PIECE = re.compile(r"\{-([^{}]*)\}|((?:[^{}]|\{(?:name)\})+)")
_TOKEN = re.compile(
    r"\[(?P<movable>2:)?(?P<way>\w+)\]"
    r"|<(?P<place>[Pp]lace)>"
    r"|\((?P<relation>at|in|into)\)"
    r"|\((?P<singular>[^()/]+)/(?P<plural>[^()/]+)\)"
)


@lru_cache(maxsize=1)
def parts() -> tuple[Part, ...]:
    """Return every part.

    Raises:
        ReibenchError: naming the file and line that cannot be understood.
    """
    return tuple(part for path in sorted(PARTS.glob("*.txt")) for part in read_parts(path))


def read_parts(path: Path) -> Iterator[Part]:
    """Yield the parts of a file; raises ReibenchError naming the line that is wrong."""
    header: Header | None = None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        try:
            if line.startswith("== "):
                header = _header(line)
            elif line.strip():
                yield _part(line.strip(), header)
        except ValueError as problem:
            raise ReibenchError(f"{path}, line {number}: {problem}.") from problem


def _header(line: str) -> Header:
    role, kinds, tasks = (cell.strip() for cell in line.removeprefix("== ").split("|"))
    known = {task.short: task for task in TaskType}
    [found] = [each for each in _ROLES if each == role] or [None]
    if found is None:
        raise ValueError(f"the role {role!r} is none of {', '.join(_ROLES)}")
    if unknown := set(tasks.split()) - {*known, "*"}:
        raise ValueError(f"{', '.join(sorted(unknown))} is no task type")
    one = [kinds] if role == "noise" else kinds.split()  # categories have spaces
    for_tasks = known.values() if tasks == "*" else (known[name] for name in tasks.split())
    return found, frozenset(one) - {"*"}, frozenset(for_tasks)


def _part(text: str, header: Header | None) -> Part:
    if header is None:
        raise ValueError("a line '== role | kinds | tasks' comes first")
    role, kinds, tasks = header
    rest, least_age, who = text, 0, ""
    if age := _AGES.match(rest):
        least_age, rest = int(age[1]), rest[age.end() :]
    if role == "opening":
        who, _, rest = (cell.strip() for cell in rest.partition("::"))
    turns = tuple(tuple(_pieces(turn.strip())) for turn in rest.split("=>"))
    wanted = 2 if role in ("opening", "exchange") else 1
    if len(turns) != wanted:
        raise ValueError(f"a part for {role} has {wanted} turns, not {len(turns)}")
    return Part(role, kinds, tasks, least_age, who, turns, rest)


def _pieces(text: str) -> Iterator[Piece]:
    end = 0
    for found in _PIECE.finditer(text):
        if found.start() != end:
            break
        end = found.end()
        cut, plain = found.groups()
        if (inner := (cut or plain).strip()) != "":
            yield Piece("cut" if cut else "always", tuple(_tokens(inner)))
    if end != len(text):
        raise ValueError(f"a brace is not closed near {text[end : end + 40]!r}")


def _tokens(text: str) -> Iterator[Token]:
    end = 0
    for found in _TOKEN.finditer(text):
        if found.start() > end:
            yield _plain(text[end : found.start()])
        end = found.end()
        yield _slot(found)
    if end < len(text):
        yield _plain(text[end:])


def _slot(found: re.Match[str]) -> Token:
    if place := found["place"]:
        return Destination(capital=place[0].isupper())
    for relation in get_args(Relation):
        if found["relation"] == relation:
            return Preposition(relation)
    if found["singular"]:
        return Agreement(found["singular"], found["plural"])
    for way in get_args(Way):
        if found["way"].lower() == way:
            of: Literal["object", "movable"] = "movable" if found["movable"] else "object"
            return Slot(way, of, capital=found["way"][0].isupper())
    raise ValueError(f"the slot {found[0]} is none of {', '.join(get_args(Way))}")


def _plain(text: str) -> str:
    if odd := next((sign for sign in "[]<>()|" if sign in text), ""):
        raise ValueError(f"{odd!r} stands alone near {text[:60]!r}")
    return text
