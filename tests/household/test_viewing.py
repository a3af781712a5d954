import pytest

from reibench.household import Controller, room_names
from reibench.household.scenes import room_name, scene_name

ABOVE = {"position": {"x": 0, "y": 2.5, "z": 0}, "rotation": {"x": 90, "y": 0, "z": 0}}


def test_every_room_is_a_scene_of_the_build(robot):
    assert robot("GetScenesInBuild").action_return == list(room_names())


@pytest.mark.parametrize(
    ("room", "scene"),
    [("FloorPlan12", "FloorPlan12_physics"), ("kitchen-1", "kitchen-1"), ("my_physics",) * 2],
)
def test_ai2thors_rooms_go_by_its_scene_names(room, scene):
    assert scene_name(room) == scene
    assert room_name(scene) == room


def test_the_resolution_is_reported_from_then_on_and_outlasts_a_reset(robot):
    assert robot("ChangeResolution", x=640, y=480).success
    for event in (robot("Pass"), robot("Reset", sceneName="bedroom-1"), robot("Initialize")):
        assert (event.metadata["screenWidth"], event.metadata["screenHeight"]) == (640, 480)
    assert not robot("ChangeResolution", x=0, y=480).success


def test_the_map_view_takes_in_the_whole_room(robot):
    properties = robot("GetMapViewCameraProperties").action_return
    bounds = robot.controller.room.bounds
    assert properties["rotation"] == {"x": 90.0, "y": 0.0, "z": 0.0}
    assert properties["position"]["y"] == bounds.center.y + bounds.size.y / 2
    assert 2 * properties["orthographicSize"] >= max(bounds.size.x, bounds.size.z)
    assert robot("AddThirdPartyCamera", **properties).success


def test_cameras_are_reported_and_changed_in_part(robot):
    robot("AddThirdPartyCamera", **ABOVE)
    event = robot("AddThirdPartyCamera", **ABOVE, fieldOfView=60)
    assert [each["thirdPartyCameraId"] for each in event.metadata["thirdPartyCameras"]] == [0, 1]
    robot("UpdateThirdPartyCamera", thirdPartyCameraId=1, position={"x": 1.5}, fieldOfView=40)
    first, second = robot("Pass").metadata["thirdPartyCameras"]
    assert first == {
        "thirdPartyCameraId": 0,
        "position": {"x": 0.0, "y": 2.5, "z": 0.0},
        "rotation": {"x": 90.0, "y": 0.0, "z": 0.0},
        "fieldOfView": 90.0,
    }
    assert second["position"] == {"x": 1.5, "y": 2.5, "z": 0.0}
    assert second["fieldOfView"] == 40.0
    assert robot("Reset").metadata["thirdPartyCameras"] == []


def test_an_old_event_keeps_its_cameras(robot):
    before = robot("Pass")
    robot("AddThirdPartyCamera", **ABOVE)
    assert before.metadata["thirdPartyCameras"] == []


@pytest.mark.parametrize(
    ("arguments", "why"),
    [
        ({"fieldOfView": 0}, "fieldOfView"),
        ({"fieldOfView": 180}, "fieldOfView"),
        ({"orthographicSize": 2.0}, "orthographic=True"),
        ({"skyboxColor": "#12"}, "skyboxColor"),
        ({"skyboxColor": "plaid"}, "skyboxColor"),
    ],
)
def test_cameras_that_cannot_be_are_refused(robot, arguments, why):
    event = robot("AddThirdPartyCamera", **ABOVE, **arguments)
    assert not event.success
    assert why in event.message
    assert event.metadata["thirdPartyCameras"] == []


def test_a_camera_that_is_not_there_cannot_be_changed(robot):
    robot("AddThirdPartyCamera", **ABOVE)
    assert not robot("UpdateThirdPartyCamera", thirdPartyCameraId=1).success
    assert not robot("UpdateThirdPartyCamera", thirdPartyCameraId=-1).success
    assert robot("UpdateThirdPartyCamera").success


@pytest.mark.parametrize(
    ("action", "arguments", "kind"),
    [
        ("MoveAhead", {"moveMagnitude": "far"}, "float"),
        ("MoveAhead", {"moveMagnitude": True}, "float"),
        ("ChangeResolution", {"x": 1.5, "y": 2}, "int"),
        ("OpenObject", {"objectId": 3}, "String"),
        ("OpenObject", {"objectId": "Fridge", "forceAction": "yes"}, "Boolean"),
        ("Teleport", {"position": 3}, "Vector3"),
        ("Teleport", {"position": {"x": "left"}}, "Vector3"),
    ],
)
def test_values_that_cannot_be_converted_are_misuse(action, arguments, kind):
    controller = Controller()
    with pytest.raises(ValueError, match=f"Cannot convert to: {kind}"):
        controller.step(action, **arguments)
    assert controller.last_event.code == "InvalidArgument"


def test_numbers_of_numpy_are_numbers(robot):
    numpy = pytest.importorskip("numpy")
    assert robot("RotateRight", degrees=numpy.float32(30)).success
    assert robot("ChangeResolution", x=numpy.int64(64), y=64).success


@pytest.mark.parametrize(
    ("options", "why"),
    [({"gridSize": 0}, "grid size"), ({"fieldOfView": 180}, "fov must be set")],
)
def test_initialize_refuses_what_ai2thor_refuses(robot, options, why):
    event = robot("Initialize", **options)
    assert not event.success
    assert why in event.message


def test_a_reset_to_a_room_that_is_not_there_is_misuse(robot):
    with pytest.raises(ValueError, match="Atlantis"):
        robot("Reset", sceneName="Atlantis")
    assert robot.controller.last_event.code == "InvalidArgument"
    assert robot("Pass").success
