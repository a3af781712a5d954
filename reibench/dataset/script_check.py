"""Checking a script: marks, counts, agreement, the ambiguous name, and what settles the rivals."""

import re
from collections import Counter
from collections.abc import Callable, Iterator

from reibench.dataset.forms import names, says
from reibench.dataset.grammar import agrees, text_problems
from reibench.dataset.levels import derive, said
from reibench.dataset.scripts import Script
from reibench.dialogue import Utterance, Vagueness
from reibench.episode import TaskType
from reibench.household.objects import object_types

TURNS = ("human", "robot") * 3 + ("human",)
LEAST_WORDS = 20
"""In each turn of the standard context (appendix B.1)."""
NAMED_IN_CONTEXT, UNNAMED_IN_CONTEXT, CUT = 3, 2, 2


def script_problems(script: Script) -> list[str]:
    """Return everything a program can see that is wrong with `script`, one sentence each."""
    found = list(_shape(script))
    if found:
        return found  # the other checks take the shape for granted
    for check in CHECKS:
        found += check(script)
    return found


def _shape(script: Script) -> Iterator[str]:
    speakers = tuple(turn.speaker for turn in script.turns)
    if speakers != TURNS:
        yield f"the turns are {', '.join(speakers)}, not six of human and robot, then the request"
    for _, _, mention in script.mentions:
        if mention.of != "object" and "movable" in mention.of and not _movable(script):
            yield f"{mention.named!r} is marked 2, but this task has no movable receptacle"


def _movable(script: Script) -> str:
    return script.goal.movable_receptacle


def _objects(script: Script) -> dict[str, str]:
    """Return the counted task objects by what their mentions are `of`."""
    found = {"object": script.goal.object, "movable": _movable(script)}
    return {key: name for key, name in found.items() if name}


def _lengths(script: Script) -> Iterator[str]:
    standard = derive(script)[0].dialogue
    for number, utterance in enumerate(standard.context, start=1):
        words = len(utterance.text.split())
        if words < LEAST_WORDS:
            yield f"turn {number} has {words} words without noise; it needs {LEAST_WORDS}"
    for episode in derive(script):
        for number, utterance in enumerate(episode.dialogue.utterances, start=1):
            if not utterance.text:
                yield f"turn {number} is empty at {episode.vagueness}"


def _counting(script: Script) -> Iterator[str]:
    last = len(script.turns) - 1
    for whose, name in _objects(script).items():
        mine = [(number, m) for number, _, m in script.mentions if whose in m.of.split("+")]
        context = [m for number, m in mine if number < last]
        request = [m for number, m in mine if number == last]
        if len(context) < NAMED_IN_CONTEXT:
            count = len(context)
            yield f"the context mentions the {name} {count} times, not {NAMED_IN_CONTEXT} or more"
        if not request:
            yield f"the request does not mention the {name}"
        for mention in [*context[1:], *request]:
            if not mention.unnamed:
                yield f"{mention.named!r} needs an unnamed form: only a first mention goes without"
    if not any(m.of == "destination" and number == last for number, _, m in script.mentions):
        yield f"the request does not mark <the {script.goal.destination}>"


def _first_mentions(script: Script) -> Iterator[str]:
    short = derive(script)[-1]
    for name in _objects(script).values():
        if any(_names(u, name) for u in short.dialogue.context):
            yield f"at implicit-short the context still names the {name}: mark its sentence with !"
        kept = [_names(u, name) for u in derive(script)[2].dialogue.context]
        if not any(kept):
            yield f"at explicit-short nothing names the {name} any more"


def _names(utterance: Utterance, name: str) -> bool:
    return any(e.explicit and name in e.referent.split("+") for e in utterance.expressions)


def _name_noise(script: Script) -> Iterator[str]:
    places = []
    for number, turn in enumerate(script.turns):
        for passage in turn.passages:
            text = "".join(
                p if isinstance(p, str) else f"{p.named} {p.unnamed}" for p in passage.parts
            )
            count = text.count(script.name)
            if count and passage.stay != "noise":
                yield f"{script.name!r} stands in turn {number + 1} outside noise"
            if passage.stay == "noise":
                places += [number] * count
                if not count:
                    yield f"the noise in turn {number + 1} does not say {script.name!r}"
                if any(passage.mentions):
                    yield f"the noise in turn {number + 1} mentions something of the task"
    if len(places) != 3:
        yield f"{script.name!r} stands {len(places)} times in the noise, not 3"
    if any(place % 2 or place == len(script.turns) - 1 for place in places):
        yield "noise belongs into the human's turns of the context"
    if any(count > 2 for count in Counter(places).values()):
        yield "no turn takes the ambiguous name more than twice"
    yield from _decoy(script)


