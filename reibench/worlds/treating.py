"""What counts as heating, cooling and cleaning: ALFRED's three rules, kept since the reset."""

from reibench.goals import Treatments
from reibench.scene import Scene, SceneObject
from reibench.skill import Skill, Verb
from reibench.worlds.approach import distance

BASIN_DISTANCE = 1.0
"""Metres from a faucet within which a basin counts as under it."""


def treat(before: Treatments, skill: Skill, thing: SceneObject, scene: Scene) -> Treatments:
    """Return the treatments after `skill` was done to `thing`, as ALFRED keeps them.

    Heated: what is in a microwave when it is turned on. Cooled: what is in a fridge when it is
    closed. Cleaned: what is in the nearest sink basin when a faucet is turned on. Stove, toaster
    and coffee machine never count.
    """
    if skill.verb is Verb.TURN_ON and thing.type == "Microwave":
        return Treatments(before.heated | contents(scene, thing.id), before.cooled, before.cleaned)
    if skill.verb is Verb.CLOSE and thing.type == "Fridge":
        return Treatments(before.heated, before.cooled | contents(scene, thing.id), before.cleaned)
    if skill.verb is Verb.TURN_ON and thing.type == "Faucet":
        basins = [o for o in scene.objects if o.type in ("SinkBasin", "BathtubBasin")]
        near = [basin for basin in basins if distance(thing.position, basin) <= BASIN_DISTANCE]
        if near:
            basin = min(near, key=lambda basin: distance(thing.position, basin))
            cleaned = before.cleaned | contents(scene, basin.id)
            return Treatments(before.heated, before.cooled, cleaned)
    return before


def contents(scene: Scene, receptacle_id: str) -> frozenset[str]:
    """Return the ids of everything in a receptacle, and in what is in it and can be taken out."""
    found: set[str] = set()
    waiting = [receptacle_id]
    while waiting:
        thing = scene.by_id[waiting.pop()]
        # In real rooms a cup can hold the counter it stands on.
        loose = (each for each in thing.contents or () if scene.by_id[each].pickupable)
        fresh = [each for each in loose if each not in found]
        found.update(fresh)
        waiting.extend(fresh)
    return frozenset(found)
