"""Own words: a dialogue and a request that a visitor wrote, and what would count as done."""

import hashlib
import json
import re
from collections.abc import Iterator, Sequence
from contextlib import closing
from dataclasses import astuple, dataclass, field

from reibench.dataset.files import digest, episode_from_json, episode_to_json
from reibench.dataset.forms import named_form, names
from reibench.dialogue import (
    Context,
    Dialogue,
    Reference,
    ReferringExpression,
    Utterance,
    Vagueness,
)
from reibench.episode import Episode, Goal, SceneSetup, Task, TaskType
from reibench.errors import ReibenchError
from reibench.household import load_room, room_names
from reibench.household.objects import object_type
from reibench.methods import Instruction
from reibench.planners.expert import Expert
from reibench.rollout import Rollout, drive
from reibench.run import RunSpec, make_world
from reibench.skill import PICKABLE, RECEPTACLES, in_words
from reibench.store import Store
from reibench.store.codec import dump
from reibench.store.schema import now

PREFIX = "own-"
LONGEST_TURN = 600
MOST_TURNS = 20
LONGEST_REQUEST = 400
SHORT = 3
"""A dialogue of fewer turns before the request counts as a short context."""
_SPEAKER = re.compile(r"^\s*(human|robot|h|r|me|you)\s*:\s*", re.IGNORECASE)
_HUMAN = ("human", "h", "me")
_BASIN = {"Sink": "SinkBasin", "Bathtub": "BathtubBasin"}
_TOOLS = {
    TaskType.HEAT: "Microwave", TaskType.COOL: "Fridge", TaskType.CLEAN: "Faucet",
}  # fmt: skip


@dataclass(frozen=True)
class Wording:
    """What a visitor filled in."""

    room: str
    before: str = ""
    """What was said before, a turn a line; `Human:` and `Robot:` say who, else they take turns."""
    request: str = ""
    task_type: str = str(TaskType.PICK)
    object: str = ""
    destination: str = ""
    movable: str = ""
    vague: str = ""
    """The words that stand for the object in what was said, with commas; may be left out."""


@dataclass(frozen=True)
class Choices:
    """What a goal can be made of in a room."""

    objects: tuple[str, ...]
    places: tuple[str, ...]
    lamps: tuple[str, ...]
    holders: tuple[str, ...]
    kinds: tuple[TaskType, ...] = field(default=tuple(TaskType))


def choices(room_name: str) -> Choices:
    """Return what a goal can be made of in a room; raises UnknownName."""
    room = load_room(room_name)
    present = {thing.type for thing in room.objects}
    holding = {thing.type for thing in room.objects if thing.receptacle}
    kinds = [kind for kind in TaskType if kind not in _TOOLS or _TOOLS[kind] in present]
    lamps = tuple(name for name in ("DeskLamp", "FloorLamp") if name in present)
    if not lamps:
        kinds.remove(TaskType.EXAMINE)
    return Choices(
        objects=tuple(sorted(present & set(PICKABLE), key=str.lower)),
        places=tuple(p for p in RECEPTACLES if _BASIN.get(p, p) in holding and p not in PICKABLE),
        lamps=lamps,
        holders=tuple(sorted(holding & set(PICKABLE), key=str.lower)),
        kinds=tuple(kinds),
    )


def compose(said: Wording) -> Episode:
    """Return the episode a visitor worded, if it can be carried out.

    Raises:
        ReibenchError: in one sentence about the first thing that is wrong.
    """
    if said.room not in room_names():
        raise ReibenchError(f"There is no room {said.room[:40]!r} here; choose one from the list.")
    goal = _goal(said, choices(said.room))
    dialogue = _dialogue(said, goal)
    number = hashlib.sha256(
        # with what is marked: who mends only that has made another episode
        json.dumps([said.room, str(goal), [astuple(u) for u in dialogue.utterances]]).encode()
    ).hexdigest()[:10]
    task = Task(f"{PREFIX}{number}", SceneSetup(said.room, int(number[:3], 16) % 1000), goal)
    episode = Episode(task, dialogue, _vagueness(dialogue, goal), origin="own words")
    _check_solvable(episode)
    return episode


def _goal(said: Wording, there: Choices) -> Goal:
    kind = next((kind for kind in there.kinds if str(kind) == said.task_type), None)
    if kind is None:
        raise ReibenchError(
            f"The kind of task {said.task_type[:40]!r} is none of this room's; it has"
            f" {', '.join(kind.label for kind in there.kinds)}."
        )
    places = there.lamps if kind is TaskType.EXAMINE else there.places
    _check_there("object", said.object, there.objects)
    _check_there("lamp" if kind is TaskType.EXAMINE else "place", said.destination, places)
    movable = said.movable if kind is TaskType.STACK else ""
    if kind is TaskType.STACK:
        _check_there("thing to put it into", movable, there.holders)
        if movable == said.object:
            raise ReibenchError(f"The {in_words(movable)} cannot be put into itself.")
        if not object_type(said.object).belongs(movable):
            raise ReibenchError(
                f"A robot here puts no {in_words(said.object)} into a {in_words(movable)}."
            )
    carried = movable or said.object
    if kind is not TaskType.EXAMINE and not _fits(carried, said.destination):
        raise ReibenchError(
            f"A robot here puts no {in_words(carried)} into or onto the"
            f" {in_words(said.destination)}; choose another place."
        )
    return Goal(kind, said.object, said.destination, movable)


def _fits(name: str, place: str) -> bool:
    kind = object_type(name)
    return kind.belongs(place) or kind.belongs(_BASIN.get(place, place))