def _decoy(script: Script) -> Iterator[str]:
    if script.decoy not in object_types():
        yield f"the decoy {script.decoy!r} is no object type"
    if script.decoy in {*_objects(script).values(), script.goal.destination}:
        yield f"the decoy {script.decoy} is part of the task"
    for name in _objects(script).values():
        if any(says(script.name, word) for word in names()[name].words):
            yield f"the name {script.name!r} gives the {name} away"


def _leaks(script: Script) -> Iterator[str]:
    """Find the task objects' names outside their marks, or inside an unnamed form."""
    outside = " … ".join(
        part if isinstance(part, str) else part.unnamed or "…"
        for turn in script.turns
        for passage in turn.passages
        for part in passage.parts
    )
    for name in _objects(script).values():
        for word in names()[name].words:
            if says(outside, word):
                yield f"{word!r} names the {name} outside a named mark"
                break
        for _, _, mention in script.mentions:
            whose = {"object": script.goal.object, "movable": _movable(script)}
            if whose.get(mention.of) == name and not any(
                says(mention.named, word) for word in names()[name].words
            ):
                yield f"{mention.named!r} does not name the {name}"


def _numbers(script: Script) -> Iterator[str]:
    for _, _, mention in script.mentions:
        if "+" in mention.of or mention.of == "destination" or not mention.unnamed:
            continue
        if not agrees(mention.unnamed, mention.named, _objects(script)[mention.of]):
            yield f"{mention.unnamed!r} does not agree in number with {mention.named!r}"


def _grammar(script: Script) -> Iterator[str]:
    seen = set()
    for episode in derive(script):
        for number, utterance in enumerate(episode.dialogue.utterances, start=1):
            for complaint in text_problems(utterance.text):
                if (number, complaint) not in seen:
                    seen.add((number, complaint))
                    yield f"turn {number} at {episode.vagueness}: {complaint}"


def _omissions(script: Script) -> Iterator[str]:
    cut = [p for turn in script.turns[:-1] for p in turn.passages if p.stay == "cut"]
    if len(cut) < CUT:
        yield f"short leaves out {len(cut)} passages; at least {CUT}, each in braces with -"
    if any(passage.stay != "always" for passage in script.turns[-1].passages):
        yield "the request is the same in every context: no braces in it"


def _rivals(script: Script) -> Iterator[str]:
    for name, words in script.rivals.items():
        if name not in object_types():
            yield f"the rival {name!r} is no object type"
        if name in _objects(script).values():
            yield f"the rival {name} is the task object itself"
        if words and not said(script, words, Vagueness("implicit", "standard")):
            yield f"the words that rule out the {name}, {words!r}, are not in the implicit context"
    short = Vagueness("implicit", "short")
    open_here = [n for n, w in script.rivals.items() if not (w and said(script, w, short))]
    marked = list(script.candidates.get(short, ())[1:])
    if sorted(open_here) != sorted(marked):
        stated, left = ", ".join(marked) or "none", ", ".join(open_here) or "none"
        yield f"at implicit-short the rivals left are {left}, but underdetermined says {stated}"
    for level, candidates in script.candidates.items():
        if candidates[0] not in _objects(script).values():
            yield f"the first candidate at {level} must be the task object"
        if level != short:
            yield f"{level} names the object in its context and cannot be underdetermined"


def _task(script: Script) -> Iterator[str]:
    for name in _objects(script).values():
        if name not in names():
            yield f"the lexicon has no names for {name}"
    heating = script.goal.task_type in (TaskType.HEAT, TaskType.COOL, TaskType.CLEAN)
    request = derive(script)[0].dialogue.instruction.text.lower()
    wanted = {TaskType.HEAT: HEATING, TaskType.COOL: COOLING, TaskType.CLEAN: CLEANING}
    if heating and not re.search(rf"\b(?:re)?(?:{wanted[script.goal.task_type]})", request):
        yield f"the request does not say that the {script.goal.object} is to be treated"
    if script.goal.task_type is TaskType.EXAMINE and not re.search(LIGHTING, request):
        yield "the request does not say that the light is to be on"


HEATING = r"hot|heat|warm|microwav|nuke|zap|toast|cook|steam"
COOLING = r"cold|cool|chill|fridge|ice|icy|refrigerat|frost"
CLEANING = r"wash|rins|clean|scrub|water|tap|faucet|suds|soap|under the|sponge"
LIGHTING = r"light|lamp|\bon\b|glow|bright|bulb|lit|shine"

Check = Callable[[Script], Iterator[str]]
CHECKS: tuple[Check, ...] = (
    _task, _lengths, _counting, _first_mentions, _name_noise, _leaks, _numbers, _grammar,
    _omissions, _rivals,
)  # fmt: skip
