"""HPE: sub-goals, then steps, with a memory bank written and read by rules."""

import pytest

from reibench.backends.scripted import ScriptedBackend
from reibench.methods import Instruction
from reibench.planners.attempts import attempts
from reibench.planners.examples import examples
from reibench.planners.hpe import ASKED_AGAIN, STEPS_EACH, TRIES, HierarchicalPlanningAndExecution
from reibench.planners.subgoals import stretches

IN_FRIDGE = "the apple is in the fridge, which is closed"


def made(thought, kind):
    return [each.text for each in thought.artefacts if each.kind == kind]


def memory(thought):
    [text] = made(thought, "memory")
    return dict(line.split(": ", 1) for line in text.splitlines())


def play(played, asked, answers, refusals=()):
    backend = ScriptedBackend(answers)
    decisions, closing = played(HierarchicalPlanningAndExecution(backend), asked, refusals)
    return backend, decisions, closing


def test_each_sub_goal_is_reached_step_by_step(asked, played):
    answers = [" get the apple; put the apple in the fridge", "find an apple", "pick up the apple"]
    backend, decisions, closing = play(
        played, asked, [*answers, "done", "find a fridge", "put down the apple", "done"]
    )
    assert [one.skill.text for one in decisions] == [
        "find an apple", "pick up the apple", "find a fridge", "put down the apple",
    ]  # fmt: skip
    assert made(decisions[2], "plan") == ["done: get the apple\nnow: put the apple in the fridge"]
    assert made(closing, "plan") == ["done: get the apple\ndone: put the apple in the fridge"]
    assert "Sub-goal: get the apple\nRobot:" in backend.prompts[1].text
    assert backend.prompts[3].text.endswith("Robot: find an apple, pick up the apple,")


def test_the_next_sub_goal_reads_from_memory_what_happened_before_not_the_whole_history(
    asked, played
):
    answers = ["get the apple; put the apple in the fridge", "find an apple", "pick up the apple"]
    backend, _, _ = play(
        played,
        asked,
        [*answers, "find a fridge", "open the fridge", "pick up the apple", "done", "done"],
        [("pick up the apple", IN_FRIDGE)],
    )
    new = backend.prompts[-1].text[backend.prompts[-1].fixed :]
    assert new.endswith(
        "Memory: holding: the apple. at: the fridge. open: the fridge. finished: get the apple\n"
        "Sub-goal: put the apple in the fridge\nRobot:"
    )
    assert "find an apple" not in new


def test_memory_keeps_what_feedback_tells_and_forgets_what_was_mended(asked, played):
    answers = ["get the apple", "find an apple", "pick up the apple", "open the fridge"]
    refusals = [("pick up the apple", IN_FRIDGE)]
    _, decisions, closing = play(
        played, asked, [*answers, "pick up the apple", "turn on the faucet", "done"], refusals
    )
    assert memory(decisions[2]) == {
        "holding": "nothing",
        "at": "the apple",
        "seen": "the apple in the fridge",
        "failed": f"pick up the apple ({IN_FRIDGE})",
    }
    assert memory(decisions[4]) == {
        "holding": "the apple",
        "at": "the apple",
        "open": "the fridge",
    }
    assert memory(closing)["on"] == "the faucet"


@pytest.mark.parametrize(
    ("message", "entry"),
    [
        ("there is no apple in this room", ("not here", "apple")),
        ("Cannot find KeyChain", ("not here", "key chain")),
        ("Apple is not visible because it is in Fridge", ("seen", "the apple in the fridge")),
        ("the robot is already holding the mug", ("holding", "the mug")),
        ("Robot is currently holding CD", ("holding", "the CD")),
        ("the apple is in the robot's hand", ("holding", "the apple")),
    ],
)
def test_feedback_in_either_rules_words_is_understood(message, entry, asked, played):
    answers = ["get the apple", "pick up the apple", "done"]
    _, _, closing = play(played, asked, answers, [("pick up the apple", message)])
    assert entry in memory(closing).items()


def test_answers_without_a_sub_goal_are_asked_again_and_at_last_given_up(asked, played):
    backend, decisions, closing = play(played, asked, ["", " ; ;", "123"])
    assert decisions == []
    assert len(backend.prompts) == ASKED_AGAIN + 1
    assert "Wrong: there is no sub-goal" in backend.prompts[1].text
    assert "3 answers in a row had no sub-goal." in made(closing, "note")
    _, [decision], _ = play(played, asked, ["?", "1. look around", "find an apple", "done"])
    assert made(decision, "answer") == ["?", "1. look around"]


def test_a_sub_goal_that_is_never_done_is_left_for_the_next(asked, played):
    answers = ["get the apple; get the mug", *["find an apple"] * STEPS_EACH, "find a mug", "done"]
    _, decisions, closing = play(played, asked, answers)
    assert len(decisions) == STEPS_EACH + 1
    assert made(decisions[-1], "note") == [f"get the apple: not done after {STEPS_EACH} steps."]
    assert memory(closing)["finished"] == "get the mug"


def test_a_sub_goal_is_left_once_the_same_thing_has_failed_the_same_way_three_times(asked, played):
    answers = ["get the apple; get the mug", *["find an apple"] * TRIES, "find a mug", "done"]
    absent = [("find an apple", "there is no apple in this room")] * TRIES
    _, decisions, closing = play(played, asked, answers, absent)
    assert len(decisions) == TRIES + 1
    assert made(decisions[-1], "note") == [
        "get the apple: find an apple failed 3 times: there is no apple in this room."
    ]
    assert memory(closing)["not here"] == "apple"
    assert made(closing, "plan") == ["left: get the apple\ndone: get the mug"]


@pytest.mark.parametrize("text", ["Heat the egg.", "Chill the egg.", "Put the egg in the bag."])
def test_examples_show_what_to_do_where_the_place_is_shut(text, played):
    backend = ScriptedBackend(["get the egg", "done"])
    played(HierarchicalPlanningAndExecution(backend), Instruction(text, text))
    fixed = backend.prompts[0].text[: backend.prompts[0].fixed]
    assert "(this action failed: the safe is closed), open the safe, put down the vase" in fixed
    assert fixed.count("shut away in the safe") == 1


def test_every_example_ends_each_sub_goal_where_its_steps_reach_it():
    for example in examples():
        tried = attempts(example)
        parts = list(stretches(example.task_type, tried))
        assert sum((part.attempts for part in parts), ()) == tried
        assert all(part.subgoal for part in parts)
        assert parts[0].subgoal.startswith("get the ")
    heat = next(e for e in examples() if e.instruction.startswith("Heat the cup"))
    assert [part.subgoal for part in stretches(heat.task_type, attempts(heat))] == [
        "get the cup",
        "heat the cup in the microwave",
        "put the cup on the coffee table",
    ]
