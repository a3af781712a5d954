"""The same simulator three ways: in this process, and through AI2-THOR's client over its wires."""

import sys
from collections.abc import Callable, Iterator
from random import Random
from typing import Any

import pytest

from reibench.household import Controller

CLIENT_VALUE_ERRORS = {"InvalidAction", "MissingArguments", "InvalidArgument"}
BUILD = f"{sys.executable} -m reibench.household.unity"


@pytest.fixture(scope="module")
def home(tmp_path_factory) -> Iterator[None]:
    """Keep the client's logs and locks out of the real home."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("HOME", str(tmp_path_factory.mktemp("home")))
        patch.delenv("CUDA_VISIBLE_DEVICES", raising=False)
        yield


@pytest.fixture(scope="module")
def connect(home) -> Iterator[Callable[..., Any]]:
    """Start AI2-THOR's own client on the stand-in."""
    import ai2thor.controller
    import ai2thor.fifo_server
    import ai2thor.wsgi_server

    servers = {
        "fifo": ai2thor.fifo_server.FifoServer,
        "wsgi": ai2thor.wsgi_server.WsgiServer,
    }
    started = []

    def start(server: str, scene: str = "kitchen-1", arguments: str = "", **options: Any) -> Any:
        client = ai2thor.controller.Controller(
            local_executable_path=f"{BUILD} {arguments}",
            x_display=":0",
            server_class=servers[server],
            scene=scene,
            **({"server_timeout": None} | options),
        )
        started.append(client)
        return client

    yield start
    for client in started:
        client.stop()


@pytest.fixture(scope="module", params=["fifo", "wsgi"])
def server(request) -> str:
    return request.param


@pytest.fixture(scope="module")
def client(connect, server) -> Any:
    """A client that has started; tests reset it to where they want to be."""
    return connect(server)


@pytest.fixture
def embedded() -> Controller:
    """The simulator in this process, where a client's has got to when it has started."""
    controller = Controller()
    controller.step("Initialize")
    return controller


@pytest.fixture
def outcome() -> Callable[[Any, dict[str, Any]], tuple[str, dict[str, Any]]]:
    """Carry out an action: what was raised, and the metadata but for who made them."""

    def act(controller: Any, action: dict[str, Any]) -> tuple[str, dict[str, Any]]:
        raised = ""
        try:
            controller.step(dict(action))
        except ValueError as error:
            raised = str(error)
        return raised, without_name(controller.last_event.metadata)

    return act


def without_name(metadata: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in metadata.items() if key != "standIn"}


@pytest.fixture
def next_action() -> Callable[[Random, Controller], dict[str, Any]]:
    """Draw an action that may or may not make sense where the simulator has got to."""
    return draw


def draw(random: Random, controller: Controller) -> dict[str, Any]:
    kinds = (_walk, _on_object, _on_object, _on_seen, _on_seen, _on_seen, _view, _wrong)
    return random.choice(kinds)(random, controller)


def _walk(random: Random, controller: Controller) -> dict[str, Any]:
    place = random.choice(controller.reachable())
    return random.choice(
        [
            {"action": random.choice(["MoveAhead", "MoveBack", "MoveLeft", "MoveRight"])},
            {"action": "MoveAhead", "moveMagnitude": random.choice([0.1, 0.5, 3])},
            {"action": random.choice(["RotateLeft", "RotateRight"])},
            {"action": "RotateRight", "degrees": random.choice([30, 45.5])},
            {"action": random.choice(["LookUp", "LookDown"])},
            {"action": "Teleport", "position": place._asdict(), "rotation": random.randrange(360)},
            {"action": "Teleport", "position": {"x": 9.0, "y": 0.9, "z": 9}, "rotation": {"y": 90}},
            {"action": "GetReachablePositions"},
        ]
    )


def _on_object(random: Random, controller: Controller, *, seen: bool = False) -> dict[str, Any]:
    scene = controller.snapshot()
    things = [thing for thing in scene.objects if not seen or thing.id in scene.visible]
    thing = random.choice(things or scene.objects)
    fitting = [
        name
        for name, trait in {
            "PickupObject": thing.pickupable,
            "PutObject": thing.receptacle,
            "OpenObject": thing.openable,
            "CloseObject": thing.openable,
            "ToggleObjectOn": thing.toggleable,
            "ToggleObjectOff": thing.toggleable,
            "SliceObject": thing.sliceable,
            "BreakObject": thing.breakable,
            "DirtyObject": thing.dirtyable,
            "CleanObject": thing.dirtyable,
        }.items()
        if trait or random.random() < 0.1
    ]
    action: dict[str, Any] = {"action": random.choice(fitting or ["Pass"])}
    if action["action"] == "Pass":
        return random.choice([action, {"action": "DropHandObject"}])
    action |= {"objectId": thing.id}
    if action["action"] == "OpenObject" and random.random() < 0.3:
        action["openness"] = random.choice([0.3, 0.5, 2])
    if random.random() < 0.5:
        action["forceAction"] = random.random() < 0.8
    return action


def _on_seen(random: Random, controller: Controller) -> dict[str, Any]:
    return _on_object(random, controller, seen=True)


def _view(random: Random, controller: Controller) -> dict[str, Any]:
    where = {"position": {"x": 0, "y": 2.5, "z": 0.25}, "rotation": {"x": 90, "y": 0, "z": 0}}
    return random.choice(
        [
            {"action": "GetMapViewCameraProperties"},
            {"action": "AddThirdPartyCamera", **where, "fieldOfView": random.choice([60, 200])},
            {
                "action": "AddThirdPartyCamera",
                **where,
                "orthographic": True,
                "skyboxColor": "white",
            },
            {"action": "UpdateThirdPartyCamera", "thirdPartyCameraId": random.choice([0, 7])},
            {"action": "UpdateThirdPartyCamera", "position": {"x": 1.5}, "orthographicSize": 2},
            {"action": "ChangeResolution", "x": random.choice([64, 96]), "y": 48},
            {"action": "Initialize", "gridSize": random.choice([0.25, 0.2, 7]), "snapToGrid": True},
        ]
    )


def _wrong(random: Random, controller: Controller) -> dict[str, Any]:
    thing = random.choice(controller.snapshot().objects)
    return random.choice(
        [
            {"action": "FlyToMoon"},
            {"action": "PickupObject"},
            {"action": "PutObject", "objectId": thing.id, "receptacleObjectId": thing.id},
            {"action": "PickupObject", "objectId": thing.id, "forceAction": "yes"},
            {"action": "OpenObject", "objectId": ["a", "list"]},
            {"action": "MoveAhead", "moveMagnitude": "far"},
            {"action": "Teleport", "position": 3},
            {"action": "Teleport", "position": {"x": "left"}},
            {"action": "TeleportFull", "position": {"x": 0, "y": 0.9, "z": 0}},
            {"action": "SetObjectPoses", "objectPoses": [{"objectName": "Nobody_0"}]},
            {"action": "SetObjectPoses", "objectPoses": [{"objectName": thing.name}]},
            {"action": "PlaceObjectAtPoint", "objectId": thing.id, "position": {"x": 0}},
            {"action": "PickupObject", "objectId": "Apple|+09.00|+09.00|+09.00"},
            {"action": "SetObjectStates", "SetObjectStates": {"objectType": "Mug"}},
            {"action": "Initialize", "gridSize": "fine"},
        ]
    )
