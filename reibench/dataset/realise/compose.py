"""Composing a dialogue: which parts follow each other, and who says what when."""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from random import Random

from reibench.dataset.forms import names, says
from reibench.dataset.lexicon import Expression, Lexicon, expressions
from reibench.dataset.realise import ORIGIN
from reibench.dataset.realise.nouns import (
    OWN,
    Name,
    Noun,
    ambiguous_names,
    at,
    into,
    nouns,
    place_words,
)
from reibench.dataset.realise.parts import (
    Agreement,
    Destination,
    Part,
    Piece,
    Preposition,
    Role,
    Slot,
    Token,
    parts,
)
from reibench.dataset.realise.wording import Use, Wording, Wordsmith
from reibench.dataset.scripts import Mention, Passage, Script, Turn
from reibench.dataset.seeds import kind_of
from reibench.dialogue import Speaker, Vagueness
from reibench.episode import Goal, Task, TaskType
from reibench.errors import ReibenchError

_BASINS = ("Sink", "SinkBasin", "Bathtub", "BathtubBasin")
_UNEXPECTED = {
    TaskType.HEAT: ("Fridge", *_BASINS),
    TaskType.COOL: ("Microwave", *_BASINS),
    TaskType.CLEAN: _BASINS,
}
"""Where nobody expects a thing after its treatment."""
SETTINGS = ("bin", "odd")
"""What parts may be about besides kinds of things: see their README."""
LEAST_WORDS = 20
"""In each turn of the context (appendix B.1)."""
TRIES = 50
WORKING_AGE = (18, 65)
"""Who has colleagues."""
IMPLICIT_SHORT = Vagueness("implicit", "short")


class CannotRealise(ReibenchError):
    """There are no parts or words for a task."""


@dataclass(frozen=True)
class Line:
    """A turn before its slots are filled."""

    speaker: Speaker
    pieces: tuple[Piece, ...]
    in_request: bool = False
    pronoun: float = 0.0
    """How often its mention may be a pronoun."""


