"""PDDL problems: a room and what has been done in it, in the words of the household domain.

An object of a problem stands for a type, as the noun of a skill does. Where things are is left
out, since finding takes the robot to them; what they are shut in is said.
"""

from collections.abc import Iterable, Iterator

from reibench.household.objects import object_type
from reibench.planners.pddl import Action
from reibench.planners.pddl_goals import Fact, Role, Vocabulary, in_pddl
from reibench.scene import CONTAINERS, Scene, SceneObject
from reibench.skill import (
    FINDABLE,
    OPENABLE,
    PICKABLE,
    RECEPTACLES,
    SLICEABLE,
    TOGGLEABLE,
    Skill,
    Verb,
    in_words,
)
from reibench.worlds.approach import distance
from reibench.worlds.thor import BASIN_OF, KNIVES

LAMPS = ("DeskLamp", "FloorLamp")
BASIN = "Sink"
"""Where a faucet washes; that of a bathtub may be out of reach from where things are put in."""


def symbol(name: str) -> str:
    """Return what an object type is called in PDDL: `KeyChain` → `key-chain`."""
    return in_words(name).replace(" ", "-").lower()


_TYPE_OF = {symbol(name): name for name in FINDABLE}


def skill_of(action: Action) -> Skill:
    """Return the skill an action of the domain is."""
    return Skill(Verb(action.name.replace("-", " ")), _TYPE_OF[action.arguments[0]])


def vocabulary(scene: Scene) -> Vocabulary:
    """Return what goals may name in a room, and what can be done there."""
    present = _present(scene)

    def named(kinds: Iterable[str]) -> tuple[str, ...]:
        return tuple(symbol(name) for name in present if name in kinds)

    things = named(PICKABLE)
    pairs = [fact.arguments for fact in _fitting(present)]
    fitting = {name: tuple(place for thing, place in pairs if thing == name) for name in things}

    def treatable(where: str) -> tuple[str, ...]:
        return tuple(name for name in things if symbol(where) in fitting[name])

    objects: dict[Role, tuple[str, ...]] = {
        "thing": things,
        "place": named(RECEPTACLES),
        "heatable": treatable("Microwave"),
        "coolable": treatable("Fridge"),
        "washable": treatable(BASIN) if "Faucet" in present else (),
        "sliceable": named(SLICEABLE) if KNIVES & set(present) else (),
        "lamp": named(LAMPS),
    }
    return Vocabulary(objects, fitting)


def problem(scene: Scene, known: Iterable[Fact], goal: Iterable[Fact]) -> str:
    """Return the PDDL text of reaching `goal` from a scene, with what else is `known` of it."""
    known = tuple(known)
    present = _present(scene)
    objects = "\n".join(f"    {symbol(name)}" for name in present)
    groups = (_nature(scene, present), _fitting(present), _state(scene, present, known))
    facts = "\n".join(f"    {fact}" for group in groups for fact in dict.fromkeys(group))
    return (
        "(define (problem asked-for)\n  (:domain household)\n"
        f"  (:objects\n{objects})\n  (:init\n{facts})\n  {in_pddl(goal)})\n"
    )


def brought_about(skills: Iterable[Skill]) -> tuple[Fact, ...]:
    """Return what holds after `skills` all worked: what was treated, and where things were put."""
    place = held = ""
    treated: dict[Fact, None] = {}
    inside: dict[str, str] = {}
    lit: tuple[Fact, ...] = ()
    for skill in skills:
        name = symbol(skill.object)
        match skill.verb:
            case Verb.FIND:
                place, lit = name, ()
            case Verb.PICK_UP:
                held = name
                inside.pop(name, None)
            case Verb.PUT_DOWN:
                held, inside[name] = "", place
            case Verb.SLICE:
                treated = {fact: None for fact in treated if fact.arguments != (name,)}
                treated[Fact("sliced", (name,))] = None
            case Verb.TURN_ON if skill.object in LAMPS:
                lit = (Fact("lit", (held, name)),) if held else ()
            case Verb.TURN_ON | Verb.CLOSE:
                treated |= dict.fromkeys(_treatment(skill, inside))
    return (*treated, *(Fact("in", pair) for pair in inside.items()), *lit)


