"""Real rooms: what was read comes out again, and the robot stands where AI2-THOR's stood."""

import json
from collections import Counter

import pytest

from reibench.__main__ import main
from reibench.errors import InvalidRoom
from reibench.household import Controller, load_room, scene_from_metadata
from reibench.household.geometry import bottom
from reibench.household.ithor import NOT_MODELLED, read_dump

SPAN = 0.25


def dumps(shared_data):
    for path in sorted((shared_data / "ithor").glob("*.json")):
        yield path.stem.removesuffix("_physics"), json.loads(path.read_text(encoding="utf-8"))


def test_metadata_come_out_of_every_real_room_as_they_went_in(real_rooms, shared_data):
    compared = 0
    for name, described in dumps(shared_data):
        metadata = Controller(name).last_event.metadata
        made = {each["objectId"]: each for each in metadata["objects"]}
        assert list(made) == list(described)
        for object_id, real in described.items():
            ours = made[object_id]
            assert ours.keys() == real.keys()
            wrong = [key for key in real if key not in NOT_MODELLED and ours[key] != real[key]]
            assert not wrong, (name, object_id, wrong)
            compared += 1
    assert compared == 5479
    assert len(real_rooms) == 116


def test_the_scene_read_from_a_real_rooms_metadata_is_the_snapshot(real_rooms):
    for name in real_rooms:
        controller = Controller(name)
        assert scene_from_metadata(controller.last_event.metadata) == controller.snapshot()


def test_the_number_of_a_real_room_tells_its_kind(real_rooms):
    kinds = Counter(load_room(name).kind for name in real_rooms)
    assert kinds == {"kitchen": 29, "living room": 29, "bedroom": 29, "bathroom": 29}
    assert load_room("FloorPlan5").kind == "kitchen"
    assert load_room("FloorPlan402").kind == "bathroom"


def test_the_robot_can_stand_where_it_really_stood(real_rooms, shared_data):
    stood = standing_points(shared_data)
    free = {name: cells(load_room(name)) for name in real_rooms if name in stood}
    met = sum(len(stood[name] & free[name]) for name in free)
    asked = sum(len(stood[name]) for name in free)
    assert asked > 1300
    assert met / asked > 0.95


def test_hardly_anything_lies_where_the_robot_is_said_to_stand(real_rooms):
    lying = under = 0
    for name in real_rooms:
        room = load_room(name)
        free = cells(room)
        for thing in room.objects:
            raised = bottom(thing.box) > 0.3
            if thing.pickupable and raised and not any("Floor" in each for each in thing.parents):
                lying += 1
                middle = thing.box.center
                under += (round(middle.x / SPAN), round(middle.z / SPAN)) in free
    assert lying > 1400
    assert under / lying < 0.05


def test_almost_everything_in_a_real_room_is_within_reach_of_the_floor(real_rooms):
    far = []
    for name in real_rooms:
        room = load_room(name)
        for thing in room.objects:
            if thing.type != "Floor" and (thing.receptacle or thing.pickupable):
                area = room.footprints[thing.id]
                if min(area.distance(at.x, at.z) for at in room.reachable) > 1.5:
                    far.append((name, thing.type))
    assert far == [("FloorPlan412", "Towel"), ("FloorPlan412", "TowelHolder")]


def test_things_put_on_a_counter_around_a_corner_lie_on_it(real_rooms):
    controller = Controller("FloorPlan19")
    counter = "CounterTop|-01.79|+00.95|-03.80"
    inside = [at for at in controller.reachable() if at.z < -2.8]
    assert inside, "the robot stands in the corner the counter goes around"
    for number, point in enumerate(inside[:8]):
        controller.reset()
        mug = controller.snapshot().of_type("Mug")[0]
        controller.step("Teleport", position=point._asdict(), rotation=90.0 * number)
        assert controller.step("PickupObject", objectId=mug.id, forceAction=True).success
        assert controller.step("PutObject", objectId=counter, forceAction=True).success
        middle = controller.snapshot().by_id[mug.id].box.center
        assert all(abs(middle.x - at.x) + abs(middle.z - at.z) > 0.1 for at in inside)


