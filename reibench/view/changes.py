"""What a step changed in the room, in words."""

from collections.abc import Iterator

from reibench.goals import preposition
from reibench.scene import Scene, SceneObject
from reibench.view.containment import support
from reibench.view.words import name, noun

_STATES = (
    ("open", "is open", "is closed"),
    ("on", "is on", "is off"),
    ("sliced", "is sliced", ""),
    ("broken", "is broken", ""),
    ("dirty", "is dirty", "is clean"),
    ("cooked", "is cooked", ""),
    ("filled", "is filled", "is empty"),
)
MOST = 4
"""How many changes are named; the rest are counted."""


def changes(before: Scene, after: Scene) -> str:
    """Return a sentence about what differs between two moments of a room; never empty."""
    found = list(dict.fromkeys(_changes(before, after)))
    if not found:
        moved = before.agent.position != after.agent.position
        return "The robot moved." if moved else "Nothing changed."
    more = len(found) - MOST
    if more > 0:
        found = [*found[:MOST], f"{more} more thing{'s' if more > 1 else ''} changed"]
    words = "; ".join(found)
    return words[:1].upper() + words[1:] + "."


def _changes(before: Scene, after: Scene) -> Iterator[str]:
    for thing in after.objects:
        old = before.by_id.get(thing.id)
        if old is None:
            yield f"there is {name(thing.type)} now"
            continue
        yield from _moved(old, thing, before, after)
        for state, yes, no in _STATES:
            was, holds = getattr(old, state), getattr(thing, state)
            if was != holds and (words := yes if holds else no):
                yield f"the {noun(thing.type)} {words}"
        if old.temperature != thing.temperature and thing.pickupable:
            warmth = {"Hot": "hot", "Cold": "cold"}.get(thing.temperature, "at room temperature")
            yield f"the {noun(thing.type)} is {warmth}"


def _moved(old: SceneObject, thing: SceneObject, before: Scene, after: Scene) -> Iterator[str]:
    if thing.held and not old.held:
        under = support(old, before)
        left = f" left the {name(under.type)} and" if under else ""
        yield f"the {noun(thing.type)}{left} is now held"
    elif old.held and not thing.held:
        under = support(thing, after)
        where = f"{preposition(under.type)} the {name(under.type)}" if under else "on the floor"
        yield f"the {noun(thing.type)} is now {where}"
