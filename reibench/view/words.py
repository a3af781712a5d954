"""How pages call things, places and states."""

from reibench.goals import preposition
from reibench.scene import Scene, SceneObject
from reibench.skill import in_words, with_article
from reibench.view.containment import is_empty, support

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


def place(thing: SceneObject, scene: Scene) -> str:
    """Return where `thing` is, e.g. `on the counter top`; empty where that says nothing."""
    if thing.held:
        return "in the robot's hand"
    under = support(thing, scene)
    if under is None:
        return ""
    return f"{preposition(under.type)} the {name(under.type)}"


def described(thing: SceneObject, scene: Scene) -> str:
    """Return one line about `thing`: name, place and states, `empty` among them."""
    parts = [name(thing.type), place(thing, scene), *states(thing)]
    if is_empty(thing):
        parts.append("empty")
    return ", ".join(filter(None, parts))


def sentence(words: str) -> str:
    """Return `words` with a capital letter and a full stop; messages of the world have neither."""
    words = words.strip()
    if not words:
        return ""
    return words[0].upper() + words[1:] + ("" if words.endswith((".", "!", "?")) else ".")


def a(object_type: str) -> str:
    """Return the name of this type with its indefinite article."""
    return with_article(name(object_type))
