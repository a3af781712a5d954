"""Goal conditions of the six task types, over scenes (ALFRED's tests, section 3.2)."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from reibench.episode import Goal, TaskType
from reibench.scene import Scene, SceneObject
from reibench.skill import in_words, with_article

Matches = Callable[[SceneObject, str], bool]
"""Whether an object counts as one of the wanted type; strict and official rules differ here."""


@dataclass(frozen=True)
class Condition:
    """One thing that must hold, in words, and whether it does."""

    name: str
    """Kind of condition, e.g. `placed`, `heated`, `heated-and-placed`."""
    text: str
    """What must hold, e.g. `a heated potato is on the dining table`."""
    holds: bool


@dataclass(frozen=True)
class Treatments:
    """Ids of what has been heated, cooled and cleaned since the episode began; never shrinks."""

    heated: frozenset[str] = frozenset()
    cooled: frozenset[str] = frozenset()
    cleaned: frozenset[str] = frozenset()


TREATMENT_OF = {TaskType.HEAT: "heated", TaskType.COOL: "cooled", TaskType.CLEAN: "cleaned"}
_SURFACES = frozenset(
    "ArmChair Bed CoffeeTable CounterTop Desk DiningTable Dresser Floor Ottoman Shelf SideTable"
    " Sofa StoveBurner TVStand Toilet ToiletPaperHanger Plate Stool Chair Footstool".split()
)


def preposition(receptacle: str) -> str:
    """Return `on` or `in`, whichever one says of this receptacle type."""
    return "on" if receptacle in _SURFACES else "in"


def check(
    goal: Goal, scene: Scene, treatments: Treatments, matches: Matches
) -> tuple[Condition, ...]:
    """Return every condition of `goal` and whether it holds in `scene`, in ALFRED's order."""
    wanted = goal.object + ("Sliced" if goal.sliced else "")
    candidates = [thing for thing in scene.objects if thing.pickupable and matches(thing, wanted)]
    conditions = list(_CHECKS[goal.task_type](goal, scene, treatments, matches, candidates))
    if goal.sliced:
        text = f"{with_article(in_words(goal.object))} is sliced"
        conditions.insert(0, Condition("sliced", text, bool(candidates)))
    return tuple(conditions)


def satisfied(conditions: Iterable[Condition]) -> bool:
    """Whether all conditions hold (and there is at least one)."""
    held = [condition.holds for condition in conditions]
    return bool(held) and all(held)


def _thing(goal: Goal, treated: str = "") -> str:
    words = " ".join(
        filter(None, (treated, "sliced" if goal.sliced else "", in_words(goal.object)))
    )
    return with_article(words)


def _inside(
    things: Iterable[SceneObject], scene: Scene, receptacle: str, matches: Matches
) -> list[SceneObject]:
    """Return those of `things` that lie in or on a receptacle of this type."""
    found = []
    for thing in things:
        parents = (scene.by_id[parent] for parent in thing.parents if parent in scene.by_id)
        if any(parent.receptacle and matches(parent, receptacle) for parent in parents):
            found.append(thing)
    return found


def _place(goal: Goal, treated: str = "") -> str:
    where = f"{preposition(goal.destination)} {with_article(in_words(goal.destination))}"
    return f"{_thing(goal, treated)} is {where}"


def _check_pick(
    goal: Goal,
    scene: Scene,
    treatments: Treatments,
    matches: Matches,
    candidates: list[SceneObject],
) -> Iterable[Condition]:
    placed = _inside(candidates, scene, goal.destination, matches)
    yield Condition("placed", _place(goal), bool(placed))


def _check_treated(
    goal: Goal,
    scene: Scene,
    treatments: Treatments,
    matches: Matches,
    candidates: list[SceneObject],
) -> Iterable[Condition]:
    kind = TREATMENT_OF[goal.task_type]
    ids: frozenset[str] = getattr(treatments, kind)
    placed = _inside(candidates, scene, goal.destination, matches)
    treated = [thing for thing in candidates if thing.id in ids]
    both = [thing for thing in placed if thing.id in ids]
    yield Condition("placed", _place(goal), bool(placed))
    yield Condition(kind, f"{_thing(goal)} has been {kind}", bool(treated))
    yield Condition(f"{kind}-and-placed", _place(goal, kind), bool(both))


def _check_stack(
    goal: Goal,
    scene: Scene,
    treatments: Treatments,
    matches: Matches,
    candidates: list[SceneObject],
) -> Iterable[Condition]:
    movable = [
        thing
        for thing in scene.objects
        if thing.pickupable and thing.receptacle and matches(thing, goal.movable_receptacle)
    ]
    carrier = with_article(in_words(goal.movable_receptacle))
    inside = _inside(candidates, scene, goal.movable_receptacle, matches)
    placed = _inside(movable, scene, goal.destination, matches)
    loaded = {parent for thing in inside for parent in thing.parents}
    where = f"{preposition(goal.destination)} {with_article(in_words(goal.destination))}"
    on = preposition(goal.movable_receptacle)
    yield Condition("stacked", f"{_thing(goal)} is {on} {carrier}", bool(inside))
    yield Condition("carrier-placed", f"{carrier} is {where}", bool(placed))
    both = any(thing.id in loaded for thing in placed)
    yield Condition("stacked-and-placed", f"{_thing(goal)} is {on} {carrier} {where}", both)


def _check_examine(
    goal: Goal,
    scene: Scene,
    treatments: Treatments,
    matches: Matches,
    candidates: list[SceneObject],
) -> Iterable[Condition]:
    held = any(thing.held for thing in candidates)
    lit = any(
        thing.on and thing.id in scene.visible and matches(thing, goal.destination)
        for thing in scene.objects
        if thing.toggleable
    )
    yield Condition("held", f"the robot holds {_thing(goal)}", held)
    lamp = with_article(in_words(goal.destination))
    yield Condition("lit", f"{lamp} is on and in view", lit)


_CHECKS = {
    TaskType.PICK: _check_pick,
    TaskType.HEAT: _check_treated,
    TaskType.COOL: _check_treated,
    TaskType.CLEAN: _check_treated,
    TaskType.STACK: _check_stack,
    TaskType.EXAMINE: _check_examine,
}
