"""Restoring an ALFRED trial's object poses in AI2-THOR 5, whose rooms and names are others.

ALFRED recorded its poses in AI2-THOR 2.1 and names objects by hashes that 5.x changed. So poses are
matched by type, and where the furniture has moved a thing goes to the nearest place for it.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import permutations
from math import dist

from reibench.episode import ObjectPose
from reibench.errors import InvalidEpisode
from reibench.household.geometry import bottom, top
from reibench.household.objects import SURFACES
from reibench.household.placement import surface
from reibench.household.resting import AT_REST, posed, resting_place
from reibench.scene import Scene, SceneObject, Vector

MOST_MATCHINGS = 7
"""Of more things of one type than this, each in turn takes its nearest pose."""
INSIDE = 0.02
"""Metres within a receptacle's edge to which a thing beside it is moved."""


@dataclass(frozen=True)
class Restored:
    """What a pose of a trial became."""

    wanted: ObjectPose
    name: str
    """The object's name in this room; copies share it."""
    position: Vector
    """Where it is to go: as wanted, or in or on the receptacle nearest to that."""
    receptacle: str
    """Id of what it ends in or on."""


def restored(scene: Scene, poses: Sequence[ObjectPose]) -> list[Restored]:
    """Say which object of `scene` takes each pose, and where exactly; originals before copies.

    Raises:
        InvalidEpisode: when the room has no object of a pose's type.
    """
    fixed = [o for o in scene.objects if o.receptacle and not o.pickupable]
    by_type: dict[str, list[ObjectPose]] = defaultdict(list)
    for pose in poses:
        by_type[pose.type].append(pose)
    made = []
    for kind, wanted in by_type.items():
        things = [o for o in scene.of_type(kind) if o.pickupable or o.moveable]
        if not things:
            raise InvalidEpisode(f"The room {scene.room} has no {kind} that could be put anywhere.")
        made += [_settle(thing, pose, fixed) for thing, pose in _matched(things, wanted)]
    return made


def action_poses(scene: Scene, restorations: Sequence[Restored]) -> list[dict[str, object]]:
    """Return AI2-THOR's `objectPoses`: the restored things, and all furniture as it is.

    Furniture that is not named would be taken away.
    """
    furniture = [_pose(o.name, o.position, Vector(0.0, o.yaw, 0.0)) for o in _furniture(scene)]
    return furniture + [_pose(r.name, r.position, r.wanted.rotation) for r in restorations]


def ids(scene: Scene, restorations: Sequence[Restored]) -> list[str]:
    """Return the ids restored things get: AI2-THOR numbers copies by their place in the list."""
    by_name = {thing.name: thing.id for thing in scene.objects}
    first = sum(1 for _ in _furniture(scene))
    seen: set[str] = set()
    found = []
    for place, each in enumerate(restorations, start=first):
        copied = f"_copy_{place}" if each.name in seen else ""
        seen.add(each.name)
        found.append(by_name[each.name] + copied)
    return found


def _furniture(scene: Scene) -> Iterator[SceneObject]:
    return (thing for thing in scene.objects if thing.moveable and not thing.pickupable)


def _pose(name: str, position: Vector, rotation: Vector) -> dict[str, object]:
    return {
        "objectName": name,
        "position": position._asdict(),
        "rotation": rotation._asdict(),
    }


def _matched(
    things: Sequence[SceneObject], poses: Sequence[ObjectPose]
) -> list[tuple[SceneObject, ObjectPose]]:
    """Match so that things move as little as possible together; left poses are nearest copies."""

    def way(thing: SceneObject, pose: ObjectPose) -> float:
        return dist(thing.position, pose.position)

    count = min(len(things), len(poses))
    if max(len(things), len(poses)) > MOST_MATCHINGS:
        pairs = _each_nearest(things, poses)
    elif len(things) >= len(poses):
        options = (list(zip(some, poses, strict=True)) for some in permutations(things, count))
        pairs = min(options, key=lambda option: sum(way(*pair) for pair in option))
    else:
        options = (list(zip(things, some, strict=True)) for some in permutations(poses, count))
        pairs = min(options, key=lambda option: sum(way(*pair) for pair in option))
    taken = {id(pose) for _, pose in pairs}
    left = [pose for pose in poses if id(pose) not in taken]
    return pairs + [(min(things, key=lambda thing: way(thing, pose)), pose) for pose in left]


def _each_nearest(
    things: Sequence[SceneObject], poses: Sequence[ObjectPose]
) -> list[tuple[SceneObject, ObjectPose]]:
    left, pairs = list(poses), []
    for thing in things[: len(poses)]:
        pose = min(left, key=lambda pose: dist(thing.position, pose.position))
        left.remove(pose)
        pairs.append((thing, pose))
    return pairs


def _settle(thing: SceneObject, pose: ObjectPose, fixed: Sequence[SceneObject]) -> Restored:
    """Let a thing lie where it should, or in or on what is nearest to that and may hold it."""
    there = posed(thing, pose.position, pose.rotation.y)
    rest = resting_place(there, fixed)
    if rest is None or rest.gap <= AT_REST:
        parent = rest.receptacle.id if rest else ""
        return Restored(pose, thing.name, pose.position, parent)
    inside = _moved_into(there, rest.receptacle)
    way = (new - old for new, old in zip(inside, there.box.center, strict=True))
    position = Vector(*(p + w for p, w in zip(pose.position, way, strict=True)))
    return Restored(pose, thing.name, position, rest.receptacle.id)


def _moved_into(thing: SceneObject, receptacle: SceneObject) -> Vector:
    """Return the middle nearest to the thing's where it lies in or on the receptacle."""
    (x, y, z), (width, height, depth) = thing.box
    (a, _, c), (wide, _, deep) = receptacle.box
    x = _within(x, a, (wide - width) / 2 - INSIDE)
    z = _within(z, c, (deep - depth) / 2 - INSIDE)
    low, high = bottom(receptacle.box), top(receptacle.box)
    if receptacle.type in SURFACES:
        low = high = surface(receptacle)
    y = min(max(y - height / 2, low + INSIDE / 2), max(low, high - height)) + height / 2
    return Vector(x, y, z)


def _within(value: float, middle: float, reach: float) -> float:
    reach = max(reach, 0.0)
    return min(max(value, middle - reach), middle + reach)
