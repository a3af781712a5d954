"""The rooms made like real ones: sound, solvable, and like them in numbers."""

from collections import Counter
from random import Random
from statistics import mean

import pytest

from reibench.errors import UnknownName
from reibench.household import load_room, scene_from_metadata
from reibench.household.generate import generate_home, planned_room, shortcomings
from reibench.household.habits import (
    Stratum,
    draw_inventory,
    format_statistics,
    read_statistics,
    real_rooms,
)
from reibench.household.likeness import likeness
from reibench.household.objects import ROOM_KINDS
from reibench.household.plans import PLANS
from reibench.household.rooms import format_room
from reibench.household.statistics import from_json, measure, to_json
from reibench.skill import OPENABLE, PICKABLE, RECEPTACLES, TOGGLEABLE

HOMES = [name for name, plan in PLANS.items() if plan.stratum]
PARTS = frozenset(
    "Drawer Shelf Sink SinkBasin BathtubBasin StoveBurner StoveKnob Faucet Blinds Curtains"
    " ShowerCurtain ShelvingUnit Floor Window".split()
)
"""What is let into something else, hangs before it, or is open and has things in it."""
SEATS = ("Chair", "Stool")
APPLIANCES = "CoffeeMachine DeskLamp HousePlant Microwave Television Toaster".split()


@pytest.fixture(scope="module")
def homes():
    return {name: load_room(name) for name in HOMES}


@pytest.fixture(scope="module")
def made():
    rooms = [load_room(name) for name in PLANS]
    return {kind: measure([r.objects for r in rooms if r.kind == kind]) for kind in ROOM_KINDS}


def test_there_are_thirty_rooms_of_each_kind():
    assert Counter(plan.kind for plan in PLANS.values()) == dict.fromkeys(ROOM_KINDS, 30)


@pytest.mark.parametrize("kind", ROOM_KINDS)
def test_the_homes_that_come_with_the_project_are_up_to_date(kind, homes):
    for name in (name for name in HOMES if PLANS[name].kind == kind):
        told = f"{name}: run python -m reibench.household.generate"
        assert format_room(planned_room(name, PLANS[name])) == format_room(homes[name]), told


def test_everything_used_can_be_got_at(homes):
    for name, room in homes.items():
        assert not shortcomings(room, hiding=False), name


def test_solid_things_keep_clear_of_each_other(homes):
    for name, room in homes.items():
        solid = [each for each in room.objects if not each.pickupable and each.type not in PARTS]
        for number, one in enumerate(solid):
            for other in solid[:number]:
                seated = one.type in SEATS or other.type in SEATS
                assert seated or not _meet(one, other), f"{name}: {one.id} and {other.id}"


def test_no_two_things_are_in_one_place(homes):
    for name, room in homes.items():
        small = [each for each in room.objects if each.pickupable]
        large = [each for each in room.objects if each.type in APPLIANCES]
        for number, one in enumerate(small):
            for other in (*small[:number], *large):
                held = one.id in (other.contents or ()) or other.id in (one.contents or ())
                assert held or not _meet(one, other), f"{name}: {one.id} and {other.id}"


def test_what_lies_somewhere_lies_within_its_outline(homes):
    for name, room in homes.items():
        for thing in (each for each in room.objects if each.pickupable):
            assert thing.parents, f"{name}: {thing.id} is nowhere"
            x, _, z = thing.box.center
            holder = room.footprints[thing.parents[0]]
            assert holder.grown(0.02).covers(x, z), f"{name}: {thing.id}"


def test_whatever_can_be_asked_for_is_in_several_rooms():
    rooms = [load_room(name) for name in PLANS]
    found = Counter(kind for room in rooms for kind in {each.type for each in room.objects})
    asked = {*PICKABLE, *OPENABLE, *TOGGLEABLE, *RECEPTACLES} - {"Cart"}
    assert min(found[kind] for kind in asked) >= 4, found.most_common()[-5:]


@pytest.mark.parametrize("kind", ROOM_KINDS)
def test_a_home_is_decided_by_its_seed(kind):
    one = generate_home(kind, 7, name="one")
    assert generate_home(kind, 7, name="one") == one
    assert generate_home(kind, 8, name="one").objects != one.objects
    assert not shortcomings(one, hiding=False)


def test_a_home_of_an_unknown_kind_is_refused():
    with pytest.raises(UnknownName, match="Did you mean 'bedroom'"):
        generate_home("bedrom", 1, name="x")


@pytest.mark.parametrize("kind", ROOM_KINDS)
def test_the_rooms_of_a_sample_have_together_what_the_real_ones_have(kind):
    of = len(real_rooms()[kind].objects)
    drawn = [draw_inventory(kind, Random(0), Stratum(index, of)) for index in range(of)]
    for name, each in real_rooms()[kind].types.items():
        assert sorted(one.count(name) for one in drawn) == list(each.counts), name


@pytest.mark.parametrize("kind", ROOM_KINDS)
def test_made_rooms_are_like_real_ones(kind, made):
    one, other = made[kind], real_rooms()[kind]
    found = likeness((one, other))
    assert found.objects[0] == pytest.approx(found.objects[1], rel=0.03)
    assert found.area[0] == pytest.approx(found.area[1], rel=0.05)
    assert found.free[0] == pytest.approx(found.free[1], abs=0.13)
    assert found.shares > 0.99
    assert found.counts > 0.99
    assert found.places > 0.85
    assert found.contents > 0.8
    assert mean(one.portable) == pytest.approx(mean(other.portable), rel=0.05)
    assert mean(one.enclosed) == pytest.approx(mean(other.enclosed), abs=0.7)


def test_made_rooms_have_as_many_objects_as_real_ones_have(made):
    counts = [count for each in made.values() for count in each.objects]
    assert 25 <= min(counts) <= max(counts) <= 95
    assert mean(counts) == pytest.approx(47, abs=1)


def test_the_statistics_kept_are_those_of_the_real_rooms(shared_data):
    by_kind = {kind: [] for kind in ROOM_KINDS}
    for path in sorted((shared_data / "ithor").glob("*.json")):
        number = int(path.stem.removeprefix("FloorPlan").removesuffix("_physics"))
        kind = ROOM_KINDS[max(0, number // 100 - 1)]
        by_kind[kind].append(scene_from_metadata(_read(path)).objects)
    measured = {kind: measure(rooms) for kind, rooms in by_kind.items()}
    assert format_statistics(measured) == format_statistics(real_rooms())


def test_statistics_come_back_from_a_file_as_they_were(tmp_path, made):
    path = tmp_path / "made.json"
    path.write_text(format_statistics(made))
    assert read_statistics(path) == made
    assert from_json(to_json(made["kitchen"])) == made["kitchen"]


def test_statistics_count_what_is_there():
    room = load_room("kitchen-1")
    found = measure([room.objects])
    cups = found.types["Cup"]
    assert found.objects == (len(room.objects),)
    assert cups.found_on == {"Cabinet": 1}
    assert cups.share == cups.mean == 1
    assert found.types["Cabinet"].contents == pytest.approx(
        sum(each.parents[0].startswith("Cabinet") for each in room.objects if each.parents)
        / sum(each.type == "Cabinet" for each in room.objects),
        abs=1e-3,
    )
    assert found.area[0] <= room.bounds.size.x * room.bounds.size.z
    assert 0 < found.free[0] < 1


def _read(path):
    import json

    return json.loads(path.read_text())


def _meet(one, other):
    return all(
        abs(one.box.center[axis] - other.box.center[axis]) * 2 + 0.02
        < one.box.size[axis] + other.box.size[axis]
        for axis in range(3)
    )
