"""What is in or on what.

Real AI2-THOR rooms report a few cycles (a pan on the counter top on the pan), so nothing here
follows parents without end.
"""

from collections.abc import Iterator

from reibench.scene import CONTAINERS, Scene, SceneObject


def around(thing: SceneObject, scene: Scene) -> Iterator[SceneObject]:
    """Return everything `thing` is in or on, nearest first, each once."""
    seen = {thing.id}
    waiting = list(thing.parents)
    while waiting:
        parent = scene.by_id.get(waiting.pop(0))
        if parent is not None and parent.id not in seen:
            seen.add(parent.id)
            yield parent
            waiting.extend(parent.parents)


def container(thing: SceneObject, scene: Scene) -> SceneObject | None:
    """Return the outermost thing with doors or a lid that `thing` is inside, if any."""
    found = None
    for parent in around(thing, scene):
        if parent.type in CONTAINERS:
            found = parent
    return found


def is_hidden(thing: SceneObject, scene: Scene) -> bool:
    """Whether `thing` is inside something closed."""
    return any(
        parent.type in CONTAINERS and parent.openable and not parent.open
        for parent in around(thing, scene)
    )


def support(thing: SceneObject, scene: Scene) -> SceneObject | None:
    """Return what `thing` rests in or on: of several, the one whose top is next to its bottom."""
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


def is_empty(thing: SceneObject) -> bool:
    """Whether `thing` is an open container with nothing in it."""
    return thing.type in CONTAINERS and thing.open and not thing.contents
