"""How pages call things, places and states."""

from reibench.goals import preposition
from reibench.scene import CONTAINERS, Scene, SceneObject
from reibench.skill import in_words, with_article

STATES = ("open", "on", "hot", "cold", "dirty", "sliced", "cooked", "filled", "broken")
"""States that are shown, in the order of their badges."""
_TRANSFORMED = {"Sliced": "sliced", "Cracked": "cracked"}


def noun(object_type: str) -> str:
    """Return the word the skills use for this type: slices of an apple are `apple`."""
    for ending in _TRANSFORMED:
        object_type = object_type.removesuffix(ending)
    return in_words(object_type)


def name(object_type: str) -> str:
    """Return how a page calls this type, e.g. `sliced apple`."""
    for ending, adjective in _TRANSFORMED.items():
        if object_type.endswith(ending):
            return f"{adjective} {noun(object_type)}"
    return in_words(object_type)


def states(thing: SceneObject) -> tuple[str, ...]:
    """Return the states of `thing` that are worth showing."""
    holds = {
        "open": thing.open,
        "on": thing.on,
        "hot": thing.temperature == "Hot",
        "cold": thing.temperature == "Cold",
        "dirty": thing.dirty,
        "sliced": thing.sliced or thing.type.endswith("Sliced"),
        "cooked": thing.cooked,
        "filled": thing.filled,
        "broken": thing.broken,
    }
    return tuple(state for state in STATES if holds[state])


def support(thing: SceneObject, scene: Scene) -> SceneObject | None:
    """Return what `thing` rests in or on: of several, the one whose top is nearest to its bottom."""
    parents = [scene.by_id[parent] for parent in thing.parents if parent in scene.by_id]
    if len(parents) < 2:
        return parents[0] if parents else None
    containers = [parent for parent in parents if parent.type in CONTAINERS]
    if containers:
        return containers[0]
    bottom = thing.box.center.y - thing.box.size.y / 2

    def gap(parent: SceneObject) -> float:
        return abs(parent.box.center.y + parent.box.size.y / 2 - bottom)

    return min(parents, key=gap)


def place(thing: SceneObject, scene: Scene) -> str:
    """Return where `thing` is, e.g. `on the counter top`; empty where that says nothing."""
    if thing.held:
        return "in the robot's hand"
    under = support(thing, scene)
    if under is None:
        return ""
    return f"{preposition(under.type)} the {name(under.type)}"


def described(thing: SceneObject, scene: Scene) -> str:
    """Return one line about `thing`: name, place, states and, if it is open, whether it is empty."""
    parts = [name(thing.type), place(thing, scene), *states(thing)]
    if is_empty(thing):
        parts.append("empty")
    return ", ".join(filter(None, parts))


def is_empty(thing: SceneObject) -> bool:
    """Whether `thing` is an open container with nothing in it."""
    return thing.type in CONTAINERS and thing.open and not thing.contents


def a(object_type: str) -> str:
    """Return the name of this type with its indefinite article."""
    return with_article(name(object_type))
