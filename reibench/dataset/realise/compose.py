"""Composing a dialogue: parts, names and words put together into a script."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from random import Random

from reibench.dataset.forms import names, says
from reibench.dataset.lexicon import Expression, Lexicon, expressions
from reibench.dataset.realise import ORIGIN
from reibench.dataset.realise.choosing import Chooser, age_of, counted, name_for
from reibench.dataset.realise.filling import Line, arrange, fill, uses
from reibench.dataset.realise.nouns import OWN, Noun, nouns
from reibench.dataset.realise.wording import Wording, Wordsmith
from reibench.dataset.scripts import Script
from reibench.dataset.seeds import kind_of
from reibench.dialogue import Vagueness
from reibench.episode import Goal, Task
from reibench.errors import ReibenchError

TRIES = 50
IMPLICIT_SHORT = Vagueness("implicit", "short")


class CannotRealise(ReibenchError):
    """There are no parts or words for a task."""


@dataclass(frozen=True)
class Called:
    """What somebody has called the things of a task already."""

    nouns: Mapping[str, str] = field(default_factory=dict)
    """By object type; what is missing or empty is left to the realiser."""
    place: str = ""
    """The destination or lamp, without an article."""

    def noun(self, object_type: str) -> Noun | None:
        """Return the noun for a thing, unless it is left open."""
        word = self.nouns.get(object_type, "")
        if not word:
            return None
        usual = nouns()[object_type][0]
        known = names()[object_type]
        if word in known.plural:
            return Noun("plural", (word,), (word,)) if known.number == "plural" else None
        if known.number == "mass":
            return usual
        return Noun("count", (word,), (word,))


class Realiser:
    """Makes scripts for tasks, with the expressions of a lexicon."""

    def __init__(self, lexicon: Lexicon | None = None) -> None:
        self._lexicon = expressions() if lexicon is None else lexicon
        self._chooser = Chooser()
        self._words: dict[tuple[str, str, bool], tuple[Expression, ...]] = {}

    def realise(
        self, task: Task, present: Iterable[str], seed: str, called: Called | None = None
    ) -> Script:
        """Return a script for `task`; the same arguments give the same script.

        Args:
            task: what is asked for.
            present: the object types of its room.
            seed: decides among equals.
            called: what somebody has called things already.

        Raises:
            CannotRealise: when no parts suit the task.
        """
        choose = Random(seed)
        types = frozenset(present)
        for _ in range(TRIES):
            if script := self._try(task, types, choose, called or Called()):
                return script
        raise CannotRealise(
            f"No dialogue can be composed for {task.id} in {task.setup.room}: the parts for"
            f" {task.goal.task_type.short} {task.goal.object} are too few."
        )

    def _try(
        self, task: Task, present: frozenset[str], choose: Random, called: Called
    ) -> Script | None:
        goal = task.goal
        chosen = self._chooser.parts_for(goal, choose)
        if chosen is None:
            return None
        age = age_of(chosen[0])
        name = name_for(goal, present, choose, age)
        noise = self._chooser.noise_for(goal, name, age, choose) if name else []
        if name is None or not noise:
            return None
        mine = {each: called.noun(each) or choose.choice(nouns()[each]) for each in counted(goal)}
        noun = mine[goal.object]
        lines = arrange(chosen, noise, choose)
        wordings = self._word(goal, mine, present, lines, choose)
        if wordings is None:
            return None
        mentions = [list(each.mentions) for each in wordings]
        turns = tuple(fill(goal, noun, lines, mentions, called.place))
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

    def _word(
        self,
        goal: Goal,
        mine: Mapping[str, Noun],
        present: frozenset[str],
        lines: Sequence[Line],
        choose: Random,
    ) -> list[Wording] | None:
        """Word the mentions of each task object; None if a pair of them cannot be kept apart."""
        wordings: list[Wording] = []
        for name in counted(goal):
            of = "object" if name == goal.object and not wordings else "movable"
            words = self._usable(name, goal, plural=mine[name].is_plural)
            others = present - {goal.object, goal.movable_receptacle}
            smith = Wordsmith(mine[name], words, others, choose, owned=kind_of(name) in OWN)
            wordings.append(smith.word(list(uses(goal, lines, of))))
        if len(wordings) > 1 and any(wording.undecided for wording in wordings):
            return None
        return wordings

    def _usable(self, name: str, goal: Goal, *, plural: bool) -> tuple[Expression, ...]:
        """Return the expressions for `name` that anyone may say and that name no task object."""
        other = goal.movable_receptacle if name == goal.object else goal.object
        key = (name, other, plural)
        if key not in self._words:
            words = [word for each in counted(goal) for word in names()[each].words]
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
