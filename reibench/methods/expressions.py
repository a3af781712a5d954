"""Which stretches of an instruction may stand for a thing without naming it: rules, no model."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache

from reibench.skill import FINDABLE, PICKABLE, in_words

LONGEST = 8
"""Words of an expression."""
DETERMINERS = frozenset("the this that these those my your our his her their".split())
SUBJECTS = frozenset("i you we he she they my your our his her their that which who".split())
"""Words that begin a clause which says more about a thing: the one *I* drink from."""
CONTRACTIONS = frozenset("let it that what he she there here who".split())
"""Words whose 's is no possessive."""
PRONOUNS = frozenset("it this that them these those".split())
AFTER_PRONOUN = frozenset(
    "up down in on to into onto over away back out under by with for from and then please".split()
)
PREPOSITIONS = frozenset(
    "in on into onto to up down over under by for from at off out away back".split()
)
BREAKS = frozenset("and then or but please".split())
"""Words no expression goes beyond."""
SUBORDINATE = frozenset("so before after until while because since if when".split())
"""Words after which the rest of a clause asks for nothing."""
EVERYDAY = "counter table lamp light couch bin stove burner chair armchair".split()
"""Everyday names of places and lamps beside those of the skills."""


def request(instruction: str) -> str:
    """Return the sentences of `instruction` that name a place or a lamp, else any object, else all.

    What is asked for names where it ends; the rest is chatter.
    """
    sentences = re.split(r"(?<=[.!?])\s+", instruction)
    with_place = [sentence for sentence in sentences if _names(places=True).search(sentence)]
    with_object = [sentence for sentence in sentences if _names().search(sentence)]
    return " ".join(with_place or with_object or sentences)


def names_a_thing(text: str) -> bool:
    """Whether `text` names something that can be picked up."""
    things = _names(places=True).sub("", text)
    return _names().search(things) is not None


@dataclass(frozen=True)
class Candidate:
    """A place in an instruction where an expression may begin."""

    start: int
    """Character offset."""
    spans: tuple[str, ...]
    """The expressions that may begin there, the shortest first."""
    head: str = ""
    """The noun phrase without what is said about it after a preposition or in a clause; a clause
    that begins with `what` whole."""

    @property
    def pronoun(self) -> bool:
        """Whether it is a pronoun, which may only repeat what was said."""
        return self.spans[0].lower() in PRONOUNS


def candidates(instruction: str) -> list[Candidate]:
    """Return where expressions for a thing that do not name it may stand, in order.

    They are pronouns, or begin with a determiner, a possessive or `what`; they stay within a
    clause; and they name no object of the skills, no place and no lamp.
    """
    found = []
    for clause in re.finditer(r"[\w'’-]+(?:\s+[\w'’-]+)*", instruction):
        matches = list(re.finditer(r"\S+", clause[0]))
        words = [match[0] for match in matches]
        for start, match in enumerate(matches):
            if match[0].lower() in SUBORDINATE:
                break
            if spans := tuple(_starting(words, start)):
                head = _head(words, start, spans)
                found.append(Candidate(clause.start() + match.start(), spans, head))
    return found


def _starting(words: Sequence[str], start: int) -> Iterable[str]:
    """Yield the expressions that begin with this word, the shortest first."""
    word = words[start].lower()
    if word in PRONOUNS and _stands_alone(words, start):
        yield words[start]
    elif word in ("what", "whatever"):
        yield from _stretches(words, start, start + 3, _clause_end(words, start))
    elif (word in DETERMINERS or _is_possessive(word)) and not _describes(words, start):
        head = _head_end(words, start)
        if not _names().search(" ".join(words[start + 1 : head])):
            yield from _stretches(words, start, start + 2, _phrase_end(words, head))


def _head(words: Sequence[str], start: int, spans: Sequence[str]) -> str:
    word = words[start].lower()
    if word in ("what", "whatever"):
        return spans[-1]
    if spans[0].lower() == word:
        return spans[0]
    return " ".join(words[start : _head_end(words, start)])


def _stretches(words: Sequence[str], start: int, shortest: int, longest: int) -> Iterable[str]:
    for end in range(shortest, longest + 1):
        span = " ".join(words[start:end])
        last = words[end - 1].lower()
        cut_off = last in DETERMINERS or last in ("a", "an", "with", "of")
        stranded = last == "with" and bool(SUBJECTS & set(span.lower().split()[1:]))
        if stranded or not cut_off:
            yield span


def _stands_alone(words: Sequence[str], place: int) -> bool:
    if words[place].lower() in ("it", "them"):
        return True
    return place + 1 == len(words) or words[place + 1].lower() in AFTER_PRONOUN


def _is_possessive(word: str) -> bool:
    owner = re.fullmatch(r"(\w+)(?:'s|’s)", word)
    return owner is not None and owner[1] not in CONTRACTIONS


def _describes(words: Sequence[str], start: int) -> bool:
    """Whether what begins here belongs to something larger: the one with *the handle*."""
    return start > 0 and words[start - 1].lower() in ("with", "of", "what", "whatever")


def _head_end(words: Sequence[str], start: int) -> int:
    """Return where the noun phrase itself ends, before what says more about it."""
    stops = PREPOSITIONS | BREAKS | SUBORDINATE | SUBJECTS | {"with", "of"}
    end = start + 1
    while end < len(words) and words[end].lower() not in stops:
        end += 1
    return end


def _phrase_end(words: Sequence[str], head: int) -> int:
    """Return how far the phrase may go on: a clause about it, or what it has or is made of."""
    if head == len(words):
        return head
    if words[head].lower() in SUBJECTS:
        return _clause_end(words, head)
    if words[head].lower() not in ("with", "of"):
        return head
    end = head + 1
    while end < len(words) and words[end].lower() not in PREPOSITIONS | BREAKS | SUBORDINATE:
        end += 1
    return end


def _clause_end(words: Sequence[str], start: int) -> int:
    """Return where a clause must end: at a break, or before the words of a place."""
    end = start + 1
    while end < min(len(words), start + LONGEST) and words[end].lower() not in BREAKS:
        if _names(places=True).search(" ".join(words[start : end + 2])):
            break
        end += 1
    return end


@lru_cache(maxsize=2)
def _names(*, places: bool = False) -> re.Pattern[str]:
    """Return what matches the names of objects, or of `places` and lamps only."""
    types = [name for name in FINDABLE if not places or name not in PICKABLE]
    longest_first = sorted([*map(in_words, types), *EVERYDAY], key=len, reverse=True)
    return re.compile(rf"\b(?:{'|'.join(longest_first)})s?\b", re.IGNORECASE)
