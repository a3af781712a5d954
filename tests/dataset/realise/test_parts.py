"""The marked parts: enough of each, long enough, and refused by name where they are wrong."""

import re

import pytest

from reibench.dataset.realise.nouns import ambiguous_names, nouns
from reibench.dataset.realise.parts import parts, read_parts
from reibench.dataset.seeds import PROPORTIONS, ROOM_KINDS, kind_of, options
from reibench.errors import ReibenchError
from reibench.household import load_room, room_names
from reibench.household.objects import object_types

ROLES_OF_EVERY_TASK = ("intro", "advice", "exchange", "plan", "place", "request")


def test_every_task_there_is_finds_several_parts_for_every_turn():
    rooms = [load_room(name) for name in room_names()]
    pairs = {(goal.object, task) for task in PROPORTIONS for goal, _ in options(rooms, task)}
    for name, task in pairs:
        for role in ROLES_OF_EVERY_TASK:
            suited = [
                part
                for part in parts()
                if part.role == role
                and task in part.tasks
                and (not part.kinds or part.kinds & {kind_of(name), name})
            ]
            assert len(suited) >= 4, f"{role} for {task.short} {name}: {len(suited)}"
    assert ROOM_KINDS.keys() == PROPORTIONS.keys()


def test_turns_made_of_one_part_have_twenty_words():
    for part in parts():
        if part.role in ("exchange", "plan", "place"):
            for turn in range(len(part.turns)):
                assert part.words(turn) >= 20, part.text


def test_openings_suit_people_of_all_ages_and_say_nothing_twice():
    openings = [part for part in parts() if part.role == "opening"]
    ages = [int(re.findall(r"\d+", part.who)[-1]) for part in openings]
    assert sum(age < 18 for age in ages) >= 5
    assert sum(age >= 70 for age in ages) >= 5
    assert len({part.text for part in parts()}) == len(parts())


def test_noise_says_the_name_exactly_once():
    noise = [part for part in parts() if part.role == "noise"]
    assert {kind for part in noise for kind in part.kinds} == {
        name.category for name in ambiguous_names()
    }
    assert all(part.text.count("{name}") == 1 for part in noise)


def test_names_look_like_things_there_are():
    assert {name.decoy for name in ambiguous_names()} <= set(object_types())
    assert set(nouns()) <= set(object_types())


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("I like [the].", r"line 1: a line '== role"),
        ("== intro | food", "line 1: not enough values"),
        ("== ending | * | *", "line 1: the role 'ending' is none of opening"),
        ("== intro | food | boil", "line 1: boil is no task type"),
        ("== intro | food | pick\nI like [thee].", "line 2: the slot .thee. is none of the"),
        ("== intro | food | pick\nI like [the.", "line 2: '.' stands alone near 'I like .the.'"),
        (
            "== exchange | food | pick\nI like [the].",
            "line 2: a part for exchange has 2 turns, not 1",
        ),
        ("== plan | food | pick\nI like {-[the].", "line 2: a brace is not closed"),
    ],
)
def test_a_part_that_cannot_be_understood_is_named(tmp_path, text, said):
    path = tmp_path / "parts.txt"
    path.write_text(text)
    with pytest.raises(ReibenchError, match=said):
        list(read_parts(path))