def test_taking_a_cup_leaves_the_counter_that_is_listed_in_it(real_rooms):
    for name in real_rooms:
        room = load_room(name)
        for thing in room.objects:
            if thing.pickupable and any(not _loose(room, each) for each in thing.contents or ()):
                controller = Controller(room)
                taken = controller.step("PickupObject", objectId=thing.id, forceAction=True)
                assert taken.success
                after = controller.snapshot().by_id
                moved = [one.id for one in room.objects if after[one.id].box != one.box]
                assert all(_loose(room, one) for one in moved), (name, thing.id)
                assert thing.id in moved


def test_points_that_ai2thor_gave_are_where_the_robot_can_stand(shared_data, tmp_path):
    dump = json.loads((shared_data / "ithor" / "FloorPlan12_physics.json").read_text())
    points = [{"x": 0.1 + SPAN * step, "y": 0.9, "z": 0.6} for step in range(4)]
    path = tmp_path / "FloorPlan12_physics.json"
    path.write_text(json.dumps(dump | {"reachablePositions": points}))
    controller = Controller(read_dump(path))
    assert [point._asdict() for point in controller.reachable()] == points
    assert controller.step("Teleport", position=points[2]).success
    assert controller.step("MoveRight").success
    assert not controller.step("MoveRight").success


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (lambda dump: [], "one JSON object"),
        (lambda dump: {"x": 1}, "no object metadata"),
        (
            lambda dump: dump | {"A": next(iter(dump.values())) | {"objectType": "Sopfa"}},
            "Did you mean 'Sofa'",
        ),
        (
            lambda dump: {key: each for key, each in dump.items() if "Floor" in key},
            "something on it",
        ),
        (lambda dump: {key: {**each, "mass": None} for key, each in dump.items()}, "wrong form"),
        (lambda dump: {key: {"objectId": key} for key in dump}, "lack"),
    ],
)
def test_what_is_no_dump_is_told_and_the_rest_imported(
    spoil, message, shared_data, tmp_path, monkeypatch, capsys
):
    source = shared_data / "ithor" / "FloorPlan12_physics.json"
    dump = json.loads(source.read_text())
    (tmp_path / "FloorPlan12_physics.json").write_text(json.dumps(dump))
    (tmp_path / "FloorPlan13_physics.json").write_text(json.dumps(spoil(dump)))
    with pytest.raises(InvalidRoom, match=message):
        read_dump(tmp_path / "FloorPlan13_physics.json")
    monkeypatch.setenv("REIBENCH_ROOMS", str(tmp_path / "rooms"))
    assert main(["import", "ithor", str(tmp_path)]) == 1
    assert "1 of 2 files could not be read" in capsys.readouterr().out
    assert load_room("FloorPlan12").kind == "kitchen"


def test_a_folder_without_dumps_is_told(tmp_path, capsys):
    assert main(["import", "ithor", str(tmp_path)]) == 2
    assert "no dumps" in capsys.readouterr().err


def standing_points(shared_data):
    """Return the grid cells where the robots of ALFRED's trials stood, by room."""
    found = {}
    for path in (shared_data / "alfred").rglob("traj_data.json"):
        trial = json.loads(path.read_text(encoding="utf-8"))
        at = found.setdefault(trial["scene"]["floor_plan"], set())
        start = trial["scene"]["init_action"]
        at.add((round(start["x"] / SPAN), round(start["z"] / SPAN)))
        for action in trial["plan"]["high_pddl"]:
            if location := action["planner_action"].get("location"):
                at.add(tuple(map(int, location.split("|")[1:3])))
    return found


def cells(room):
    return {(round(at.x / SPAN), round(at.z / SPAN)) for at in room.reachable}


def _loose(room, name):
    return room.by_id[name].pickupable
