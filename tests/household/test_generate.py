import pytest

from reibench.errors import InvalidRoom, UnknownName
from reibench.household import generate_room, load_room
from reibench.household.generate import approachable, planned_room, shortcomings
from reibench.household.geometry import footprint
from reibench.household.objects import ROOM_KINDS
from reibench.household.plans import PLANS

SEEDS = range(20)


@pytest.mark.parametrize("name", [name for name, plan in PLANS.items() if not plan.stratum])
def test_the_rooms_that_come_with_the_project_are_up_to_date(name):
    told = "run python -m reibench.household.generate"
    assert planned_room(name, PLANS[name]) == load_room(name), told


@pytest.mark.parametrize("kind", ROOM_KINDS)
def test_the_same_seed_gives_the_same_room_and_another_one_another(kind):
    one = generate_room(kind, 5, name="one")
    assert generate_room(kind, 5, name="one") == one
    assert generate_room(kind, 6, name="one").objects != one.objects


@pytest.mark.parametrize("kind", ROOM_KINDS)
@pytest.mark.parametrize("seed", SEEDS)
def test_in_every_room_all_can_be_got_at_and_all_lies_in_its_place(kind, seed):
    room = generate_room(kind, seed, name="any")
    assert not shortcomings(room)
    assert 25 <= len(room.objects) <= 90
    assert all(approachable(room, thing) for thing in room.objects if thing.receptacle)
    _assert_in_place(room)
    _assert_furniture_apart(room)


@pytest.mark.parametrize("kind", ROOM_KINDS)
@pytest.mark.parametrize("number", [25, 50, 100, 200])
def test_a_room_has_about_as_many_objects_as_asked_for(kind, number):
    room = generate_room(kind, 1, name="big", objects=number)
    assert abs(len(room.objects) - number) <= number * 0.1


def test_required_types_are_there_and_others_stay_away():
    room = generate_room(
        "bedroom", 3, name="mine", require=("Desk", "Mug", "Pen"), allow=("Pillow",)
    )
    small = {thing.type for thing in room.objects if thing.pickupable}
    assert {"Mug", "Pen"} <= small <= {"Mug", "Pen", "Pillow"}
    assert any(thing.type == "Desk" for thing in room.objects)


def test_a_thing_starts_where_it_is_said_to():
    room = generate_room("kitchen", 4, name="mine", require=("Apple",), where={"Apple": "Fridge"})
    apple = next(thing for thing in room.objects if thing.type == "Apple")
    assert apple.parents[0].startswith("Fridge")


def test_an_unknown_kind_or_type_is_refused():
    with pytest.raises(UnknownName, match="Did you mean 'kitchen'"):
        generate_room("kitchin", 1, name="x")
    with pytest.raises(UnknownName, match="Did you mean 'Apple'"):
        generate_room("kitchen", 1, name="x", require=("Appel",))


def test_what_cannot_be_had_is_refused():
    with pytest.raises(InvalidRoom, match="No bathroom with seed 1"):
        generate_room("bathroom", 1, name="x", require=("Fridge",))


def _assert_in_place(room):
    """What is in something lies within its outline; no two things are in one place."""
    by_id = room.by_id
    for thing in room.objects:
        x, _, z = thing.box.center
        for parent in thing.parents:
            assert thing.id in by_id[parent].contents
            assert footprint(by_id[parent].box).grown(0.01).covers(x, z), thing.id
    small = [thing for thing in room.objects if thing.pickupable]
    for number, one in enumerate(small):
        for other in small[:number]:
            if one.parents == other.parents:
                assert not _meet(one.box, other.box), f"{one.id} and {other.id}"


def _assert_furniture_apart(room):
    floor = next(thing.id for thing in room.objects if thing.type == "Floor")
    standing = [thing for thing in room.objects if floor in thing.parents]
    for number, one in enumerate(standing):
        for other in standing[:number]:
            # Chairs are pushed under tables.
            if "Chair" not in (one.type, other.type):
                assert not _meet(one.box, other.box), f"{one.id} and {other.id}"


def _meet(one, other):
    return all(
        abs(one.center[axis] - other.center[axis]) * 2 + 0.03 < one.size[axis] + other.size[axis]
        for axis in range(3)
    )
