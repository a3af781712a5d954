"""`compare-rooms` and `list rooms`: what the shipped rooms have, beside the real ones."""

import json
from collections import Counter
from pathlib import Path

import pytest

from reibench.__main__ import main
from reibench.household import load_room
from reibench.household.plans import PLANS

DOCUMENT = Path(__file__).parents[2] / "docs" / "rooms.md"


@pytest.fixture
def call(capsys):
    def run(*arguments):
        status = main(arguments)
        return status, capsys.readouterr()

    return run


def test_the_committed_tables_are_what_the_command_prints(call):
    status, printed = call("compare-rooms", "--markdown")
    assert status == 0
    assert printed.out == DOCUMENT.read_text(), "run the command docs/rooms.md names"


def test_all_statistics_are_one_json_object(call):
    _, printed = call("compare-rooms", "--json")
    found = json.loads(printed.out)
    assert list(found) == ["kitchen", "living room", "bedroom", "bathroom"]
    assert found["kitchen"]["made"]["rooms"] == 30
    assert found["kitchen"]["likeness"]["shares"] > 0.99
    assert sum(found["bedroom"]["real"]["types"]["Bed"]["counts"]) == 31


def test_without_options_rooms_are_compared_as_wholes(call):
    _, printed = call("compare-rooms")
    assert printed.out.count("things put away") == 4


def test_real_rooms_measured_anew_are_as_they_were(call, shared_data):
    _, kept = call("compare-rooms", "--markdown")
    status, anew = call("compare-rooms", "--markdown", "--real", str(shared_data / "ithor"))
    assert (status, anew.out) == (0, kept.out)


def test_a_folder_without_dumps_is_a_mistake(call, tmp_path):
    status, printed = call("compare-rooms", "--real", str(tmp_path))
    assert status == 2
    assert "has no dump of any kitchen" in printed.err


def test_rooms_are_listed_with_what_is_in_them(call):
    _, printed = call("list", "rooms", "--json")
    rows = {row["room"]: row for row in json.loads(printed.out)}
    assert set(rows) >= set(PLANS)
    room = load_room("bedroom-7")
    assert rows["bedroom-7"]["kind"] == "bedroom"
    assert rows["bedroom-7"]["objects"] == Counter(thing.type for thing in room.objects)
    size = room.bounds.size
    assert rows["bedroom-7"]["area"] == pytest.approx(size.x * size.z, abs=0.1)
    _, printed = call("list", "rooms")
    assert len(printed.out.splitlines()) == len(rows) + 2
