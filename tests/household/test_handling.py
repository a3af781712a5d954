import pytest


def test_a_thing_picked_up_is_in_the_hand_and_nowhere_else(robot):
    apple = robot.find("Apple")
    robot.do("PickupObject", apple)
    held = robot.now(apple)
    scene = robot.controller.snapshot()
    assert held.held
    assert held.parents == ()
    assert scene.held == held
    assert apple.id not in scene.by_id[apple.parents[0]].contents


def test_a_held_thing_goes_where_the_robot_goes_and_is_seen(robot):
    apple = robot.fetch("Apple")
    for point in robot.controller.reachable()[::20]:
        robot("Teleport", position=point._asdict(), rotation=200)
        middle = robot.now(apple).box.center
        assert (middle.x - point.x) ** 2 + (middle.z - point.z) ** 2 < 0.5**2
        assert robot.controller.sees(apple.id)


def test_a_full_hand_takes_nothing_more(robot):
    robot.fetch("Apple")
    tomato = robot.find("Tomato")
    robot.go(tomato)
    event = robot("PickupObject", objectId=tomato.id)
    assert event.code == "InventoryFull"
    assert event.message == ("Agent hand has something in it already! Can't pick up anything else")


def test_furniture_cannot_be_picked_up(robot):
    fridge = robot.find("Fridge")
    robot.go(fridge)
    event = robot("PickupObject", objectId=fridge.id)
    assert event.code == "ObjectNotPickupable"


def test_what_is_not_seen_cannot_be_picked_up_unless_forced(robot):
    apple = robot.find("Apple")
    robot.go(apple, away=True)
    assert robot("PickupObject", objectId=apple.id).code == "ObjectNotVisible"
    assert robot("PickupObject", objectId=apple.id, forceAction=True).success


def test_what_is_in_a_closed_drawer_cannot_be_picked_up(robot):
    fork = robot.find("Fork")
    robot.go(fork)
    assert robot("PickupObject", objectId=fork.id).code == "ObjectNotVisible"
    robot.reveal(fork)
    robot.do("PickupObject", fork)


def test_an_object_that_does_not_exist_is_told(robot):
    event = robot("PickupObject", objectId="Apple|9|9|9")
    assert not event.success
    assert "is not the objectId on any object in the scene" in event.message


def test_a_thing_put_down_is_in_or_on_the_receptacle_and_within_its_outline(robot):
    apple = robot.fetch("Apple")
    plate = robot.find("Plate")
    robot.do("PutObject", plate)
    put, plate = robot.now(apple), robot.now(plate)
    assert put.parents == (plate.id,)
    assert apple.id in plate.contents
    assert not put.held
    assert abs(put.box.center.x - plate.box.center.x) <= plate.box.size.x / 2
    assert abs(put.box.center.z - plate.box.center.z) <= plate.box.size.z / 2


def test_an_empty_hand_puts_nothing_down(robot):
    event = robot("PutObject", objectId=robot.find("CounterTop").id)
    assert event.code == "ObjectNotInInventory"
    assert event.message == "Can't place an object if Agent isn't holding anything"


@pytest.mark.parametrize("kind", ["Fridge", "Drawer", "Cabinet", "Microwave"])
def test_closed_things_refuse_what_is_put_in_even_by_force(robot, kind):
    robot.fetch("Apple")
    thing = robot.find(kind)
    robot.go(thing)
    event = robot("PutObject", objectId=thing.id, forceAction=True)
    assert event.code == "ReceptacleNotOpen"
    assert event.message.startswith("Target openable Receptacle is CLOSED")


def test_ai2thors_rules_of_what_may_go_where_hold_unless_forced(robot):
    tomato = robot.fetch("Tomato")
    microwave = robot.find("Microwave")
    robot.do("OpenObject", microwave)
    event = robot("PutObject", objectId=microwave.id)
    assert event.code == "ObjectNotAllowedInReceptacle"
    assert event.message == f"{tomato.name} cannot be placed in {microwave.name}"
    assert robot("PutObject", objectId=microwave.id, forceAction=True).success


def test_an_unseen_receptacle_is_not_found(robot):
    robot.fetch("Apple")
    plate = robot.find("Plate")
    robot.go(plate, away=True)
    event = robot("PutObject", objectId=plate.id)
    assert (event.code, event.message) == ("ReceptacleNotVisible", "No valid Receptacle found")


def test_what_is_no_receptacle_takes_nothing(robot):
    robot.fetch("Apple")
    tomato = robot.find("Tomato")
    robot.go(tomato)
    event = robot("PutObject", objectId=tomato.id)
    assert event.message == "This target object is NOT a receptacle!"


