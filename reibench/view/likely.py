"""Which skills are likely next: what is in reach and what the robot holds. For the demo only.

Nothing is ever left out of the picker because of this; it only orders what is offered first.
"""

import math
from collections.abc import Iterator, Sequence

from reibench.rollout import Step
from reibench.scene import Scene, SceneObject
from reibench.skill import OPENABLE, PICKABLE, SLICEABLE, TOGGLEABLE, Skill, Verb

MOST = 7
"""How many skills are offered at most."""
_CUTTING = ("Knife", "ButterKnife")


def likely(scene: Scene, steps: Sequence[Step]) -> tuple[Skill, ...]:
    """Return the skills that suit what is in reach, the likeliest first."""
    found: list[Skill] = []
    for skill in _candidates(scene, steps):
        if skill not in found:
            found.append(skill)
    return tuple(found[:MOST])


def _candidates(scene: Scene, steps: Sequence[Step]) -> Iterator[Skill]:
    if scene.held and scene.held.type.removesuffix("Sliced") in PICKABLE:
        yield Skill(Verb.PUT_DOWN, scene.held.type.removesuffix("Sliced"))
    near = last_found(steps)
    reach = sorted(
        (thing for thing in scene.objects if thing.id in scene.visible and not thing.held),
        key=lambda thing: (thing.type != near, _distance(thing, scene)),
    )
    for thing in reach:
        yield from _doors(thing)
    for thing in reach:
        yield from _on_things(thing, scene)


def last_found(steps: Sequence[Step]) -> str:
    """Return the type of what the robot went to last; empty if it went nowhere yet."""
    for step in reversed(steps):
        if step.event.success and step.decision.skill.verb is Verb.FIND:
            return step.decision.skill.object
    return ""


def _doors(thing: SceneObject) -> Iterator[Skill]:
    if thing.type in TOGGLEABLE and not thing.open:
        yield Skill(Verb.TURN_OFF if thing.on else Verb.TURN_ON, thing.type)
    if thing.type in OPENABLE and not thing.on:
        yield Skill(Verb.CLOSE if thing.open else Verb.OPEN, thing.type)


def _on_things(thing: SceneObject, scene: Scene) -> Iterator[Skill]:
    kind = thing.type.removesuffix("Sliced")
    if scene.held is None and thing.pickupable and kind in PICKABLE:
        yield Skill(Verb.PICK_UP, kind)
    cutting = scene.held is not None and scene.held.type in _CUTTING
    if cutting and thing.sliceable and not thing.sliced and kind in SLICEABLE:
        yield Skill(Verb.SLICE, kind)


def _distance(thing: SceneObject, scene: Scene) -> float:
    here, there = scene.agent.position, thing.box.center
    return math.hypot(here.x - there.x, here.z - there.z)
