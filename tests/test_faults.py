"""Each finer kind of failure, in an episode that a person played to show it."""

import pytest

from reibench.faults import FaultKind, fault_kind
from reibench.verdict import ErrorKind, error_kind

FETCHED = ("find a potato", "pick up the potato")
HEATED = (
    *FETCHED, "find a microwave", "open the microwave", "put down the potato",
    "close the microwave", "turn on the microwave", "turn off the microwave", "open the microwave",
    "pick up the potato",
)  # fmt: skip
PLACED = ("find a dining table", "put down the potato")
STACKED = ("find a pencil", "pick up the pencil", "find a mug", "put down the pencil")


@pytest.fixture
def fault(episodes, click):
    """Play a task by hand and say what it failed by; `done` at the end ends it."""

    def play(task: str, *skills: str, max_steps: int = 30) -> FaultKind | None:
        done = skills[-1] == "done"
        acted = skills[:-1] if done else skills
        rollout = click(episodes[f"{task}.explicit-standard"], *acted, max_steps=max_steps)
        if done:
            rollout.finish()
        else:
            assert rollout.exhausted
        return fault_kind(rollout.record("r", "person"))

    return play


def test_a_success_has_no_fault(fault):
    assert fault("heat_potato", *HEATED, *PLACED, "done") is None


def test_taking_something_else_is_the_wrong_object(fault):
    tomato = ("find a tomato", "pick up the tomato", "find a dining table", "put down the tomato")
    assert fault("heat_potato", *tomato, "done") is FaultKind.WRONG_OBJECT


def test_reaching_for_something_else_is_the_wrong_object_even_if_it_is_refused(fault):
    assert fault("heat_potato", "pick up the tomato", "done") is FaultKind.WRONG_OBJECT


def test_asking_for_the_same_refused_skill_again_and_again_is_a_repeated_failure(fault):
    again = ["put down the potato"] * 4
    assert fault("heat_potato", *again, max_steps=4) is FaultKind.REPEATED_FAILURE
    stuck = [*FETCHED, *["open the fridge"] * 4]
    assert fault("heat_potato", *stuck, max_steps=6) is FaultKind.REPEATED_FAILURE


def test_what_works_in_the_end_is_no_repeated_failure(fault):
    skills = [*["pick up the potato"] * 3, *FETCHED, "done"]
    assert fault("heat_potato", *skills) is FaultKind.STOPPED_EARLY


def test_ending_elsewhere_is_the_wrong_receptacle(fault):
    elsewhere = (*HEATED, "find a counter top", "put down the potato", "done")
    assert fault("heat_potato", *elsewhere) is FaultKind.WRONG_RECEPTACLE
    bowl = ("find a pencil", "pick up the pencil", "find a desk", "put down the pencil")
    carried = ("find a mug", "pick up the mug", "find a desk", "put down the mug")
    assert fault("stack_pencil_mug", *bowl, *carried, "done") is FaultKind.WRONG_RECEPTACLE


def test_a_tool_on_the_way_is_not_the_wrong_receptacle(fault):
    assert fault("heat_potato", *HEATED[:-1], "done") is FaultKind.STOPPED_EARLY


def test_leaving_out_the_treatment_is_a_missing_step(fault):
    assert fault("heat_potato", *FETCHED, *PLACED, "done") is FaultKind.MISSING_STEP


def test_treating_one_and_placing_it_before_is_the_wrong_order(fault):
    before = (*FETCHED, *PLACED, "pick up the potato", *HEATED[2:])
    assert fault("heat_potato", *before, "done") is FaultKind.WRONG_ORDER


def test_saying_done_on_the_way_is_stopping_early(fault):
    assert fault("heat_potato", *FETCHED, "done") is FaultKind.STOPPED_EARLY
    assert fault("heat_potato", "done") is FaultKind.STOPPED_EARLY


def test_running_out_of_steps_on_the_way_is_a_spent_budget(fault):
    assert fault("heat_potato", *HEATED[:6], max_steps=6) is FaultKind.BUDGET_SPENT


def test_failing_once_to_take_the_right_thing_is_a_missing_step(fault):
    assert fault("heat_potato", "pick up the potato", "done") is FaultKind.MISSING_STEP


def test_an_episode_that_broke_has_no_fault(click, episode):
    record = click(episode).record("r", "person", error="ModelUnavailable: gone")
    assert fault_kind(record) is None


def test_a_lamp_found_lit_is_not_omitted_even_if_it_is_left_behind(shipped, click):
    [episode] = [each for each in shipped if each.id == "examine_remotecontrol_2.mixed-noised"]
    rollout = click(
        episode, "find a desk lamp", "find a remote control", "pick up the remote control"
    )
    rollout.finish()
    assert error_kind(rollout.record("r", "person")) is ErrorKind.EXECUTION
