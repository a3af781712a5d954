import pytest


def test_teleport_takes_a_reachable_position_a_turn_and_a_tilt(robot):
    point = robot.controller.reachable()[3]
    assert robot("Teleport", position=point._asdict(), rotation=90, horizon=30).success
    pose = robot.controller.snapshot().agent
    assert pose.position == point
    assert (pose.yaw, pose.horizon, pose.standing) == (90, 30, True)


def test_teleport_reads_a_rotation_given_as_a_dictionary(robot):
    robot("Teleport", rotation={"x": 0, "y": -90, "z": 0})
    assert robot.controller.snapshot().agent.yaw == 270


def test_teleport_leaves_out_what_is_not_said(robot):
    before = robot.controller.snapshot().agent
    robot("Teleport", rotation=123)
    assert robot.controller.snapshot().agent == before._replace(yaw=123)


def test_teleport_into_furniture_is_refused(robot):
    counter = robot.find("CounterTop").box.center
    before = robot.controller.snapshot().agent
    event = robot("Teleport", position=counter._asdict())
    assert not event.success
    assert "in the way" in event.message
    assert robot.controller.snapshot().agent == before


def test_teleport_out_of_the_room_is_refused_unless_forced(robot):
    event = robot("Teleport", x=100.0, z=0.0)
    assert event.message.startswith("Teleport target out of scene bounds!")
    assert robot("Teleport", x=100.0, z=0.0, forceAction=True).success


def test_teleport_full_wants_everything_said(robot):
    point = robot.controller.reachable()[0]._asdict()
    with pytest.raises(ValueError, match="standing"):
        robot("TeleportFull", **point, rotation=0, horizon=0)
    assert robot("TeleportFull", **point, rotation=0, horizon=0, standing=True).success


def test_the_reachable_positions_are_also_an_action(robot):
    event = robot("GetReachablePositions")
    points = [point._asdict() for point in robot.controller.reachable()]
    assert event.action_return == points
    assert len(robot("GetReachablePositions", gridSize=0.5).action_return) < len(points)


@pytest.mark.parametrize(
    ("action", "dx", "dz"),
    [
        ("MoveAhead", 0, 0.25),
        ("MoveBack", 0, -0.25),
        ("MoveRight", 0.25, 0),
        ("MoveLeft", -0.25, 0),
    ],
)
def test_moves_go_one_grid_step_in_their_direction(robot, action, dx, dz):
    points = set(robot.controller.reachable())
    start = next(
        point
        for point in sorted(points)
        if point._replace(x=point.x + dx, z=point.z + dz) in points
    )
    robot("Teleport", position=start._asdict(), rotation=0)
    assert robot(action).success
    assert robot.controller.snapshot().agent.position == (start.x + dx, start.y, start.z + dz)


def test_a_wall_stops_the_robot(robot):
    robot("Teleport", rotation=180)
    for _ in range(40):
        event = robot("MoveAhead")
    assert not event.success
    assert "is blocking Agent 0 from moving by" in event.message


def test_turns_add_up_to_a_full_circle(robot):
    before = robot.controller.snapshot().agent
    for _ in range(4):
        robot("RotateRight")
    for _ in range(12):
        robot("RotateLeft", degrees=30)
    assert robot.controller.snapshot().agent == before


def test_the_camera_tilts_only_so_far(robot):
    robot("LookDown")
    robot("LookDown")
    assert robot("LookDown").code == "LookDownCantExceedMin"
    for _ in range(3):
        robot("LookUp")
    assert robot("LookUp").code == "LookUpCantExceedMax"
    assert robot.controller.snapshot().agent.horizon == -30


def test_what_is_ahead_and_near_is_seen_and_what_is_behind_is_not(robot):
    apple = robot.find("Apple")
    robot.go(apple)
    assert robot.controller.sees(apple.id)
    robot.go(apple, away=True)
    assert not robot.controller.sees(apple.id)


def test_what_is_far_is_not_seen(robot):
    fridge = robot.find("Fridge")
    middle = fridge.box.center
    far = max(
        robot.controller.reachable(),
        key=lambda point: (point.x - middle.x) ** 2 + (point.z - middle.z) ** 2,
    )
    robot("Teleport", position=far._asdict())
    for _ in range(4):
        robot("RotateRight")
        assert not robot.controller.sees(fridge.id)


def test_of_a_long_counter_the_nearest_part_counts(robot):
    counter = max(robot.controller.snapshot().of_type("CounterTop"), key=lambda one: one.box.size)
    robot.go(counter)
    assert robot.controller.sees(counter.id)


def test_seeing_one_object_agrees_with_the_whole_scene(robot):
    for point in robot.controller.reachable()[::7]:
        robot("Teleport", position=point._asdict(), rotation=45)
        scene = robot.controller.snapshot()
        seen = {thing.id for thing in scene.objects if robot.controller.sees(thing.id)}
        assert seen == scene.visible
