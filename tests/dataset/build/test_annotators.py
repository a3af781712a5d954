"""What annotators wrote: which words can be built on, and why others cannot."""

from dataclasses import replace
from pathlib import Path

import pytest

from reibench.dataset.alfred import Ask, Trial
from reibench.dataset.build.annotators import sort
from reibench.episode import Goal, ObjectPose, SceneSetup, TaskType
from reibench.household import load_room
from reibench.scene import Vector

ROOMS = {"heat": "kitchen-2", "cool": "kitchen-2", "clean": "kitchen-2", "examine": "bedroom-2"}


def trial(goal: Goal, *texts: str, room: str = "") -> Trial:
    room = room or ROOMS.get(goal.task_type.short, "living-room-2")
    origin = Vector(0, 0, 0)
    lying = {thing.type for thing in load_room(room).objects if thing.pickupable}
    poses = tuple(ObjectPose(name, origin, origin) for name in sorted(lying))
    setup = replace(SceneSetup(room), poses=poses)
    asks = tuple(Ask(text, ()) for text in texts)
    return Trial("trial_1", Path("x"), str(goal.task_type), goal, setup, (), asks)


HEAT = Goal(TaskType.HEAT, "Potato", "DiningTable")
LIGHT = Goal(TaskType.EXAMINE, "Book", "DeskLamp")
PICK = Goal(TaskType.PICK, "CreditCard", "ArmChair")
STACK = Goal(TaskType.STACK, "Fork", "Sink", "Mug")
CLEAN = Goal(TaskType.CLEAN, "SoapBottle", "CounterTop")
SLICE = Goal(TaskType.COOL, "Tomato", "CounterTop", sliced=True)


def reason(goal, text, room=""):
    [found] = sort(trial(goal, text, room=room))
    assert bool(found.reason) != bool(found.written)
    return found.reason


@pytest.mark.parametrize(
    ("goal", "text"),
    [
        (HEAT, "Put a hot potato on the kitchen table"),
        (HEAT, "To microwave a potato and place it on a dining table."),
        (HEAT, "put the reheated spud from the fridge on the table"),
        (LIGHT, "Examine a book by the light of a lamp."),
        (LIGHT, "Carry a book while turning on the desk lamp"),
        (PICK, "Place a card on a chair"),
        (PICK, "move the credit card from the couch to the arm chair"),
        (STACK, "Put a coffee mug with a fork in it in the sink."),
        (SLICE, "Put a chilled slice of tomato on the counter."),
        (SLICE, "cut the tomato with a knife, cool a piece, put it on the counter"),
    ],
)
def test_words_that_name_the_things_and_say_the_goal_are_sound(goal, text):
    assert reason(goal, text) == ""


@pytest.mark.parametrize(
    ("goal", "text", "why"),
    [
        (HEAT, "Put a potato on the dining table.", "the goal is not said"),
        (HEAT, "Put a nice potato in its place on the dining table.", "the goal is not said"),
        (HEAT, "Put a hot egg on the table.", "a wrong name"),
        (HEAT, "Heat it and put it on the table.", "no name"),
        (HEAT, "Heat the potato.", "the place is not said"),
        (HEAT, "Heat the potato and put it in the sink.", "other than the goal"),
        (HEAT, "Chill a hot potato and put it on the table.", "more than the goal"),
        (HEAT, "Slice and heat the potato and put it on the table.", "more than the goal"),
        (LIGHT, "Turn off the lamp with a book in hand.", "other than the goal"),
        (LIGHT, "Pick up a book from the bed.", "the goal is not said"),
        (LIGHT, "Turn on the lamp.", "no name"),
        (PICK, "", "nothing written"),
        (STACK, "Put a mug in the sink.", "no name"),
        (SLICE, "Put a cold tomato on the counter.", "the goal is not said"),
        (SLICE, "Put a cold tomato slice and a knife on the counter.", "more than the goal"),
        (CLEAN, "Clean the counter with the soap dispenser.", "other than the goal"),
    ],
)
def test_other_words_are_dropped_and_the_reason_is_told(goal, text, why):
    assert reason(goal, text) == why


def test_an_ordinary_name_is_sound_only_where_nothing_else_is_called_so():
    goal = Goal(TaskType.PICK, "Mug", "Shelf")
    assert reason(goal, "Put a cup on the shelf.", "bedroom-2") == ""
    heated = Goal(TaskType.HEAT, "Mug", "DiningTable")
    assert reason(heated, "Put a hot cup on the table.", "kitchen-2") == "a wrong name"


def test_nouns_and_places_are_the_annotators_but_never_where_things_lie():
    [found] = sort(trial(HEAT, "Heat a spud and put it on the round kitchen table by the window"))
    assert found.written is not None
    assert dict(found.written.nouns) == {"Potato": "spud"}
    assert found.written.place == "round kitchen table"
    [found] = sort(trial(PICK, "Put the card on the first chair to the left"))
    assert found.written is not None
    assert found.written.place == "armchair"


def test_two_object_trials_are_left_out():
    both = replace(trial(PICK, "Put two cards on the chair"), goal=None)
    assert [found.reason for found in sort(both)] == ["about two objects"]


def test_a_room_that_is_not_there_leaves_what_lies_about():
    away = replace(trial(PICK, "Place a card on a chair"), setup=SceneSetup("FloorPlan201"))
    [found] = sort(away)
    assert found.written is not None
    assert set(found.written.seed.present) == {"CreditCard", "ArmChair"}
