"""What became of a trial's objects: poses, parents, and what the expert's plan needs."""

from collections import Counter
from collections.abc import Iterator, Sequence
from math import dist

from reibench.dataset.alfred import PlanAction, Trial
from reibench.dataset.alfred.furniture import same_piece
from reibench.scene import Scene, SceneObject
from reibench.worlds.restoring import Restored, ids, restored

EXACT = 0.02
"""Metres from its pose within which a thing counts as exactly there."""
BESIDE = 0.5
"""Metres within which it counts as put back where it was: the furniture is a little elsewhere."""
PICKED = 0.15
"""Metres between an object's pose and the place in its id within which they are the same."""
BASINS = {"SinkBasin": "Sink", "BathtubBasin": "Bathtub"}


def restoration(before: Scene, after: Scene, trial: Trial) -> Counter[str]:
    """Count what was honoured; `before` is the room as loaded, `after` as set up."""
    plan = restored(before, trial.setup.poses)
    placed = list(zip(plan, ids(before, plan), strict=True))
    counts: Counter[str] = Counter(poses=len(plan))
    for each, object_id in placed:
        counts[_honoured(each, object_id, after)] += 1
        counts["copies"] += object_id not in before.by_id
    gone = [o for o in before.objects if o.pickupable and o.id not in after.by_id]
    counts["removed"] = len(gone)
    counts.update(_parents(trial.plan, placed, after))
    counts.update(_needed(trial, after))
    start = trial.setup.start
    counts["starts"] = 1
    if start is not None:
        moved = dist(start.position._replace(y=0.0), after.agent.position._replace(y=0.0))
        counts["starts_exact"] = int(moved <= EXACT)
    return counts


def _honoured(each: Restored, object_id: str, scene: Scene) -> str:
    thing = scene.by_id.get(object_id)
    if thing is None:
        return "lost"
    if each.receptacle and each.receptacle not in _around(thing, scene):
        return "elsewhere"
    shift = dist(thing.position, each.wanted.position)
    if shift <= EXACT:
        return "exact"
    return "same_receptacle" if shift <= BESIDE else "moved"


def _around(thing: SceneObject, scene: Scene) -> set[str]:
    """Return the ids of all that a thing is in or on, however deep."""
    found: set[str] = set()
    waiting = list(thing.parents)
    while waiting:
        parent = waiting.pop()
        if parent not in found and parent in scene.by_id:
            found.add(parent)
            waiting.extend(scene.by_id[parent].parents)
    return found


def _parents(
    plan: Sequence[PlanAction], placed: Sequence[tuple[Restored, str]], scene: Scene
) -> Iterator[str]:
    """Yield a word for each object whose receptacle the plan tells as it picks the object up."""
    for action in plan:
        if action.name != "PickupObject" or not action.receptacle or action.at is None:
            continue
        near = [
            (dist(each.wanted.position, action.at), object_id)
            for each, object_id in placed
            if each.wanted.type == action.object
        ]
        distance, object_id = min(near, default=(PICKED + 1, ""))
        if distance > PICKED:
            continue  # the plan itself put it there
        yield "parents_told"
        thing = scene.by_id[object_id]
        parents = [scene.by_id[name] for name in thing.parents if name in scene.by_id]
        if any(_kind(parent.type) == _kind(action.receptacle) for parent in parents):
            yield "parents_honoured"
        elif any(same_piece(parent, action.receptacle_at) for parent in parents):
            yield "parents_renamed"


def _needed(trial: Trial, scene: Scene) -> Iterator[str]:
    """Yield a word for each type that the plan acts on, and for each that the room has."""
    there = {_kind(thing.type) for thing in scene.objects}
    acted = [action for action in trial.plan if action.name not in ("GotoLocation", "NoOp")]
    for name, kinds in (
        ("objects", {action.object for action in acted}),
        ("receptacles", {action.receptacle for action in acted} - {""}),
    ):
        for kind in kinds:
            yield f"{name}_named"
            if _kind(kind) in there:
                yield f"{name}_found"


def _kind(name: str) -> str:
    return BASINS.get(name, name)
