from math import dist


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


def poses_of(robot, **moved):
    """R
    from math import dist
    eturn the pose of everything that can be moved, with other positions for some types."""
    return [
        {
            "objectName": thing.name,
            "position": moved.get(thing.type, thing.position)._asdict(),
            "rotation": {"x": 0, "y": thing.yaw, "z": 0},
        }
        for thing in robot.controller.snapshot().objects
        if thing.pickupable or thing.moveable
    ]


def test_poses_put_things_where_they_are_said_to_be(robot):
    apple, plate = robot.find("Apple"), robot.find("Plate")
    assert robot("SetObjectPoses", objectPoses=poses_of(robot, Apple=plate.position)).success
    moved = robot.now(apple)
    assert moved.position == plate.position
    assert moved.parents == (plate.id,)
    assert apple.id in robot.now(plate).contents
    assert apple.id not in robot.controller.snapshot().by_id[apple.parents[0]].contents


def test_poses_of_everything_as_it_is_change_nothing(robot):
    before = robot.controller.snapshot()
    assert robot("SetObjectPoses", objectPoses=poses_of(robot)).success
    after = robot.controller.snapshot()
    assert {o.id: o.parents[:1] for o in after.objects} == {
        o.id: o.parents[:1] for o in before.objects
    }
    assert all(dist(o.position, before.by_id[o.id].position) < 1e-6 for o in after.objects)


def test_what_no_pose_names_is_gone(robot):
    apple = robot.find("Apple")
    poses = [each for each in poses_of(robot) if each["objectName"] != apple.name]
    assert robot("SetObjectPoses", objectPoses=poses).success
    scene = robot.controller.snapshot()
    assert apple.id not in scene.by_id
    assert not any(apple.id in (thing.contents or ()) for thing in scene.objects)


def test_naming_a_thing_again_makes_a_copy(robot):
    apple, sink = robot.find("Apple"), robot.find("SinkBasin")
    again = {"objectName": apple.name, "position": sink.box.center._asdict()}
    poses = [*poses_of(robot), again]
    assert robot("SetObjectPoses", objectPoses=poses).success
    copy = robot.controller.snapshot().by_id[f"{apple.id}_copy_{len(poses) - 1}"]
    assert copy.parents == (sink.id,)
    assert robot.now(apple).parents == apple.parents
    assert robot("PickupObject", objectId=copy.id, forceAction=True).success


def test_a_turned_thing_takes_its_room_the_other_way_round(robot):
    pan = robot.find("Pan")
    poses = poses_of(robot)
    for pose in poses:
        if pose["objectName"] == pan.name:
            pose["rotation"]["y"] = pan.yaw + 90
    robot("SetObjectPoses", objectPoses=poses)
    width, height, depth = pan.box.size
    assert robot.now(pan).box.size == (depth, height, width)


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


def test_what_poses_take_away_acts_no_more(robot):
    apple = robot.find("Apple")
    pose = {"objectName": apple.name, "position": apple.position._asdict()}
    assert robot("SetObjectPoses", objectPoses=[pose]).success
    assert not robot.controller.snapshot().of_type("Microwave")
    assert robot("Pass").success