def test_a_sink_means_its_basin(robot):
    apple = robot.fetch("Apple")
    robot.do("PutObject", robot.find("Sink"))
    assert robot.now(apple).parents == (robot.find("SinkBasin").id,)


def test_room_runs_out(robot):
    mug = robot.fetch("Mug")
    machine = robot.find("CoffeeMachine")
    robot.do("PutObject", machine)
    robot.fetch("Apple")
    robot.go(machine)
    event = robot("PutObject", objectId=machine.id, forceAction=True)
    assert event.code == "ReceptacleFull"
    assert event.message == "No valid points to place object found"
    assert robot.now(machine).contents == (mug.id,)


def test_a_thing_too_large_finds_no_room(robot):
    robot.fetch("Bread")
    cup = robot.find("Cup")
    event = robot("PutObject", objectId=cup.id, forceAction=True)
    assert event.code == "ReceptacleFull"


def test_a_counter_takes_things_side_by_side_and_not_into_the_sink(robot):
    counter = robot.find("CounterTop")
    for kind in ("Apple", "Tomato", "Potato", "Lettuce", "Bread", "Pot"):
        robot.fetch(kind)
        robot.do("PutObject", counter)
    scene = robot.controller.snapshot()
    boxes = [scene.by_id[name].box for name in robot.now(counter).contents]
    boxes += [thing.box for kind in ("Sink", "StoveBurner") for thing in scene.of_type(kind)]
    assert not [
        (one, other)
        for number, one in enumerate(boxes)
        for other in boxes[:number]
        if all(
            abs(one.center[axis] - other.center[axis]) * 2 + 0.03
            < one.size[axis] + other.size[axis]
            for axis in range(3)
        )
    ]


def test_what_is_in_a_mug_travels_with_it(enter):
    robot = enter("bedroom-1")
    pencil = robot.fetch("Pencil")
    mug = robot.find("Mug")
    robot.do("PutObject", mug)
    robot.do("PickupObject", mug)
    shelf = robot.find("Shelf")
    robot.do("PutObject", shelf)
    assert robot.now(mug).parents == (shelf.id,)
    assert robot.now(pencil).parents == (mug.id,)
    assert robot.now(mug).contents == (pencil.id,)
    apart = [
        abs(a - b)
        for a, b in zip(robot.now(pencil).box.center, robot.now(mug).box.center, strict=True)
    ]
    assert max(apart) < 0.1


def test_a_mug_holds_pen_and_pencil_upright_and_they_lie_down_again(enter):
    robot = enter("bedroom-1")
    mug, desk = robot.find("Mug"), robot.find("Desk")
    for kind in ("Pencil", "Pen"):
        thing = robot.fetch(kind)
        robot.do("PutObject", mug)
        assert robot.now(thing).box.size.y > 0.1
    assert len(robot.now(mug).contents) == 2
    robot.do("PickupObject", thing)
    robot.do("PutObject", desk)
    assert robot.now(thing).box.size.y < 0.1


def test_a_mug_is_not_put_into_itself(robot):
    mug = robot.fetch("Mug")
    assert robot("PutObject", objectId=mug.id, forceAction=True).code == "ReceptacleNotVisible"


def test_what_is_dropped_lands_on_the_floor_nearby_unbroken(robot):
    plate = robot.fetch("Plate")
    here = robot.controller.snapshot().agent.position
    assert robot("DropHandObject").success
    dropped = robot.now(plate)
    assert dropped.parents == (robot.find("Floor").id,)
    assert not dropped.broken
    assert dropped.box.center.y < 0.1
    assert abs(dropped.box.center.x - here.x) < 1
    assert abs(dropped.box.center.z - here.z) < 1
    robot.do("PickupObject", plate)


def test_an_empty_hand_drops_nothing(robot):
    assert robot("DropHandObject").code == "ObjectNotInInventory"


@pytest.mark.parametrize("room", ["kitchen-1", "kitchen-2", "bedroom-2", "bathroom-1"])
def test_what_is_put_down_anywhere_is_seen_from_there(enter, room):
    kind = {"kitchen": "Mug", "bedroom": "CreditCard", "bathroom": "SoapBar"}[room[:-2]]
    receptacles = enter(room).controller.snapshot().objects
    done = 0
    for receptacle in receptacles:
        if not receptacle.receptacle or receptacle.type in ("Floor", kind):
            continue
        robot = enter(room)
        thing = robot.find(kind)
        robot("PickupObject", objectId=thing.id, forceAction=True)
        robot.reveal(receptacle)
        robot.go(receptacle)
        if receptacle.openable and not receptacle.open:
            robot("OpenObject", objectId=receptacle.id)
        if robot("PutObject", objectId=receptacle.id, forceAction=True).success:
            assert robot.controller.sees(thing.id), receptacle.id
            done += 1
    assert done > 3
