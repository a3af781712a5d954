from reibench.household.effects import LASTS


def test_what_is_in_the_fridge_is_cold_from_the_start(robot):
    assert robot.find("Egg").temperature == "Cold"


def test_the_fridge_cools_what_is_put_in(robot):
    apple = robot.fetch("Apple")
    fridge = robot.find("Fridge")
    robot.do("OpenObject", fridge)
    robot.do("PutObject", fridge)
    assert robot.now(apple).temperature == "Cold"


def test_the_microwave_heats_what_is_on_the_plate_in_it_and_cooks_a_potato(robot):
    plate, microwave = robot.find("Plate"), robot.find("Microwave")
    potato = robot.fetch("Potato")
    robot.do("PutObject", plate)
    robot.do("PickupObject", plate)
    robot.do("OpenObject", microwave)
    robot.do("PutObject", microwave)
    assert robot.now(potato).temperature == "RoomTemp"
    robot.do("CloseObject", microwave)
    robot.do("ToggleObjectOn", microwave)
    assert robot.now(plate).temperature == robot.now(potato).temperature == "Hot"
    assert robot.now(potato).cooked


def test_a_burner_heats_the_pot_and_what_is_in_it(robot):
    pot = robot.find("Pot")
    potato = robot.fetch("Potato")
    robot.do("PutObject", pot)
    if not pot.parents[0].startswith("StoveBurner"):
        robot.do("PickupObject", pot)
        robot.do("PutObject", robot.find("StoveBurner", 3))
    (burner,) = robot.now(pot).parents
    controls = robot.controller.room.controls
    knob = next(name for name, burners in controls.items() if burner in burners)
    robot.do("ToggleObjectOn", robot.controller.snapshot().by_id[knob])
    assert robot.now(pot).temperature == robot.now(potato).temperature == "Hot"


def test_a_running_faucet_washes_and_fills_what_is_in_the_sink(robot):
    mug, faucet = robot.find("Mug"), robot.find("Faucet")
    robot.do("DirtyObject", mug)
    robot.fetch("Mug")
    robot.do("PutObject", robot.find("Sink"))
    assert robot.now(mug).dirty
    robot.do("ToggleObjectOn", faucet)
    washed = robot.now(mug)
    assert (washed.dirty, washed.filled, washed.liquid) == (False, True, "water")


def test_a_coffee_machine_fills_an_empty_mug(robot):
    mug, machine = robot.fetch("Mug"), robot.find("CoffeeMachine")
    robot.do("PutObject", machine)
    robot.do("ToggleObjectOn", machine)
    brewed = robot.now(mug)
    assert (brewed.filled, brewed.liquid, brewed.temperature) == (True, "coffee", "Hot")


def test_a_toaster_toasts_a_slice_of_bread(robot):
    bread, toaster = robot.find("Bread"), robot.find("Toaster")
    robot.do("SliceObject", bread)
    piece = robot.fetch("BreadSliced")
    robot.do("PutObject", toaster)
    robot.do("ToggleObjectOn", toaster)
    assert robot.now(piece).cooked


def test_things_come_back_to_room_temperature(robot):
    fridge = robot.find("Fridge")
    egg = robot.fetch("Egg")
    for _ in range(LASTS - 5):
        robot("Pass")
    assert robot.now(egg).temperature == "Cold"
    for _ in range(10):
        robot("Pass")
    assert robot.now(egg).temperature == "RoomTemp"
    robot.do("PutObject", fridge)
    for _ in range(LASTS + 10):
        robot("Pass")
    assert robot.now(egg).temperature == "Cold"


def test_a_lamp_and_a_closed_cabinet_change_no_temperature(enter):
    robot = enter("living-room-1")
    watch = robot.find("Watch")
    robot("Pass")
    assert robot.now(watch).temperature == "RoomTemp"
