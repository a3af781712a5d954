"""Records' parts as JSON and back; scenes after the first are kept as what changed."""

import json
from collections.abc import Iterable, Sequence
from dataclasses import fields
from typing import Any

from reibench.goals import Condition
from reibench.scene import Box, Pose, Scene, SceneObject, Vector

_DEFAULTS = {
    field.name: field.default for field in fields(SceneObject) if field.name not in ("id", "type")
}


def dump(value: object) -> str:
    """Return compact JSON."""
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def object_to_json(thing: SceneObject) -> dict[str, Any]:
    """Return an object's fields, leaving out those at their defaults."""
    return {
        field.name: getattr(thing, field.name)
        for field in fields(thing)
        if getattr(thing, field.name) != _DEFAULTS.get(field.name, ...)
    }


def object_from_json(value: dict[str, Any]) -> SceneObject:
    """Read an object."""
    kept = dict(value)
    kept["position"] = Vector(*kept["position"])
    center, size = kept["box"]
    kept["box"] = Box(Vector(*center), Vector(*size))
    kept["parents"] = tuple(kept.get("parents", ()))
    if kept.get("contents") is not None:
        kept["contents"] = tuple(kept["contents"])
    return SceneObject(**kept)


def _pose_from_json(value: Sequence[Any]) -> Pose:
    position, yaw, horizon, standing = value
    return Pose(Vector(*position), yaw, horizon, standing)


def scene_to_json(scene: Scene) -> dict[str, Any]:
    """Return a whole scene."""
    return {
        "room": scene.room,
        "bounds": scene.bounds,
        "agent": scene.agent,
        "visible": sorted(scene.visible),
        "objects": [object_to_json(thing) for thing in scene.objects],
    }


def scene_from_json(value: dict[str, Any]) -> Scene:
    """Read a whole scene."""
    center, size = value["bounds"]
    return Scene(
        room=value["room"],
        objects=tuple(object_from_json(each) for each in value["objects"]),
        agent=_pose_from_json(value["agent"]),
        visible=frozenset(value["visible"]),
        bounds=Box(Vector(*center), Vector(*size)),
    )


def changes_to_json(before: Scene, after: Scene) -> dict[str, Any]:
    """Return what must be changed in `before` to get `after`."""
    old = before.by_id
    return {
        "agent": after.agent,
        "seen": sorted(after.visible - before.visible),
        "unseen": sorted(before.visible - after.visible),
        "objects": [object_to_json(t) for t in after.objects if old.get(t.id) != t],
        "gone": [thing.id for thing in before.objects if thing.id not in after.by_id],
    }


def changes_from_json(before: Scene, value: dict[str, Any]) -> Scene:
    """Apply changes to `before`."""
    changed = {each["id"]: object_from_json(each) for each in value["objects"]}
    gone = set(value["gone"])
    kept = [changed.pop(t.id, t) for t in before.objects if t.id not in gone]
    return Scene(
        room=before.room,
        objects=(*kept, *changed.values()),
        agent=_pose_from_json(value["agent"]),
        visible=(before.visible | set(value["seen"])) - set(value["unseen"]),
        bounds=before.bounds,
    )


def goals_to_json(goals: Iterable[Condition]) -> str:
    """Return goal conditions."""
    return dump([[goal.name, goal.text, goal.holds] for goal in goals])


def goals_from_json(text: str) -> tuple[Condition, ...]:
    """Read goal conditions."""
    return tuple(Condition(*each) for each in json.loads(text))
