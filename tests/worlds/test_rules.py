"""What skills do and say under strict and official rules."""

import pytest

from reibench.planners import Decision
from reibench.rollout import Rollout
from reibench.skill import parse_skill
from reibench.worlds import worlds
from reibench.worlds.rules import OFFICIAL, STRICT, matches_by_substring, matches_exactly


@pytest.fixture
def official(episode):
    """Play under official rules."""

    def play(*skills):
        rollout = Rollout(episode, worlds.create("embedded", rules=OFFICIAL))
        rollout.start()
        for text in skills:
            rollout.step(Decision(parse_skill(text)))
        return rollout

    return play


def last(rollout):
    return rollout.steps[-1].event


def test_strict_says_what_is_held_instead(episode, click):
    event = last(click(episode, "find a tomato", "pick up the tomato", "put down the potato"))
    assert event.message == "the robot is holding the tomato, not the potato"


def test_strict_puts_things_where_the_robot_last_went(episodes, click):
    rollout = click(
        episodes["cool_apple.mixed-short"],
        *("find an apple", "pick up the apple", "find a counter top", "put down the apple"),
    )
    assert last(rollout).success
    assert [goal.name for goal in last(rollout).goals if goal.holds] == ["placed"]


def test_strict_refuses_to_put_things_into_something_closed(episode, click):
    rollout = click(
        episode, "find a tomato", "pick up the tomato", "find a microwave", "put down the tomato"
    )
    assert last(rollout).message == "the microwave is closed"
    assert last(rollout).scene.held is not None


def test_a_refused_skill_changes_nothing_under_strict_rules(episode, click):
    rollout = click(episode, "find a tomato", "pick up the tomato")
    before = rollout.last_event.scene
    for text in ("pick up the apple", "open the safe", "turn on the desk lamp", "slice the bread"):
        rollout.step(Decision(parse_skill(text)))
        assert not last(rollout).success, text
        assert last(rollout).scene == before, text


@pytest.mark.parametrize(
    ("skills", "message"),
    [
        (["find a safe"], "there is no safe in this room"),
        (["put down the tomato"], "the robot is not holding anything"),
        (["find a tomato", "pick up the tomato", "pick up the apple"],
         "the robot is already holding the tomato"),
        (["find a tomato", "pick up the tomato", "find a tomato"],
         "the tomato is in the robot's hand"),
        (["find a tomato", "pick up the tomato", "put down the tomato"],
         "the robot has not gone to a place to put it; find one first"),
        (["find a fridge", "close the fridge"], "the fridge is already closed"),
        (["find a microwave", "open the microwave", "turn on the microwave"],
         "the microwave is open; close it first"),
        (["find a microwave", "turn on the microwave", "open the microwave"],
         "the microwave is on; turn it off first"),
        (["find an apple", "slice the apple"],
         "the robot needs a knife in its hand to slice"),
    ],
)  # fmt: skip
def test_strict_feedback_says_what_is_wrong(episode, click, skills, message):
    event = last(click(episode, *skills))
    assert not event.success
    assert event.message == message


def test_finding_again_goes_to_the_next_one(episode, click):
    rollout = click(
        episode, "find a drawer", "open the drawer", "close the drawer",
        "find a drawer", "find a drawer", "open the drawer",
    )  # fmt: skip
    opened = [
        {drawer.id for drawer in rollout.steps[place].event.scene.of_type("Drawer") if drawer.open}
        for place in (1, 5)
    ]
    assert [len(each) for each in opened] == [1, 1]
    assert opened[0] != opened[1]


def test_what_is_in_something_closed_must_be_uncovered_first(episode, click):
    rollout = click(episode, "find an egg", "pick up the egg")
    assert last(rollout).message == "the egg is in the fridge, which is closed"
    for text in ("open the fridge", "pick up the egg"):
        rollout.step(Decision(parse_skill(text)))
        assert last(rollout).success


def test_official_put_down_ignores_the_noun(official):
    rollout = official(
        "find a tomato", "pick up the tomato", "find a dining table", "put down the potato"
    )
    assert last(rollout).success
    assert last(rollout).scene.held is None


def test_official_put_down_into_something_closed_ends_on_the_floor(official):
    rollout = official(
        "find a tomato", "pick up the tomato", "find a microwave", "put down the tomato"
    )
    assert last(rollout).message == "put down failed"
    [tomato] = last(rollout).scene.of_type("Tomato")
    assert last(rollout).scene.held is None
    assert any(parent.startswith("Floor") for parent in tomato.parents)


def test_official_forgets_the_place_after_any_other_skill(official):
    rollout = official(
        "find a microwave", "open the microwave", "find a tomato", "pick up the tomato",
        "put down the tomato",
    )  # fmt: skip
    assert last(rollout).message == "put down failed"


@pytest.mark.parametrize(
    ("skills", "message"),
    [
        (["find a safe"], "Cannot find Safe"),
        (["put down the tomato"], "Robot is not holding any object"),
        (["find a tomato", "pick up the tomato", "pick up the apple"],
         "Robot is currently holding Tomato"),
        (["open the safe"], "Cannot find Safe to open"),
        (["find a fridge", "open the fridge", "open the fridge"], "Open action failed"),
    ],
)  # fmt: skip
def test_official_feedback_is_the_published_text(official, skills, message):
    assert last(official(*skills)).message == message


def test_official_matching_lets_a_slice_pass_for_the_whole_and_strict_does_not(official):
    rollout = official("find an apple", "slice the apple")
    assert last(rollout).success
    piece = last(rollout).scene.of_type("AppleSliced")[0]
    assert matches_by_substring(piece, "Apple")
    assert not matches_exactly(piece, "Apple")


def test_strict_slicing_works_with_a_knife_in_hand(episode, click):
    rollout = click(
        episode, "find a knife", "pick up the knife", "find an apple", "slice the apple"
    )
    assert last(rollout).success, last(rollout).message
    assert last(rollout).scene.of_type("AppleSliced")


def test_the_two_rules_differ_only_where_the_table_says():
    assert {
        name
        for name in ("repeated_find_moves_on", "knife_to_slice", "noun_decides_put_down",
                     "failed_put_down_drops", "places_anything")
        if getattr(STRICT, name) == getattr(OFFICIAL, name)
    } == set()  # fmt: skip


def test_the_robot_turns_to_what_stands_beside_it(episodes, click):
    """A fork at the far end of the sink is out of view from the sink's nearest edge."""
    rollout = click(
        episodes["clean_lettuce.mixed-short"],
        *("find a fork", "open the drawer", "pick up the fork", "find a sink"),
        *("put down the fork", "turn on the faucet", "pick up the fork"),
    )
    assert last(rollout).success


def test_turning_in_vain_is_undone(episode, click):
    rollout = click(episode, "find a tomato", "pick up the tomato", "find a microwave")
    before = last(rollout).scene
    rollout.step(Decision(parse_skill("put down the tomato")))
    assert not last(rollout).success
    assert last(rollout).scene == before


def test_what_may_go_into_a_sink_may_go_into_its_basin(episodes, click):
    rollout = click(
        episodes["clean_lettuce.mixed-short"],
        *("find a soap bottle", "pick up the soap bottle", "find a sink"),
        "put down the soap bottle",
    )
    assert last(rollout).success
