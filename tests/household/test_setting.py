def test_states_are_set_for_all_of_a_type(robot):
    wanted = {"objectType": "Mug", "stateChange": "dirtyable", "isDirty": True}
    assert robot("SetObjectStates", SetObjectStates=wanted).success
    dirty = {thing.type for thing in robot.controller.snapshot().objects if thing.dirty}
    assert dirty == {"Mug"}


def test_states_are_set_for_all_that_can_have_them(robot):
    robot("SetObjectStates", SetObjectStates={"stateChange": "openable", "isOpen": True})
    scene = robot.controller.snapshot()
    assert all(thing.open for thing in scene.objects if thing.openable)


def test_setting_a_knob_sets_its_burner(robot):
    robot("SetObjectStates", SetObjectStates={"objectType": "StoveKnob", "isToggled": True})
    assert all(burner.on for burner in robot.controller.snapshot().of_type("StoveBurner"))


def test_filling_says_with_what(robot):
    robot(
        "SetObjectStates",
        SetObjectStates={"stateChange": "canFillWithLiquid", "isFilledWithLiquid": True},
    )
    assert robot.find("Mug").liquid == "water"


def test_a_state_nothing_can_have_is_refused(robot):
    event = robot("SetObjectStates", SetObjectStates={"stateChange": "edible", "isEaten": True})
    assert "edible" in event.message
    event = robot("SetObjectStates", SetObjectStates={"stateChange": "openable"})
    assert "isOpen" in event.message


def test_poses_put_things_where_they_are_said_to_be(robot):
    apple, plate = robot.find("Apple"), robot.find("Plate")
    pose = {
        "objectName": apple.name,
        "position": plate.position._asdict(),
        "rotation": {"x": 0, "y": 30, "z": 0},
    }
    assert robot("SetObjectPoses", objectPoses=[pose]).success
    moved = robot.now(apple)
    assert moved.position == plate.position
    assert moved.yaw == 30
    assert moved.parents == (plate.id,)
    assert apple.id in robot.now(plate).contents
    assert apple.id not in robot.controller.snapshot().by_id[apple.parents[0]].contents


def test_a_pose_for_something_unknown_is_refused(robot):
    poses = [{"objectName": "Ghost_1", "position": {"x": 0, "y": 0, "z": 0}}]
    assert "Ghost_1" in robot("SetObjectPoses", objectPoses=poses).message


def test_a_thing_can_be_placed_at_a_point(robot):
    apple = robot.fetch("Apple")
    point = robot.find("Plate").position
    assert robot("PlaceObjectAtPoint", objectId=apple.id, position=point._asdict()).success
    assert not robot.now(apple).held
    assert robot.controller.snapshot().held is None


def test_initialize_changes_how_far_one_sees(robot):
    before = len(robot.controller.snapshot().visible)
    assert robot("Initialize", visibilityDistance=10.0, fieldOfView=170, quality="Low").success
    assert len(robot.controller.snapshot().visible) > before


def test_initialize_changes_the_grid(robot):
    many = len(robot.controller.reachable())
    robot("Initialize", gridSize=0.5)
    assert len(robot.controller.reachable()) < many / 2