class Realiser:
    """Makes scripts for tasks, with the expressions of a lexicon."""

    def __init__(self, lexicon: Lexicon | None = None) -> None:
        self._lexicon = expressions() if lexicon is None else lexicon
        self._pools: dict[tuple[Role, str, Goal], tuple[Part, ...]] = {}
        self._words: dict[tuple[str, str, bool], tuple[Expression, ...]] = {}

    def realise(self, task: Task, present: Iterable[str], seed: str) -> Script:
        """Return a script for `task`; the same arguments give the same script.

        Args:
            task: what is asked for.
            present: the object types of its room.
            seed: decides among equals.

        Raises:
            CannotRealise: when no parts suit the task.
        """
        choose = Random(seed)
        types = frozenset(present)
        for _ in range(TRIES):
            if script := self._try(task, types, choose):
                return script
        raise CannotRealise(
            f"No dialogue can be composed for {task.id} in {task.setup.room}: the parts for"
            f" {task.goal.task_type.short} {task.goal.object} are too few."
        )

    def _try(self, task: Task, present: frozenset[str], choose: Random) -> Script | None:
        goal = task.goal
        chosen = self._parts(goal, choose)
        if chosen is None:
            return None
        age = _age(chosen[0])
        name = _name(goal, present, choose, works=WORKING_AGE[0] <= age < WORKING_AGE[1])
        if name is None:
            return None
        noise = [p for p in self._pool("noise", name.category, goal) if p.least_age <= age]
        sentences = [part.text.replace("{name}", name.text) for part in choose.sample(noise, 3)]
        noun = choose.choice(nouns()[goal.object])
        lines = _lines(chosen, sentences, choose)
        wordings = self._word(goal, noun, present, lines, choose)
        if wordings is None:
            return None
        turns = tuple(_turns(goal, noun, lines, [list(each.mentions) for each in wordings]))
        undecided = [other for each in wordings for other in each.undecided]
        left = {IMPLICIT_SHORT: (goal.object, *undecided)} if undecided else {}
        return Script(
            id=task.id,
            goal=goal,
            setup=task.setup,
            speaker=chosen[0].who,
            name=name.text,
            category=name.category,
            decoy=name.decoy,
            turns=turns,
            rivals={other: why for each in wordings for other, why in each.rivals.items()},
            candidates=left,
            origin=ORIGIN,
        )

    def _parts(self, goal: Goal, choose: Random) -> list[Part] | None:
        """Choose an opening and what follows it; None when its speaker has nothing to say."""
        opening = choose.choice(self._pool("opening", "", goal))
        age = _age(opening)
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

    def _pool(self, role: Role, kind: str, goal: Goal) -> tuple[Part, ...]:
        """Return the parts that may be used, which give away none of the task objects."""
        key = (role, kind, replace(goal, destination=_setting(goal)))
        if key not in self._pools:
            words = [word for name in _counted(goal) for word in names()[name].words]
            mine = [
                part
                for part in parts()
                if part.role == role
                and goal.task_type in part.tasks
                and not any(says(part.text, word) for word in words)
            ]
            special = [part for part in mine if part.kinds & {_setting(goal)}]
            self._pools[key] = tuple(
                special
                or (part for part in mine if not part.kinds or part.kinds & {kind, goal.object})
            )
        return self._pools[key]

    def _word(
        self,
        goal: Goal,
        noun: Noun,
        present: frozenset[str],
        lines: Sequence[Line],
        choose: Random,
    ) -> list[Wording] | None:
        """Word the mentions of each task object; None if a pair of them cannot be kept apart."""
        wordings: list[Wording] = []
        for name in _counted(goal):
            of = "object" if name == goal.object and not wordings else "movable"
            mine = noun if of == "object" else nouns()[name][-1]
            words = self._usable(name, goal, plural=mine.is_plural)
            others = present - {goal.object, goal.movable_receptacle}
            smith = Wordsmith(mine, words, others, choose, owned=kind_of(name) in OWN)
            wordings.append(smith.word(list(_uses(goal, lines, of))))
        if len(wordings) > 1 and any(wording.undecided for wording in wordings):
            return None
        return wordings

    def _usable(self, name: str, goal: Goal, *, plural: bool) -> tuple[Expression, ...]:
        """Return the expressions for `name` that anyone may say and that name no task object."""
        other = goal.movable_receptacle if name == goal.object else goal.object
        key = (name, other, plural)
        if key not in self._words:
            words = [word for each in _counted(goal) for word in names()[each].words]
            self._words[key] = tuple(
                each
                for each in self._lexicon.get(name, ())
                if each.is_free
                and "," not in each.text
                and (each.number == "plural") == plural
                and other not in each.also_fits
                and not any(says(each.text, word) for word in words)
            )
        return self._words[key]


def _setting(goal: Goal) -> str:
    """Return which setting a goal is in, where it is in any."""
    if goal.destination == "GarbageCan":
        return "bin"
    return "odd" if goal.destination in _UNEXPECTED.get(goal.task_type, ()) else ""


def _counted(goal: Goal) -> tuple[str, ...]:
    return tuple(filter(None, (goal.object, goal.movable_receptacle)))


def _age(opening: Part) -> int:
    """Return the age of who speaks, at the least: 70 for `retired postman, 70s`."""
    return int(re.findall(r"\d+", opening.who)[-1])


def _name(goal: Goal, present: frozenset[str], choose: Random, *, works: bool) -> Name | None:
    """Choose an ambiguous name that looks like something there, but not like a task object."""
    words = [word for name in _counted(goal) for word in names()[name].words]
    there = present - {*_counted(goal), goal.destination}
    fitting = [
        name
        for name in ambiguous_names()
        if name.decoy in there
        and (works or name.category != "colleague")
        and not any(says(name.text, word) for word in words)
    ]
    return choose.choice(fitting) if fitting else None


