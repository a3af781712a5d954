import json

import pytest

from reibench.errors import InvalidRoom
from reibench.household import Controller, room_names, scene_from_metadata

OBJECT_KEYS = """
    name objectId objectType assetId position rotation visible isInteractable distance receptacle
    receptacleObjectIds parentReceptacles pickupable isPickedUp moveable isMoving openable isOpen
    openness toggleable isToggled breakable isBroken canFillWithLiquid isFilledWithLiquid fillLiquid
    dirtyable isDirty canBeUsedUp isUsedUp cookable isCooked sliceable isSliced temperature
    isHeatSource isColdSource mass salientMaterials controlledObjects axisAlignedBoundingBox
    objectOrientedBoundingBox
""".split()
AGENT_KEYS = """
    objects isSceneAtRest agent heldObjectPose arm fov cameraPosition cameraOrthSize
    thirdPartyCameras collided collidedObjects inventoryObjects sceneName lastAction errorMessage
    errorCode lastActionSuccess screenWidth screenHeight agentId depthFormat colors
    flatSurfacesOnGrid distances normals isOpenableGrid segmentedObjectIds objectIdsInBox
    actionIntReturn actionFloatReturn actionStringsReturn actionFloatsReturn actionVector3sReturn
    visibleRange currentTime sceneBounds actionReturn
""".split()


def test_the_keys_are_ai2thors(robot):
    metadata = robot("Pass").metadata
    assert sorted(metadata) == sorted(AGENT_KEYS)
    assert len(OBJECT_KEYS) == 42
    assert all(sorted(each) == sorted(OBJECT_KEYS) for each in metadata["objects"])


def test_the_values_have_the_types_of_real_metadata(robot, shared_data):
    real: dict[str, set[type]] = {}
    for path in sorted((shared_data / "ithor").glob("*.json")):
        for each in json.loads(path.read_text()).values():
            for key, value in each.items():
                real.setdefault(key, set()).add(type(value))
    real["fillLiquid"].add(str)
    for each in robot("Pass").metadata["objects"]:
        wrong = {
            key: value for key, value in each.items() if type(value) not in real.get(key, {str})
        }
        assert not wrong
    assert set(OBJECT_KEYS) - {"objectId"} <= set(real)


def test_metadata_can_be_written_as_json(robot):
    robot.fetch("Mug")
    assert json.loads(json.dumps(robot("Pass").metadata))["inventoryObjects"]


@pytest.mark.parametrize("name", room_names()[::5])
def test_the_scene_read_from_metadata_is_the_snapshot(name):
    controller = Controller(name)
    assert scene_from_metadata(controller.last_event.metadata) == controller.snapshot()


def test_it_still_is_after_many_things_happened(robot):
    robot.do("SliceObject", robot.find("Apple"))
    robot.do("OpenObject", robot.find("Fridge"), openness=0.4)
    robot.fetch("Mug")
    robot.do("PutObject", robot.find("CoffeeMachine"))
    robot.do("ToggleObjectOn", robot.find("CoffeeMachine"))
    robot.fetch("Plate")
    scene = scene_from_metadata(robot.controller.last_event.metadata)
    assert scene == robot.controller.snapshot()


def test_every_real_room_can_be_read(shared_data):
    paths = sorted((shared_data / "ithor").glob("*.json"))
    assert paths
    for path in paths:
        described = json.loads(path.read_text())
        scene = scene_from_metadata(described)
        assert len(scene.objects) == len(described)
        assert any(thing.receptacle for thing in scene.objects)


def test_parents_are_read_nearest_first():
    metadata = Controller("kitchen-1").last_event.metadata
    apple = next(each for each in metadata["objects"] if each["objectType"] == "Apple")
    floor = next(each for each in metadata["objects"] if each["objectType"] == "Floor")
    counter = apple["parentReceptacles"][0]
    apple["parentReceptacles"] = [floor["objectId"], counter]
    floor["axisAlignedBoundingBox"]["size"]["y"] = 0.5
    scene = scene_from_metadata(metadata)
    assert scene.by_id[apple["objectId"]].parents == (counter, floor["objectId"])


def test_the_suffix_of_a_real_scene_name_is_dropped(robot):
    metadata = robot("Pass").metadata | {"sceneName": "FloorPlan1_physics"}
    assert scene_from_metadata(metadata).room == "FloorPlan1"


def test_metadata_that_lack_something_are_told(robot):
    metadata = robot("Pass").metadata
    del metadata["objects"][0]["position"]
    with pytest.raises(InvalidRoom, match="'position'"):
        scene_from_metadata(metadata)


def test_the_metadata_of_an_old_event_stay_as_they_were(robot):
    apple = robot.find("Apple")
    robot.go(apple)
    before = robot.controller.last_event
    at_once = json.dumps(before.metadata)
    unread = robot("Pass")
    robot.do("PickupObject", apple)
    robot.do("PutObject", robot.find("Plate"))
    robot.do("SliceObject", apple)
    assert json.dumps(before.metadata) == at_once
    described = next(each for each in unread.metadata["objects"] if each["objectId"] == apple.id)
    assert described["parentReceptacles"] == list(apple.parents)
    assert described["visible"]
