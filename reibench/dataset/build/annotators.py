"""Seeds that people wrote: sorting ALFRED's instructions into what can be built on and what not."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from reibench.dataset.alfred import Trial, in_names_of, task_of
from reibench.dataset.build.asking import Unfit
from reibench.dataset.build.marking import Named, named_mentions
from reibench.dataset.build.seeding import SeedInstruction
from reibench.dataset.forms import names, says
from reibench.dataset.realise.nouns import place_words
from reibench.dataset.script_check import COOLING, HEATING, LIGHTING
from reibench.episode import Goal, TaskType
from reibench.errors import ReibenchError
from reibench.household import load_room
from reibench.household.objects import object_types

OTHER_NAMES: Mapping[str, tuple[str, ...]] = {
    "Bottle": ("glass bottle",),
    "ButterKnife": ("knife",),
    "CellPhone": ("cell",),
    "Cup": ("glass",),
    "HandTowel": ("towel",),
    "Kettle": ("tea pot", "teapot"),
    "Laptop": ("computer",),
    "Mug": ("cup",),
    "SoapBottle": ("soap",),
    "SprayBottle": ("cleaner", "spray"),
    "Statue": ("trophy", "ornament"),
    "TissueBox": ("tissue",),
}
"""Ordinary names besides those of the lexicon, sound where the room has nothing else called so."""
_TREATED = {
    TaskType.HEAT: HEATING + "|bak",
    TaskType.COOL: COOLING + "|freez",
    TaskType.CLEAN: "wash|rins|clean|scrub|wet|damp",
}
"""Words that say the treatment; annotators saw water run and often wrote just *wet*."""
_SLICED = re.compile(r"\b(?:slic|cut|knife|piece|chop|half)", re.IGNORECASE)
_KNIFE = re.compile(r"(?<!with a )(?<!with the )(?<!using a )(?<!using the )\bknife", re.IGNORECASE)
_OFF = re.compile(r"\bturn(?:ing|ed)?\b[^.]*\boff\b", re.IGNORECASE)
_FROM = re.compile(
    r"\b(?:from|off|out of) (?:of )?(?:the|a|an) [\w ]+?(?= to | into | in | on |,|\.|$)", re.I
)


@dataclass(frozen=True)
class WrittenSeed:
    """A trial in the words of an annotator who says what its goal is, and names the things."""

    seed: SeedInstruction
    nouns: Mapping[str, str]
    """The annotator's nouns, by object type."""
    place: str
    """What the annotator calls the destination or the lamp, without an article."""


@dataclass(frozen=True)
class Sorted:
    """What an instruction is good for."""

    trial: Trial
    number: int
    text: str
    written: WrittenSeed | None
    reason: str = ""
    """Why it is dropped."""


def sort(trial: Trial) -> Iterator[Sorted]:
    """Yield what each annotator's instruction of a trial is good for."""
    trial, present = _settled(trial)
    for number, ask in enumerate(trial.asks):
        try:
            yield Sorted(trial, number, ask.text, read(trial, number, present))
        except Unfit as problem:
            yield Sorted(trial, number, ask.text, None, problem.reason)


def _settled(trial: Trial) -> tuple[Trial, tuple[str, ...]]:
    """Return the trial in the names of its room, and the types that are there."""
    lying = {pose.type for pose in trial.setup.poses}
    try:
        objects = load_room(trial.setup.room).objects
    except ReibenchError:  # the room has not been imported: what lies about is known all the same
        goal = trial.goal
        named = {goal.object, goal.destination, goal.movable_receptacle} if goal else set()
        return trial, tuple(sorted((lying | named) - {""}))
    fixed = {thing.type for thing in objects if not thing.pickupable}
    return in_names_of(objects, trial), tuple(sorted(lying | fixed))


def read(trial: Trial, number: int, present: Sequence[str]) -> WrittenSeed:
    """Return the seed in an annotator's words.

    Raises:
        Unfit: when the words do not say the goal, say more or other than it, or do not name things.
    """
    goal, text = trial.goal, trial.asks[number].text
    if goal is None:
        raise Unfit("about two objects", "Tasks with two objects are left out.")
    if not text:
        raise Unfit("nothing written", "The annotator wrote nothing.")
    # where it lies now is no part of the request, but light does come from a lamp
    said = text if goal.task_type is TaskType.EXAMINE else _FROM.sub("", text)
    _check_goal(goal, said)
    nouns = {
        name: _noun(name, said, goal, present)
        for name in filter(None, (goal.object, goal.movable_receptacle))
    }
    place = _place(goal, said, present)
    seed = SeedInstruction(task_of(trial, number), tuple(present), text)
    return WrittenSeed(seed, nouns, place)