def _lines(chosen: Sequence[Part], noise: Sequence[str], choose: Random) -> list[Line]:
    """Arrange the parts in six turns and the request, each human turn with a sentence of noise."""
    opening, intro, advice, exchange, plan, place, request = chosen
    noisy = [Piece("noise", (sentence,)) for sentence in noise]
    first = [Piece("first", piece.tokens) for piece in intro.turns[0]]
    begun = [noisy[0], *first] if choose.random() < 1 / 2 else [*first, noisy[0]]
    # an answer to somebody's news can always be missed
    reaction = [Piece("cut", piece.tokens) for piece in opening.turns[1]]
    return [
        Line("human", (*opening.turns[0], *begun)),
        Line("robot", (*reaction, *advice.turns[0])),
        Line("human", (*exchange.turns[0], noisy[1])),
        Line("robot", exchange.turns[1], pronoun=0.4),
        Line("human", (*plan.turns[0], noisy[2])),
        Line("robot", place.turns[0]),
        Line("human", request.turns[0], in_request=True, pronoun=0.15),
    ]


def _uses(goal: Goal, lines: Sequence[Line], of: str) -> Iterator[Use]:
    for line in lines:
        for piece in line.pieces:
            around = [_around(token, goal) for token in ("", *piece.tokens, "")]
            for number, token in enumerate(piece.tokens):
                if isinstance(token, Slot) and token.of == of:
                    before, after = around[number], around[number + 2]
                    # of "to <place>" only the word next to the slot counts
                    last = before.split(" ")[-2:] if before.endswith(" ") else [""]
                    first = after.split(" ")[1:2] if after.startswith(" ") else [""]
                    if after == " ":
                        first = [_around((*piece.tokens, "")[number + 2], goal)]
                    stays = piece.stay == "always"
                    yield Use(
                        slot=token,
                        speaker=line.speaker,
                        stays=stays,
                        in_request=line.in_request,
                        before=last[0].lower(),
                        after=first[0].lower(),
                        pronoun=_pronoun_chance(goal, line, piece, token),
                        paired=bool(goal.movable_receptacle),
                    )


def _pronoun_chance(goal: Goal, line: Line, piece: Piece, slot: Slot) -> float:
    """Return how often a slot may take a pronoun: where its thing is what was spoken of last."""
    alone = sum(isinstance(token, Slot) for token in piece.tokens) == 1
    if goal.movable_receptacle or not alone or slot.capital or slot.way != "the":
        return 0.0
    if piece.stay == "cut":
        return 0.6
    return line.pronoun


def _around(token: Token, goal: Goal) -> str:
    if isinstance(token, str):
        return token
    filled = None if isinstance(token, Slot) else _fill(token, goal, None)
    return filled if isinstance(filled, str) else ""


def _turns(
    goal: Goal, noun: Noun, lines: Sequence[Line], mentions: Sequence[list[Mention]]
) -> Iterator[Turn]:
    """Fill the slots of each line, in order."""
    left = {"object": iter(mentions[0]), "movable": iter(mentions[-1])}
    for line in lines:
        passages: list[Passage] = []
        for piece in line.pieces:
            filled = [
                next(left[token.of]) if isinstance(token, Slot) else _fill(token, goal, noun)
                for token in piece.tokens
            ]
            if passages and passages[-1].stay == piece.stay == "always":
                filled = [*passages.pop().parts, " ", *filled]
            passages.append(Passage(piece.stay, tuple(_joined(filled))))
        yield Turn(line.speaker, tuple(passages))


def _fill(token: Token, goal: Goal, noun: Noun | None) -> str | Mention:
    if isinstance(token, Agreement):
        return token.plural if noun and noun.is_plural else token.singular
    if isinstance(token, Destination):
        words = place_words(goal.destination)
        return Mention(f"{'The' if token.capital else 'the'} {words}", "", "destination")
    if isinstance(token, Preposition):
        if token.relation == "at":
            return at(goal.destination)
        return into(goal.movable_receptacle, moving=token.relation == "into")
    assert isinstance(token, str)  # slots are filled by the wordsmith
    return token


def _joined(filled: Iterable[str | Mention]) -> Iterator[str | Mention]:
    """Join neighbouring stretches of plain text into one, as in a script that is read."""
    text = ""
    for part in filled:
        if isinstance(part, str):
            text += part
            continue
        if text:
            yield text
        yield part
        text = ""
    if text:
        yield text
