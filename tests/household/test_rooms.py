import json

import pytest

from reibench.errors import InvalidRoom, UnknownName
from reibench.household import load_room, room_names
from reibench.household.plans import PLANS
from reibench.household.rooms import format_room, parse_room, save_room


def test_there_are_thirty_rooms_of_each_kind():
    kinds = [load_room(name).kind for name in room_names()]
    assert sorted(set(kinds)) == ["bathroom", "bedroom", "kitchen", "living room"]
    assert all(kinds.count(kind) == 30 for kind in kinds)


def test_a_room_is_the_same_after_saving_and_loading(tmp_path):
    room = load_room("kitchen-1")
    save_room(room, tmp_path / "copy.json")
    assert load_room(tmp_path / "copy.json") == room


def test_an_unknown_room_is_told_with_the_nearest_known_one():
    with pytest.raises(UnknownName, match="Did you mean 'kitchen-1'"):
        load_room("kitchen1")


def test_a_missing_file_is_told_by_its_path(tmp_path):
    with pytest.raises(UnknownName, match=r"nowhere\.json"):
        load_room(tmp_path / "nowhere.json")


def test_a_damaged_file_is_told_in_one_sentence(tmp_path):
    (tmp_path / "bad.json").write_text('{"name": "x", ', encoding="utf-8")
    with pytest.raises(InvalidRoom, match=r"bad\.json cannot be read as JSON"):
        load_room(tmp_path / "bad.json")


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (lambda room: room.pop("bounds"), "'bounds' is missing"),
        (lambda room: room["objects"][1].pop("box"), "'box' is missing"),
        (lambda room: room["objects"][1].update(box=[1, 2]), "wrong form"),
        (lambda room: room["objects"][1].update({"in": ["Attic|1|2|3"]}), "not in the room"),
        (lambda room: room["objects"][1].update(id="Frigde|1|2|3"), "Did you mean 'Fridge'"),
        (lambda room: room["objects"].append(room["objects"][0]), "is in it twice"),
        (lambda room: room["controls"].update({"StoveKnob|1": []}), "not in the room"),
    ],
)
def test_an_impossible_room_is_told_in_one_sentence(spoil, message):
    content = json.loads(format_room(load_room("kitchen-1")))
    spoil(content)
    with pytest.raises(InvalidRoom, match=message):
        parse_room(content)


def test_a_room_file_has_one_object_a_line():
    room = load_room("bedroom-1")
    lines = format_room(room).splitlines()
    assert sum('"id":' in line for line in lines) == len(room.objects)


def test_reachable_positions_are_on_the_grid_and_clear_of_furniture():
    room = load_room("living-room-1")
    sofa = next(thing for thing in room.objects if thing.type == "Sofa")
    for x, _, z in room.reachable:
        assert x % 0.25 == 0
        assert z % 0.25 == 0
        inside_x = abs(x - sofa.box.center.x) < sofa.box.size.x / 2 + 0.2
        assert not (inside_x and abs(z - sofa.box.center.z) < sofa.box.size.z / 2 + 0.2)


@pytest.mark.parametrize("name", [name for name, plan in PLANS.items() if plan.closed])
def test_a_room_of_a_dialogue_has_all_it_speaks_of_and_no_other_small_things(name):
    room, plan = load_room(name), PLANS[name]
    types = [thing.type for thing in room.objects]
    assert set(plan.require) <= set(types)
    small = {thing.type for thing in room.objects if thing.pickupable}
    assert small <= set(plan.require)
    several = {"Pillow", "Statue", "Vase"}
    assert not [name for name in small - several if types.count(name) > 1]


@pytest.mark.parametrize("name", [name for name, plan in PLANS.items() if not plan.stratum])
def test_something_in_each_room_is_inside_something_closed(name):
    scene = _scene(name)
    assert any(scene.closed_around(thing) for thing in scene.objects if thing.pickupable)


def _scene(name):
    from reibench.household import Controller

    return Controller(name).snapshot()
