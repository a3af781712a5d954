"""Frames: their size, which way is up, what is in them and what is not."""

from math import atan2, degrees, dist

import numpy as np
import pytest

from reibench.household import Controller
from reibench.household.unity.palette import color_of
from tests.household.conftest import Robot

ABOVE = {"position": {"x": 0, "y": 2.6, "z": 0}, "rotation": {"x": 90, "y": 0, "z": 0}}
BLUE = (60, 120, 220)
"""What the robot is painted in."""
RED = color_of("Tomato")


def painted(frame, color) -> np.ndarray:
    """Return where the frame shows something of that colour, in whatever light."""
    shades = frame.astype(float) / np.maximum(frame.max(axis=2, keepdims=True), 1)
    wanted = np.array(color) / max(color)
    return np.abs(shades - wanted).max(axis=2) < 0.04


def middle(mask) -> tuple[float, float]:
    """Return the row and the column around which the marked pixels lie."""
    rows, columns = np.nonzero(mask)
    return float(rows.mean()), float(columns.mean())


@pytest.fixture
def robot(client) -> Robot:
    """A robot in the kitchen that acts in both: what the client shows, the other one knows."""
    client.step("ChangeResolution", x=300, y=300)
    client.reset("kitchen-1")
    return Both(client)


class Both(Robot):
    def __init__(self, client) -> None:
        super().__init__(Controller())
        self.client = client

    def __call__(self, action, **arguments):
        self.client.step(action, **arguments)
        return super().__call__(action, **arguments)

    def stand_off(self, point) -> None:
        """Look at a point from about a metre away."""

        def off(place):
            return abs(dist((place.x, place.z), (point.x, point.z)) - 1)

        place = min(self.controller.reachable(), key=off)
        yaw = degrees(atan2(point.x - place.x, point.z - place.z))
        assert self("Teleport", position=place._asdict(), rotation=yaw, horizon=20).success

    @property
    def frame(self) -> np.ndarray:
        return self.client.last_event.frame


@pytest.mark.parametrize(("width", "height"), [(400, 300), (320, 500), (64, 48)])
def test_frames_are_as_large_as_asked_for(connect, server, width, height):
    client = connect(server, width=width, height=height)
    client.step("AddThirdPartyCamera", **ABOVE)
    event = client.step("Pass")
    assert event.frame.shape == (height, width, 3)
    assert event.third_party_camera_frames[0].shape == (height, width, 3)
    client.step("ChangeResolution", x=80, y=40)
    assert client.step("Pass").frame.shape == (40, 80, 3)


def test_no_frames_come_where_none_are_wanted(client):
    client.reset("kitchen-1")
    client.step("AddThirdPartyCamera", **ABOVE)
    event = client.step("RotateRight", renderImage=False)
    assert event.frame is None
    assert event.third_party_camera_frames == []
    assert client.step("RotateRight").frame is not None


def test_both_protocols_carry_the_same_pictures(connect):
    pictures = []
    for server in ("fifo", "wsgi"):
        client = connect(server, "living-room-1")
        client.step("AddThirdPartyCamera", **ABOVE)
        event = client.step("RotateRight", degrees=30)
        pictures.append([event.frame, *event.third_party_camera_frames])
    assert np.array_equal(pictures[0], pictures[1])


def test_what_is_high_is_above_and_what_is_right_is_right(robot):
    robot.stand_off(robot.find("Apple").position)
    row, column = middle(painted(robot.frame, RED))
    assert abs(column - 150) < 20
    robot("RotateLeft", degrees=20)
    assert middle(painted(robot.frame, RED))[1] > column + 20
    robot("RotateRight", degrees=20)
    robot("LookDown", degrees=15)
    assert middle(painted(robot.frame, RED))[0] < row - 20


@pytest.mark.parametrize("size", [(300, 300), (400, 200)])
def test_a_map_shows_the_robot_where_it_is(robot, size):
    width, height = size
    robot("ChangeResolution", x=width, y=height)
    robot.client.step("GetMapViewCameraProperties")
    properties = robot.client.last_event.metadata["actionReturn"]
    robot("AddThirdPartyCamera", **properties)
    half, center = properties["orthographicSize"], properties["position"]
    places = robot.controller.reachable()
    for place in (places[0], places[-1], places[len(places) // 3]):
        robot("Teleport", position=place._asdict(), rotation=0)
        seen = middle(painted(robot.client.last_event.third_party_camera_frames[0], BLUE))
        row = height / 2 * (1 - (place.z - center["z"]) / half)
        column = width / 2 + height / 2 * (place.x - center["x"]) / half
        # The beak covers a part of the robot, at its front, which is up here.
        assert seen == pytest.approx((row, column), abs=8)
    assert not painted(robot.frame, BLUE).any()


def test_cameras_can_be_moved_and_zoomed(robot):
    robot("AddThirdPartyCamera", **ABOVE, orthographic=True, orthographicSize=3.0)
    over = robot.controller.snapshot().agent.position._replace(y=2.6)._asdict()
    robot("AddThirdPartyCamera", **ABOVE | {"position": over}, fieldOfView=60)

    def robots() -> list[int]:
        return [
            int(painted(f, BLUE).sum()) for f in robot.client.last_event.third_party_camera_frames
        ]

    far, perspective = robots()
    robot("UpdateThirdPartyCamera", orthographic=True, orthographicSize=1.5)
    assert 3 * far < robots()[0] < 5 * far
    robot("UpdateThirdPartyCamera", thirdPartyCameraId=1, fieldOfView=100)
    assert 0 < robots()[1] < perspective
    robot("UpdateThirdPartyCamera", thirdPartyCameraId=1, position={"x": 50})
    assert robots()[1] == 0
    described = robot.client.last_event.metadata["thirdPartyCameras"]
    assert [camera["thirdPartyCameraId"] for camera in described] == [0, 1]
    assert described[1]["position"] == over | {"x": 50.0}


def test_past_the_room_is_the_skybox(robot):
    robot("AddThirdPartyCamera", **ABOVE, orthographic=True, orthographicSize=9, skyboxColor="#ff0")
    frame = robot.client.last_event.third_party_camera_frames[0]
    assert tuple(frame[5, 5]) == (255, 255, 0)
    assert tuple(frame[150, 150]) != (255, 255, 0)


def test_what_is_in_a_closed_container_is_not_seen(robot):
    tomato, fridge = robot.fetch("Tomato"), robot.find("Fridge")
    robot.do("OpenObject", fridge)
    robot.do("PutObject", fridge)
    front = fridge.position._replace(z=fridge.box.center.z - fridge.box.size.z / 2)
    robot("Teleport", position=front._replace(z=front.z - 1)._asdict(), rotation=0, horizon=45)
    assert painted(robot.frame, RED).sum() > 100
    robot("CloseObject", objectId=fridge.id)
    assert painted(robot.frame, RED).sum() == 0
    assert robot.now(tomato).parents == (fridge.id,)


def test_every_frame_says_that_it_is_a_stand_ins(robot):
    robot("AddThirdPartyCamera", **ABOVE)
    for frame in (robot.frame, robot.client.last_event.third_party_camera_frames[0]):
        label = frame[-9:-4, 4:48]
        assert (label == 255).all(axis=2).sum() > 60
        assert (label < 128).all(axis=2).sum() > 60
