"""Lessons for the planner: a clear request, and the steps that carry it out."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from random import Random

from reibench.dataset.levels import derive
from reibench.dataset.realise.compose import CannotRealise, Realiser
from reibench.dataset.seeds import Seed
from reibench.dialogue import EXPLICIT_ALONE, Dialogue, Utterance, Vagueness
from reibench.episode import Episode, Goal, Task
from reibench.household import Room
from reibench.methods import Instruction
from reibench.methods.wording import human_turns
from reibench.planners import Decision
from reibench.planners.telling import told
from reibench.rollout import Rollout
from reibench.skill import DONE, PICKABLE, SLICEABLE, Skill, Verb
from reibench.tuning.phrasing import SEVERAL, Manner, aside, dressed, named, request
from reibench.tuning.teacher import Teacher, Wish
from reibench.tuning.wishes import wishes
from reibench.worlds import World

ALONE = 0.6
"""How many requests stand alone; before the others something is said, at the explicit level."""
OWN_WORDS = 0.65
"""How often a request after a dialogue is worded anew, not by the realiser."""
MUDDLED = 0.3
"""How often something goes wrong on the way that the robot has to put right."""
AMBIGUOUS = 0.3
"""How often a place is called by a word that others go by too, where there is one."""
SLICED = 0.3
"""How often a slice is asked for, of what can be sliced."""
SLIP = 0.25
"""How often it does at a step, then."""
EXPLICIT = tuple(Vagueness("explicit", context) for context in ("standard", "noised", "short"))


@dataclass(frozen=True)
class Move:
    """One thing the robot did."""

    skill: str
    failure: str = ""
    """What it was told if that failed."""
    taught: bool = True
    """Whether it should be learnt; a slip is only there to be put right."""


@dataclass(frozen=True)
class Lesson:
    """A request and how it was carried out."""

    told: str
    """The prompt up to where the robot's steps begin."""
    moves: tuple[Move, ...]


def lessons(rooms: Sequence[Room], worlds: Sequence[World], seed: int) -> Iterator[Lesson]:
    """Yield lessons without end; the same rooms, worlds and seed give the same.

    Args:
        rooms: where they take place.
        worlds: one for each kind of rules; they take turns.
        seed: decides.
    """
    realiser = Realiser()
    for number, found in enumerate(wishes(rooms, seed)):
        choose = Random(f"lesson/{seed}/{number}")
        found = _maybe_sliced(found, choose)
        world = worlds[number % len(worlds)]
        wish, said = _asked(found, realiser, choose)
        if said is None:
            continue
        moves = carry_out(found.task, wish, world, choose)
        if moves:
            yield Lesson(f"{told(said)}Robot:", moves)


def asked_for(rooms: Sequence[Room], seed: int) -> Iterator[tuple[Episode, Instruction]]:
    """Yield tasks as lessons ask for them, whether or not the teacher can carry them out."""
    realiser = Realiser()
    for number, found in enumerate(wishes(rooms, seed)):
        choose = Random(f"lesson/{seed}/{number}")
        found = _maybe_sliced(found, choose)
        _, said = _asked(found, realiser, choose)
        if said is not None:
            unsaid = Dialogue((Utterance("human", said.text),))
            yield Episode(found.task, unsaid, EXPLICIT_ALONE), said


def _maybe_sliced(found: Seed, choose: Random) -> Seed:
    goal = found.task.goal
    knife = {"Knife", "ButterKnife"} & set(found.present)
    if goal.object not in SLICEABLE or not knife or choose.random() > SLICED:
        return found
    return replace(found, task=replace(found.task, goal=replace(goal, sliced=True)))


def _asked(found: Seed, realiser: Realiser, choose: Random) -> tuple[Wish, Instruction | None]:
    """Choose how a task is asked for."""
    goal = found.task.goal
    word, meanings = _ambiguous(goal, choose)
    wish = Wish(goal, meanings)
    own = dressed(request(goal, named(goal, choose, word), choose), choose, Manner())
    if choose.random() < ALONE:
        return wish, Instruction(own, own)
    try:
        script = realiser.realise(found.task, found.present, found.task.id)
    except CannotRealise:
        return wish, None
    [episode] = derive(script, [choose.choice(EXPLICIT)])
    before = list(human_turns(episode.dialogue))
    others = [name for name in found.present if name in PICKABLE and name not in goal.objects]
    for place in range(len(before)):
        if others and choose.random() < 0.3:
            before[place] += " " + aside(others, choose)
    if choose.random() < OWN_WORDS:
        chatty = dressed(
            request(goal, named(goal, choose, word), choose), choose, Manner(chatter=0.8)
        )
        return wish, Instruction(chatty, chatty, context=tuple(before))
    asked = episode.dialogue.instruction.text
    return Wish(goal), Instruction(asked, asked, context=tuple(before))


def _ambiguous(goal: Goal, choose: Random) -> tuple[str, dict[str, Sequence[str]]]:
    """Choose a word that several types of places go by, sometimes, and say what it may mean."""
    words = [word for word, types in SEVERAL.items() if goal.destination in types]
    if not words or choose.random() > AMBIGUOUS:
        return "", {}
    word = choose.choice(words)
    return word, {goal.destination: SEVERAL[word]}


def carry_out(task: Task, wish: Wish, world: World, choose: Random) -> tuple[Move, ...]:
    """Let the teacher carry out a wish, muddling it now and then; nothing if it did not succeed."""
    unsaid = Dialogue((Utterance("human", ""),))
    rollout = Rollout(Episode(task, unsaid, EXPLICIT_ALONE), world)
    plan = Teacher(wish).plan(None, rollout.start(), world.skills)
    slips = choose.random() < MUDDLED
    moves: list[Move] = []
    decision = next(plan, None)
    while decision is not None and not rollout.over:
        if slips and choose.random() < SLIP and (slip := _slip(decision.skill, rollout, choose)):
            moves.append(_done(rollout, Decision(slip), taught=False))
            slips = choose.random() < 0.3
            if rollout.over:
                break
        moves.append(_done(rollout, decision))
        try:
            decision = plan.send(rollout.last_event)
        except StopIteration:
            decision = None
    solved = rollout.status == "success" and not rollout.over
    return (*moves, Move(DONE)) if solved else ()


def _done(rollout: Rollout, decision: Decision, *, taught: bool = True) -> Move:
    event = rollout.step(decision).event
    return Move(str(decision.skill), "" if event.success else event.message, taught)


def _slip(wanted: Skill, rollout: Rollout, choose: Random) -> Skill | None:
    """Return what one may wrongly do instead of `wanted`: too early, or with another thing."""
    scene = rollout.last_event.scene
    held = scene.held
    if choose.random() < 0.3:
        names = [o.type for o in scene.objects if o.type in PICKABLE and o.id in scene.visible]
        if names and held is None:
            return Skill(Verb.PICK_UP, choose.choice(names))
    if held is not None and held.type in PICKABLE and wanted.verb in (Verb.FIND, Verb.OPEN):
        return Skill(Verb.PUT_DOWN, held.type)
    if wanted.verb is Verb.FIND and wanted.object in PICKABLE:
        return Skill(Verb.PICK_UP, wanted.object)
    return None
