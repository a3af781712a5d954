"""Whatever is done in whatever order, the room stays possible."""

from random import Random

import pytest

from reibench.household import Controller, room_names, scene_from_metadata

OBJECT_ACTIONS = (
    "PickupObject PutObject OpenObject CloseObject ToggleObjectOn ToggleObjectOff SliceObject"
    " BreakObject CleanObject DirtyObject"
).split()
OTHER_ACTIONS = "MoveAhead MoveBack RotateLeft RotateRight LookUp DropHandObject Pass".split()


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("room", room_names()[::10])
def test_any_actions_in_any_order_leave_a_possible_room(room, seed):
    random, controller = Random(seed), Controller(room)
    done = 0
    for _ in range(300):
        done += _act(controller, random)
        _assert_possible(controller.snapshot())
    assert done > 30
    assert scene_from_metadata(controller.last_event.metadata) == controller.snapshot()


def _act(controller, random):
    if random.random() < 0.2:
        return controller.step(random.choice(OTHER_ACTIONS)).success
    action = random.choice(OBJECT_ACTIONS)
    scene = controller.snapshot()
    fitting = {"PickupObject": "pickupable", "PutObject": "receptacle", "SliceObject": "sliceable"}
    trait = fitting.get(action, "id")
    thing = random.choice([each for each in scene.objects if getattr(each, trait)] or scene.objects)
    if random.random() < 0.7:
        middle = thing.box.center
        point = min(
            controller.reachable(),
            key=lambda one: (one.x - middle.x) ** 2 + (one.z - middle.z) ** 2,
        )
        controller.step("Teleport", position=point._asdict())
    force = random.random() < 0.7
    return controller.step(action, objectId=thing.id, forceAction=force).success


def _assert_possible(scene):
    held = [thing for thing in scene.objects if thing.held]
    assert len(held) <= 1
    for thing in scene.objects:
        assert len(thing.parents) <= 1
        assert not (thing.held and thing.parents)
        for parent in thing.parents:
            assert scene.by_id[parent].contents.count(thing.id) == 1
            _assert_within(thing, scene.by_id[parent])
        for name in thing.contents or ():
            assert thing.id in scene.by_id[name].parents
        if thing.pickupable:
            assert thing.held or thing.parents
    assert scene.visible <= set(scene.by_id)
    assert not [name for name in scene.visible if scene.closed_around(scene.by_id[name])]


def _assert_within(thing, parent):
    if parent.type == "Floor":
        return
    for axis in (0, 2):
        off = abs(thing.box.center[axis] - parent.box.center[axis])
        assert off <= parent.box.size[axis] / 2 + 0.02, (thing.id, parent.id)
