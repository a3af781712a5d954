"""Why a run failed, in a sentence that the record bears out."""

from dataclasses import replace

import pytest

from reibench.episode import Goal, TaskType
from reibench.explanation import explain, taken


@pytest.fixture
def fail(click, episode):
    """Play skills in an episode, perhaps with another goal, and return the record."""

    def fail(*skills, goal=None, done=True, max_steps=30):
        task = replace(episode.task, goal=goal) if goal else episode.task
        rollout = click(replace(episode, task=task), *skills, max_steps=max_steps)
        if done:
            rollout.finish()
        return rollout.record("r", "saycan")

    return fail


def test_success_says_what_holds(fail, solution):
    assert explain(fail(*solution)) == "A heated potato is on a dining table."


def test_a_breakdown_says_what_broke(click, episode):
    record = click(episode, "find an apple").record("r", "saycan", error="the model is gone")
    assert explain(record) == "The model is gone."


def test_a_vague_expression_is_named_with_what_it_was_taken_for(fail, episode):
    record = fail("find an apple", "pick up the apple")
    said = next(e.text for e in episode.dialogue.instruction.expressions if not e.explicit)
    assert explain(record) == f"“{said}” was taken for an apple at step 1; it means the potato."
    assert taken(record) == "Apple"


def test_nothing_taken_is_said_as_such(fail):
    assert explain(fail("find a sofa")).endswith("none was ever picked up, nor was anything else.")
    assert taken(fail("find a sofa")) == ""
    assert "though it was found at step 1" in explain(fail("find a potato"))


def test_a_thing_that_could_not_be_picked_up_says_why(fail):
    said = explain(fail("pick up the potato"))
    assert said.startswith("Picking up the potato was refused at step 1: ")


def test_a_thing_left_in_the_wrong_place_is_said_with_its_step(fail):
    goal = Goal(TaskType.PICK, "Potato", "Fridge")
    skills = ("find a potato", "pick up the potato", "find a sink", "put down the potato")
    assert (
        explain(fail(*skills, goal=goal))
        == "The potato was left in a sink at step 4, not in the fridge."
    )


def test_a_missing_treatment_is_named(fail):
    skills = ("find a potato", "pick up the potato", "find a dining table", "put down the potato")
    assert (
        explain(fail(*skills))
        == "The potato was put on the dining table at step 4, but never heated."
    )


def test_being_stuck_counts_the_refusals(fail):
    skills = ("find a potato", "pick up the potato", *["find a potato"] * 4)
    assert explain(fail(*skills)).startswith(
        "“find a potato” was refused 4 times, from step 3 on: "
    )


def test_a_condition_that_was_lost_is_said_with_its_step(fail, solution):
    record = fail(*solution, "pick up the potato")
    assert "was lost at step" in explain(record)
    assert "(pick up the potato)" in explain(record)


def test_stopping_early_says_what_was_still_to_come_true(fail):
    record = fail("find a potato", "pick up the potato")
    assert explain(record).startswith("It was said to be done after step 2; ")
    spent = fail("find a potato", "pick up the potato", done=False, max_steps=2)
    assert explain(spent).startswith("All 2 steps were used; ")


def test_the_second_of_two_things_is_named_too(fail):
    goal = Goal(TaskType.STACK, "Egg", "CounterTop", "Bowl")
    said = explain(fail("find a sofa", goal=goal))
    assert said.endswith("No bowl was picked up either.")
