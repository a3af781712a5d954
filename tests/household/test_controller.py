import subprocess
import sys
from time import process_time

import pytest

from reibench.errors import UnknownName
from reibench.household import Controller, generate_room, load_room


def test_a_controller_takes_the_name_of_a_room_or_a_room():
    assert Controller("bedroom-2").snapshot() == Controller(load_room("bedroom-2")).snapshot()


def test_an_unknown_room_is_refused():
    with pytest.raises(UnknownName, match="Did you mean 'kitchen-9'"):
        Controller("kitchen-99")


def test_a_step_can_be_given_as_a_dictionary(robot):
    apple = robot.find("Apple")
    robot.go(apple)
    assert robot.controller.step({"action": "PickupObject", "objectId": apple.id}).success


def test_an_event_says_how_the_action_went(robot):
    event = robot("PutObject", objectId="Nowhere")
    metadata = event.metadata
    assert event is robot.controller.last_event
    assert not event.success
    assert metadata["lastAction"] == "PutObject"
    assert metadata["lastActionSuccess"] is False
    assert metadata["errorMessage"] == event.message
    assert metadata["errorCode"] == event.code == "ObjectNotInInventory"


@pytest.mark.parametrize(
    ("action", "arguments", "code"),
    [
        ("FlyToMoon", {}, "InvalidAction"),
        ("PickupObject", {}, "MissingArguments"),
        ("PutObject", {"objectId": "x", "receptacleObjectId": "y"}, "InvalidArgument"),
        ("Teleport", {"rotateOnTeleport": True}, "InvalidArgument"),
    ],
)
def test_misuse_raises_as_in_ai2thors_client_and_is_noted(robot, action, arguments, code):
    before = robot.controller.snapshot()
    with pytest.raises(
        ValueError, match=r"Invalid action|missing the following arguments|Invalid argument"
    ):
        robot(action, **arguments)
    assert robot.controller.last_event.code == code
    assert robot.controller.snapshot() == before


def test_arguments_about_frames_are_let_pass(robot):
    assert robot("RotateRight", renderImage=False, agentId=0).success


def test_a_refused_action_changes_nothing(robot):
    before = robot.controller.snapshot()
    assert not robot("PickupObject", objectId=robot.find("Fridge").id).success
    assert robot.controller.snapshot() == before


def test_reset_undoes_everything(robot):
    before = robot.controller.snapshot()
    robot.fetch("Apple")
    robot.controller.reset()
    assert robot.controller.snapshot() == before
    robot("Reset", sceneName="bedroom-1")
    assert robot.controller.snapshot().room == "bedroom-1"


def test_what_did_not_change_is_the_very_same_object(robot):
    before = robot.controller.snapshot()
    apple = robot.fetch("Apple")
    after = robot.controller.snapshot()
    changed = {thing.id for thing in after.objects if thing is not before.by_id[thing.id]}
    assert changed == {apple.id, *apple.parents}


def test_a_wider_view_and_a_longer_reach_show_more():
    far = Controller("bedroom-2", visibilityDistance=5.0, fieldOfView=180.0)
    assert len(far.snapshot().visible) > len(Controller("bedroom-2").snapshot().visible)


def test_two_controllers_do_not_meet():
    one, other = Controller("kitchen-1"), Controller("kitchen-1")
    before = other.snapshot()
    apple = one.snapshot().of_type("Apple")[0]
    one.step("PickupObject", objectId=apple.id, forceAction=True)
    assert other.snapshot() == before


def test_importing_the_simulator_loads_nothing_heavy():
    heavy = "'numpy', 'PIL', 'ai2thor', 'gradio', 'reibench.household.generate'"
    code = f"import sys, reibench.household; print([n for n in ({heavy},) if n in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_the_cost_of_a_step_grows_no_faster_than_the_room():
    seconds = {}
    for number in (50, 200):
        controller = Controller(generate_room("bedroom", 2, name="any", objects=number))
        # The least of several rounds: other work on the machine only ever adds.
        seconds[number] = min(_round(controller) for _ in range(7))
    assert seconds[200] < 8 * seconds[50]


def _round(controller):
    begin = process_time()
    for number in range(100):
        controller.step("Teleport", rotation=number * 10)
        controller.snapshot()
    return process_time() - begin