def _treatment(skill: Skill, inside: dict[str, str]) -> Iterator[Fact]:
    """Yield what turning on or closing something does to what is in it, or under it."""
    treats = {
        (Verb.TURN_ON, "Microwave"): ("hot", "Microwave"),
        (Verb.CLOSE, "Fridge"): ("cold", "Fridge"),
        (Verb.TURN_ON, "Faucet"): ("clean", BASIN),
    }
    treatment, where = treats.get((skill.verb, skill.object), ("", ""))
    within = [name for name, place in inside.items() if place == symbol(where)]
    yield from (Fact(treatment, (name,)) for name in within)


def _present(scene: Scene) -> tuple[str, ...]:
    """Return the types that skills can name and reach."""
    around = ((thing, scene.closed_around(thing)) for thing in scene.objects)
    reached = (thing for thing, shut in around if shut is None or shut.type in OPENABLE)
    types = {thing.type.removesuffix("Sliced") for thing in reached}
    return tuple(name for name in FINDABLE if name in types)


def _instances(scene: Scene, name: str) -> list[SceneObject]:
    return [*scene.of_type(name), *scene.of_type(f"{name}Sliced")]


def _nature(scene: Scene, present: tuple[str, ...]) -> Iterator[Fact]:
    """Yield what things are."""
    for name in present:
        natures = {
            "portable": name in PICKABLE,
            "openable": name in OPENABLE,
            "container": name in CONTAINERS,
            "switchable": name in TOGGLEABLE,
            "lamp": name in LAMPS,
            "sliceable": name in SLICEABLE,
            "cuts": name in KNIVES,
            "several": name in OPENABLE and len(scene.of_type(name)) > 1,
            "heats": name == "Microwave",
            "cools": name == "Fridge",
        }
        yield from (Fact(nature, (symbol(name),)) for nature, true in natures.items() if true)
    if BASIN in present and "Faucet" in present:
        yield Fact("washes", (symbol("Faucet"), symbol(BASIN)))


def _fitting(present: tuple[str, ...]) -> Iterator[Fact]:
    """Yield what may be put where."""
    for name in filter(PICKABLE.__contains__, present):
        belongs = object_type(name).belongs
        for place in filter(RECEPTACLES.__contains__, present):
            if place != name and (belongs(place) or belongs(BASIN_OF.get(place, place))):
                yield Fact("fits", (symbol(name), symbol(place)))


def _state(scene: Scene, present: tuple[str, ...], known: tuple[Fact, ...]) -> Iterator[Fact]:
    """Yield how things are."""
    held = scene.held.type.removesuffix("Sliced") if scene.held else ""
    yield Fact("holding", (symbol(held),)) if held in present else Fact("hand-empty", ())
    for name in present:
        things = scene.of_type(name)
        if name in OPENABLE and things and all(thing.open for thing in things):
            yield Fact("opened", (symbol(name),))
        if name in TOGGLEABLE and things and all(thing.on for thing in things):
            yield Fact("switched-on", (symbol(name),))
        if name in SLICEABLE and not things:
            yield Fact("sliced", (symbol(name),))
        if container := _shut_in(scene, name, known):
            yield Fact("shut-in", (symbol(name), symbol(container)))
            yield Fact("in", (symbol(name), symbol(container)))
    yield from (fact for fact in known if fact.predicate != "lit")


def _shut_in(scene: Scene, name: str, known: tuple[Fact, ...]) -> str:
    """Return the type of the closed container that finding a `name` leads to; empty if none."""
    for container in CONTAINERS & set(FINDABLE):
        put_there = Fact("in", (symbol(name), symbol(container))) in known
        if put_there and not any(thing.open for thing in scene.of_type(container)):
            return container
    things = [thing for thing in _instances(scene, name) if not thing.held]
    around = [scene.closed_around(thing) for thing in things]
    closed = [container for container in around if container]
    if not closed or len(closed) < len(things):
        return ""
    robot = scene.agent.position
    return min(closed, key=lambda c: (c.id not in scene.visible, distance(robot, c))).type
