import pytest


def test_opening_and_closing(robot):
    fridge = robot.find("Fridge")
    robot.do("OpenObject", fridge)
    assert robot.now(fridge).open
    robot.do("CloseObject", fridge)
    assert not robot.now(fridge).open


def test_what_is_open_cannot_be_opened_nor_what_is_closed_be_closed(robot):
    fridge = robot.find("Fridge")
    robot.go(fridge)
    assert "already closed" in robot("CloseObject", objectId=fridge.id).message
    robot("OpenObject", objectId=fridge.id)
    assert "already open" in robot("OpenObject", objectId=fridge.id).message


def test_something_can_be_opened_by_a_part(robot):
    fridge = robot.find("Fridge")
    robot.do("OpenObject", fridge, openness=0.5)
    described = _metadata(robot, fridge)
    assert (described["isOpen"], described["openness"]) == (True, 0.5)
    robot("OpenObject", objectId=fridge.id)
    assert _metadata(robot, fridge)["openness"] == 1.0


def test_openness_is_a_part_of_one(robot):
    fridge = robot.find("Fridge")
    robot.go(fridge)
    with pytest.raises(ValueError, match="openness"):
        robot("OpenObject", objectId=fridge.id, openness=3)


def test_a_counter_does_not_open(robot):
    counter = robot.find("CounterTop")
    robot.go(counter)
    event = robot("OpenObject", objectId=counter.id)
    assert event.message == f"{counter.id} is not an Openable object"


def test_opening_shows_what_is_inside(robot):
    fork = robot.find("Fork")
    robot.go(fork)
    assert not robot.controller.sees(fork.id)
    robot.reveal(fork)
    assert robot.controller.sees(fork.id)


@pytest.mark.parametrize(
    ("room", "kind"),
    [
        ("living-room-2", "FloorLamp"),
        ("living-room-1", "Television"),
        ("kitchen-1", "Faucet"),
        ("kitchen-1", "Toaster"),
    ],
)
def test_switching_on_and_off(enter, room, kind):
    robot = enter(room)
    thing = robot.find(kind)
    assert not thing.on
    robot.do("ToggleObjectOn", thing)
    assert robot.now(thing).on
    assert robot("ToggleObjectOn", objectId=thing.id).message == (
        "can't toggle object on if it's already on!"
    )
    robot.do("ToggleObjectOff", thing)
    assert not robot.now(thing).on


def test_an_open_microwave_does_not_start_and_a_running_one_does_not_open(robot):
    microwave = robot.find("Microwave")
    robot.do("OpenObject", microwave)
    event = robot("ToggleObjectOn", objectId=microwave.id)
    assert "must be closed" in event.message
    robot("CloseObject", objectId=microwave.id)
    robot.do("ToggleObjectOn", microwave)
    assert robot("OpenObject", objectId=microwave.id).message == "Target must be OFF to open!"


def test_a_stove_knob_lights_its_burner(robot):
    knob = robot.find("StoveKnob")
    (burner,) = robot.controller.room.controls[knob.id]
    robot.do("ToggleObjectOn", knob)
    scene = robot.controller.snapshot()
    assert [thing.id for thing in scene.of_type("StoveBurner") if thing.on] == [burner]
    robot.do("ToggleObjectOff", knob)
    assert not robot.controller.snapshot().by_id[burner].on


def test_a_burner_itself_cannot_be_switched(robot):
    burner = robot.find("StoveBurner")
    robot.go(burner)
    assert "is not toggleable" in robot("ToggleObjectOn", objectId=burner.id).message


def test_a_broken_television_stays_dark(enter):
    robot = enter("living-room-1")
    television = robot.find("Television")
    robot.do("BreakObject", television)
    assert "broken" in robot("ToggleObjectOn", objectId=television.id).message


def _metadata(robot, thing):
    objects = robot.controller.last_event.metadata["objects"]
    return next(each for each in objects if each["objectId"] == thing.id)