def _check_goal(goal: Goal, text: str) -> None:
    if goal.task_type in _TREATED and not re.search(
        rf"\b(?:re|micro)?(?:{_TREATED[goal.task_type]})", text, re.IGNORECASE
    ):
        raise Unfit("the goal is not said", f"{text!r} leaves out what is to be done.")
    if goal.task_type is TaskType.EXAMINE:
        if _OFF.search(text):
            raise Unfit("other than the goal", f"{text!r} switches the lamp off.")
        if not re.search(LIGHTING, text, re.IGNORECASE):
            raise Unfit("the goal is not said", f"{text!r} does not speak of the light.")
    others = {kind: words for kind, words in _TREATED.items() if kind is not goal.task_type}
    more = [
        kind for kind, words in others.items() if re.search(rf"\b(?:{_VERBS[kind]})", text, re.I)
    ]
    if more:
        raise Unfit("more than the goal", f"{text!r} also asks for something else.")
    cut = _SLICED.search(text) is not None
    if goal.sliced and not cut:
        raise Unfit("the goal is not said", f"{text!r} does not speak of a slice.")
    if goal.sliced and _KNIFE.search(text):
        raise Unfit("more than the goal", f"{text!r} wants the knife put away, too.")
    if cut and not goal.sliced and "Knife" not in goal.object:
        raise Unfit("more than the goal", f"{text!r} speaks of cutting.")
    tool = "|".join(map(re.escape, names()[goal.object].words))
    if goal.task_type is TaskType.CLEAN and re.search(
        rf"\bwith (?:the |a )?(?:{tool})\b", text, re.I
    ):
        raise Unfit("other than the goal", f"{text!r} cleans something else.")


_VERBS = {
    TaskType.HEAT: "heat|warm|microwaved|hot|cook(?!er)",
    TaskType.COOL: "cool|chill|cold",
    TaskType.CLEAN: "wash(?! ?cloth)|rins|clean(?!er|ing)",
}
"""Words that ask for a treatment, wherever a place could not be meant."""


def _noun(name: str, text: str, goal: Goal, present: Sequence[str]) -> str:
    """Return the annotator's noun for a task object; raises Unfit where there is none."""
    word = next((word for word in names()[name].words if says(text, word)), "")
    if word:
        rivals = {n for n in present if n in names() and n != name and word in names()[n].words}
        if not rivals:
            return word
        raise Unfit("an ambiguous name", f"{word!r} in {text!r} may be a {min(rivals)}.")
    for other in OTHER_NAMES.get(name, ()):
        taken = {n for n in present if n != name and n in names() and other in names()[n].words}
        if says(text, other) and not taken:
            return ""  # an ordinary name, but not one that the checks would know: ours is used
    parts = {name, goal.destination, goal.movable_receptacle, goal.object}
    for wrong, known in names().items():
        if wrong not in parts and any(says(text, word) for word in known.words):
            raise Unfit("a wrong name", f"{text!r} speaks of a {wrong}, not of the {name}.")
    raise Unfit("no name", f"{text!r} does not name the {name}.")


def _place(goal: Goal, text: str, present: Sequence[str]) -> str:
    """Return the annotator's words for the destination; raises Unfit where they say another."""
    found = named_mentions(text, [("destination", goal.destination)])
    if not found:
        known = (place_words(name) for name in _furniture(present) if name != goal.destination)
        if any(says(text, words) for words in known):
            raise Unfit("other than the goal", f"{text!r} says another place.")
        raise Unfit("the place is not said", f"{text!r} does not say where to.")
    words = _bare(found[-1])
    if not words:
        return place_words(goal.destination)
    general = words.split()[-1] == words and words != place_words(goal.destination)
    rivals = [
        name
        for name in _furniture(present)
        if name != goal.destination and named_mentions(f"the {words}", [("destination", name)])
    ]
    return place_words(goal.destination) if general or rivals else words


def _furniture(present: Sequence[str]) -> list[str]:
    types = object_types()
    return [name for name in present if name in types and "pickupable" not in types[name].traits]


_PLAIN = frozenset(
    "armchair bath bathroom bathtub bedside big bin black book brown bottom burner cabinet can case"
    " center chair chest coffee couch counter countertop desk dining drawer drawers dresser end"
    " floor fridge garbage glass gray green grey hanger holder kitchen lamp large living lounge"
    " machine maker metal microwave night nightstand oak of ottoman oven paper plastic red"
    " refrigerator room round safe shelf side silver sink small sofa square stand standing stove"
    " basin cart cupboard footstool recliner sofa stool tv stand"
    " table tall toilet top trash tub tv waste white wicker wood wooden yellow".split()
)
"""Adjectives and nouns that describe a piece of furniture without saying where it stands."""


def _bare(named: Named) -> str:
    """Return a mention without its article and without words that point."""
    words = named.text.lower().split()
    return " ".join(word for word in words if word in _PLAIN)
