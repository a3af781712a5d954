"""One contract, three ways: whatever is asked, embedded, FIFO and WSGI answer the same."""

from dataclasses import replace
from pathlib import Path
from random import Random

import pytest

import reibench
from reibench.errors import UnknownName
from reibench.household import Controller, room_names, scene_from_metadata
from reibench.household.rooms import save_room

ACTIONS = 60
ROOMS = room_names()[::15]


@pytest.mark.parametrize("room", ROOMS)
def test_any_actions_have_equal_outcomes(client, room, outcome, next_action):
    random = Random(f"three ways, {room}")
    embedded = Controller(room)
    embedded.step("Initialize")
    client.step("ChangeResolution", x=300, y=300)
    client.reset(room)
    outcome(client, {"action": "Initialize", "gridSize": 0.25})
    outcome(embedded, {"action": "Initialize", "gridSize": 0.25})
    worked = raised = 0
    for _ in range(ACTIONS):
        action = next_action(random, embedded) | {"renderImage": random.random() < 0.1}
        expected, got = outcome(embedded, action), outcome(client, action)
        assert got == expected, action
        worked += got[1]["lastActionSuccess"]
        raised += bool(got[0])
    assert worked > ACTIONS / 10
    assert raised


@pytest.mark.parametrize(
    ("action", "code"),
    [
        ({"action": "FlyToMoon"}, "InvalidAction"),
        ({"action": "PickupObject"}, "MissingArguments"),
        ({"action": "PutObject", "objectId": "x", "receptacleObjectId": "y"}, "InvalidArgument"),
        ({"action": "MoveAhead", "moveMagnitude": "far"}, "InvalidArgument"),
        ({"action": "Teleport", "position": {"x": "left"}}, "InvalidArgument"),
        ({"action": "Reset", "sceneName": "Atlantis"}, "InvalidArgument"),
    ],
)
def test_misuse_raises_value_errors_with_ai2thors_codes(client, embedded, outcome, action, code):
    client.reset("kitchen-1")
    (expected, _), (raised, metadata) = outcome(embedded, action), outcome(client, action)
    assert raised == expected != ""
    assert metadata["errorCode"] == code


def test_a_refusal_is_an_event_and_no_error(client, embedded, outcome):
    client.reset("kitchen-1")
    fridge = embedded.snapshot().of_type("Fridge")[0]
    action = {"action": "PickupObject", "objectId": fridge.id, "forceAction": True}
    raised, metadata = outcome(client, action)
    assert raised == ""
    assert metadata["errorCode"] == "ObjectNotPickupable"
    assert (raised, metadata) == outcome(embedded, action)


def test_scenes_can_be_switched(client):
    for room in ROOMS[::-1]:
        event = client.reset(room)
        assert event.metadata["sceneName"] == room
        assert scene_from_metadata(event.metadata) == Controller(room).snapshot()


def test_an_unknown_scene_is_refused_with_those_there_are(client):
    with pytest.raises(ValueError, match="bathroom-1"):
        client.reset("Atlantis")
    with pytest.raises(UnknownName, match="bathroom-1"):
        Controller("Atlantis")


def test_a_numbered_room_is_announced_and_reset_as_in_ai2thor(
    connect, server, tmp_path, monkeypatch
):
    """The stand-in runs where the shipped kitchen goes by a number of AI2-THOR's."""
    (tmp_path / "reibench").symlink_to(Path(reibench.__file__).parent)
    rooms = tmp_path / "assets" / "rooms"
    rooms.mkdir(parents=True)
    save_room(replace(Controller().room, name="FloorPlan3"), rooms / "FloorPlan3.json")
    monkeypatch.chdir(tmp_path)
    client = connect(server, "FloorPlan3")
    assert client.scenes_in_build == {"FloorPlan3_physics"}
    assert client.last_event.metadata["sceneName"] == "FloorPlan3_physics"
    assert scene_from_metadata(client.last_event.metadata).room == "FloorPlan3"
    assert client.reset("FloorPlan3").metadata["lastActionSuccess"]


def test_a_room_from_a_file_is_there_on_top_of_the_shipped_ones(connect, server, tmp_path):
    save_room(replace(Controller().room, name="attic"), tmp_path / "my attic.json")
    client = connect(server, "attic", f"--room '{tmp_path / 'my attic.json'}'")
    assert client.scenes_in_build == {*room_names(), "attic"}
    assert client.last_event.metadata["sceneName"] == "attic"
    assert client.reset("bedroom-1").metadata["sceneName"] == "bedroom-1"
    assert client.reset("attic").metadata["sceneName"] == "attic"


def test_constructor_options_reach_the_simulator(connect, server):
    options = {"gridSize": 0.5, "visibilityDistance": 4.0, "fieldOfView": 60}
    client = connect(server, "bedroom-1", **options)
    embedded = Controller("bedroom-1", **options)
    seen = {o["objectId"] for o in client.last_event.metadata["objects"] if o["visible"]}
    assert seen == embedded.snapshot().visible
    places = client.step("GetReachablePositions").metadata["actionReturn"]
    assert places == [place._asdict() for place in embedded.reachable()]
    assert client.last_event.metadata["fov"] == 60


def test_the_metadata_name_the_stand_in(client, embedded):
    assert client.last_event.metadata["standIn"] == "reibench.household.unity"
    assert "standIn" not in embedded.last_event.metadata


def test_a_change_of_an_object_far_away_is_not_lost(client, embedded):
    """What is unchanged is packed once; what changes unseen must be packed again."""
    client.reset("kitchen-1")
    for controller in (client, embedded):
        controller.step("RotateLeft")
        for on in (True, False, True):
            states = {"objectType": "Microwave", "stateChange": "toggleable", "isToggled": on}
            controller.step("SetObjectStates", SetObjectStates=states)
        fridge = embedded.snapshot().of_type("Fridge")[0].id
        for openness in (0.3, 0.6):
            controller.step("OpenObject", objectId=fridge, openness=openness, forceAction=True)
    assert client.last_event.metadata["objects"] == embedded.last_event.metadata["objects"]
    opened = next(o for o in client.last_event.metadata["objects"] if o["objectId"] == fridge)
    assert opened["openness"] == 0.6
