"""Dumps: what a simulator says of its rooms, in files that are rooms again when imported."""

import json

import pytest

from reibench.__main__ import main
from reibench.household import load_room
from reibench.household.ithor import NOT_MODELLED, STANDING_KEY, read_dump

ROOM = "bathroom-1"


@pytest.mark.parametrize("world", ["embedded", "ai2thor:stand-in"])
def test_a_dumped_room_is_the_room_again(world, tmp_path, capsys):
    assert main(["dump", str(tmp_path), "--rooms", ROOM, "--world", world]) == 0
    assert "1 of 1 rooms" in capsys.readouterr().out
    room, again = load_room(ROOM), read_dump(tmp_path / f"{ROOM}.json")
    assert [each.id for each in again.objects] == [each.id for each in room.objects]
    assert [each.contents for each in again.objects] == [each.contents for each in room.objects]
    assert again.kind == room.kind
    assert again.controls == room.controls
    assert set(again.reachable) == set(room.reachable)


def test_a_real_room_dumped_is_the_file_it_came_from(real_rooms, shared_data, tmp_path):
    assert main(["dump", str(tmp_path), "--rooms", "FloorPlan30,FloorPlan41?"]) == 0
    names = sorted(path.name for path in tmp_path.iterdir())
    assert len(names) == 11
    for name in names:
        made = json.loads((tmp_path / name).read_text())
        real = json.loads((shared_data / "ithor" / name).read_text())
        assert made.pop(STANDING_KEY)
        for described in (*made.values(), *real.values()):
            for key in NOT_MODELLED:
                described.pop(key)
        assert made == real


def test_a_room_that_is_not_there_is_told_and_the_others_dumped(tmp_path, capsys):
    assert main(["dump", str(tmp_path), "--rooms", "nowhere"]) == 2
    assert "No room called 'nowhere'" in capsys.readouterr().err


def test_the_rooms_that_come_along_are_not_imported_over(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("REIBENCH_ROOMS", str(tmp_path / "rooms"))
    main(["dump", str(tmp_path), "--rooms", ROOM])
    assert main(["import", "ithor", str(tmp_path)]) == 1
    assert "comes along" in capsys.readouterr().err