def _check_there(what: str, chosen: str, known: Sequence[str]) -> None:
    if chosen not in known:
        said = f"{in_words(chosen[:40])!r} is not in this room" if chosen else "is not chosen yet"
        raise ReibenchError(
            f"The {what} {said}; choose one of {', '.join(in_words(n) for n in known) or 'none'}."
        )


def _dialogue(said: Wording, goal: Goal) -> Dialogue:
    request = " ".join(said.request.split())
    if not request:
        raise ReibenchError("The request is empty; write what the robot is asked in the end.")
    if len(request) > LONGEST_REQUEST:
        raise ReibenchError(
            f"The request has {len(request):,} characters; at most {LONGEST_REQUEST} fit."
        )
    turns = list(_turns(said.before))
    if len(turns) > MOST_TURNS:
        raise ReibenchError(f"The dialogue has {len(turns)} turns; at most {MOST_TURNS} fit.")
    for place, turn in enumerate(turns, start=1):
        if len(turn.text) > LONGEST_TURN:
            raise ReibenchError(
                f"Turn {place} of the dialogue has {len(turn.text):,} characters; at most"
                f" {LONGEST_TURN} fit."
            )
    vague = [" ".join(words.split()) for words in said.vague.split(",") if words.strip()]
    for words in vague:
        if not any(_found(words, turn.text) for turn in (*turns, Utterance("human", request))):
            raise ReibenchError(
                f"“{words[:60]}” is nowhere in what is said; write it as it is there."
            )
    spoken = [*turns, Utterance("human", request)]
    return Dialogue(tuple(_marked(turn, goal, vague) for turn in spoken))


def _turns(before: str) -> Iterator[Utterance]:
    last = "robot"
    for line in before.splitlines():
        words = " ".join(line.split())
        if not words:
            continue
        told = _SPEAKER.match(f"{words} ")
        if told and told.end() >= len(words):
            continue  # only who speaks, and nothing said
        human = told[1].lower() in _HUMAN if told else last == "robot"
        last = "human" if human else "robot"
        yield Utterance("human" if human else "robot", words[told.end() :] if told else words)


def _found(words: str, text: str) -> list[re.Match[str]]:
    return list(re.finditer(rf"(?<![\w-]){re.escape(words)}(?![\w-])", text, re.IGNORECASE))


def _marked(turn: Utterance, goal: Goal, vague: Sequence[str]) -> Utterance:
    """Return a turn with the expressions that are known to mean something of the goal."""
    found: list[ReferringExpression] = []

    def mark(m: re.Match[str], name: str, form: str, *, explicit: bool) -> None:
        if not any(one.start < m.end() and m.start() < one.end for one in found):
            found.append(ReferringExpression(m.start(), m.end(), m[0], name, form, explicit))

    # of words within others the longer ones are marked
    for words in sorted(vague, key=len, reverse=True):
        for m in _found(words, turn.text):
            mark(m, goal.object, "definite", explicit=False)
    for name in filter(None, (goal.object, goal.movable_receptacle)):
        for word in names()[name].words if name in names() else ():
            for m in _found(word, turn.text):
                mark(m, name, named_form(m[0], name), explicit=True)
    found.sort(key=lambda one: one.start)
    return Utterance(turn.speaker, turn.text, tuple(found))


def _vagueness(dialogue: Dialogue, goal: Goal) -> Vagueness:
    """Return the nearest of the nine levels: whether the object is named, and what surrounds it."""

    def named(turn: Utterance) -> bool:
        return any(one.explicit and one.referent == goal.object for one in turn.expressions)

    reference: Reference = "implicit"
    if named(dialogue.instruction):
        reference = "explicit"
    elif any(named(turn) for turn in dialogue.context):
        reference = "mixed"
    context: Context = "short" if len(dialogue.context) < SHORT else "standard"
    return Vagueness(reference, context)


def _check_solvable(episode: Episode) -> None:
    """Refuse what the expert cannot carry out here, or what is so already."""
    spec = RunSpec(planner="expert")
    with closing(make_world(spec)) as world:
        rollout = Rollout(episode, world, max_steps=spec.max_steps)
        if rollout.start().solved:
            raise ReibenchError("That is so already, before anybody does anything; ask for more.")
        steps = list(drive(rollout, Expert(episode.task.goal), Instruction("", "")))
    if rollout.status != "success":
        refused = next((s.event.message for s in reversed(steps) if not s.event.success), "")
        why = f" ({refused})" if refused else ""
        raise ReibenchError(
            f"Even a robot that knows what is meant could not do this here{why}; choose another"
            " object or place."
        )


class OwnEpisodes:
    """The episodes visitors worded, in one database."""

    def __init__(self, store: Store) -> None:
        self._store = store

    def keep(self, episode: Episode) -> None:
        """Keep an episode; one that is there already stays."""
        key = digest(episode)
        with self._store.writing() as database:
            database.execute(
                "insert or ignore into episodes values (?, ?, ?)",
                [key, episode.id, dump(episode_to_json(episode))],
            )
            database.execute(
                "insert or ignore into own_episodes values (?, ?, ?)", [episode.id, key, now()]
            )

    def find(self, episode_id: str) -> Episode | None:
        """Return the episode of that id, if there is one."""
        rows = self._store.query(
            "select json from own_episodes join episodes on digest = episode_digest"
            " where own_episodes.id = ?",
            [episode_id],
        )
        return episode_from_json(json.loads(rows[0]["json"])) if rows else None
