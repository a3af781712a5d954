import pytest


@pytest.mark.parametrize("kind", ["Apple", "Bread", "Lettuce", "Potato", "Tomato"])
def test_slicing_replaces_a_thing_by_slices_in_its_place(robot, kind):
    whole = robot.find(kind)
    robot.reveal(whole)
    robot.do("SliceObject", whole)
    scene = robot.controller.snapshot()
    slices = scene.of_type(f"{kind}Sliced")
    assert whole.id not in scene.by_id
    assert len(slices) > 1
    for number, piece in enumerate(slices):
        assert piece.id == f"{whole.id}|{kind}Sliced_{number}"
        assert piece.parents == whole.parents
        assert piece.pickupable
        assert not piece.sliceable
        assert piece.id in scene.by_id[whole.parents[0]].contents
    robot.do("PickupObject", slices[0])


def test_an_egg_is_cracked(robot):
    egg = robot.find("Egg")
    robot.reveal(egg)
    robot.do("SliceObject", egg)
    (cracked,) = robot.controller.snapshot().of_type("EggCracked")
    assert cracked.id == f"{egg.id}|EggCracked_0"
    assert cracked.cookable


def test_slices_are_as_warm_as_the_whole_was(robot):
    potato = robot.fetch("Potato")
    fridge = robot.find("Fridge")
    robot.do("OpenObject", fridge)
    robot.do("PutObject", fridge)
    robot.do("SliceObject", potato)
    slices = robot.controller.snapshot().of_type("PotatoSliced")
    assert {piece.temperature for piece in slices} == {"Cold"}


def test_what_is_in_the_hand_cannot_be_sliced(robot):
    apple = robot.fetch("Apple")
    event = robot("SliceObject", objectId=apple.id)
    assert event.message == "target object cannot be sliced if it is in the agent's hand"


def test_a_counter_cannot_be_sliced(robot):
    counter = robot.find("CounterTop")
    robot.go(counter)
    event = robot("SliceObject", objectId=counter.id)
    assert event.message == f"{counter.name} Does not have the CanBeSliced property!"


def test_a_plate_breaks_once(robot):
    plate = robot.find("Plate")
    robot.do("BreakObject", plate)
    assert robot.now(plate).broken
    assert "already broken" in robot("BreakObject", objectId=plate.id).message


def test_a_breaking_egg_cracks(robot):
    egg = robot.find("Egg")
    robot.reveal(egg)
    robot.do("BreakObject", egg)
    assert robot.controller.snapshot().of_type("EggCracked")


def test_an_apple_does_not_break(robot):
    apple = robot.find("Apple")
    robot.go(apple)
    assert not robot("BreakObject", objectId=apple.id).success


def test_a_mug_gets_dirty_and_clean(robot):
    mug = robot.find("Mug")
    robot.do("DirtyObject", mug)
    assert robot.now(mug).dirty
    assert robot("DirtyObject", objectId=mug.id).message == "object is already dirty"
    robot.do("CleanObject", mug)
    assert not robot.now(mug).dirty
    assert robot("CleanObject", objectId=mug.id).message == "object is already clean"


def test_an_apple_does_not_get_dirty(robot):
    apple = robot.find("Apple")
    robot.go(apple)
    assert "dirtyable" in robot("DirtyObject", objectId=apple.id).message
