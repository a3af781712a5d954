"""SayCan: one choice among the skills per step, with what failed in the prompt."""

import pytest

from reibench.backends.scripted import ScriptedBackend
from reibench.methods import Instruction
from reibench.planners.saycan import SayCan
from reibench.scene import Pose, Scene, Vector
from reibench.skill import SKILLS
from reibench.worlds import Event

EMPTY = Scene("nowhere", (), Pose(Vector(0, 0, 0), 0))
WORKED = Event(True, "", EMPTY, ())
ASKED = Instruction("Bring me the apple.", "Bring me the fruit.")


def test_it_yields_what_the_model_chooses_until_done():
    backend = ScriptedBackend(["find an apple", "pick up the apple", "done"])
    plan = SayCan(backend).plan(ASKED, WORKED, SKILLS)
    chosen = [next(plan).skill.text, plan.send(WORKED).skill.text]
    with pytest.raises(StopIteration):
        plan.send(WORKED)
    assert chosen == ["find an apple", "pick up the apple"]
    assert backend.prompts[-1].text.endswith("Robot: find an apple, pick up the apple,")


def test_the_next_prompt_carries_the_reason_of_a_failure():
    backend = ScriptedBackend(["pick up the apple", "done"])
    plan = SayCan(backend).plan(ASKED, WORKED, SKILLS)
    next(plan)
    refused = Event(False, "the apple is in the fridge, which is closed", EMPTY, ())
    with pytest.raises(StopIteration):
        plan.send(refused)
    assert backend.prompts[1].text.endswith(
        "pick up the apple (this action failed: the apple is in the fridge, which is closed),"
    )


def test_the_planner_is_told_the_instruction_and_its_context():
    backend = ScriptedBackend(["find an apple"])
    asked = Instruction("Bring it.", "Bring it.", context=("An apple a day.", "Mr. Pan agrees."))
    decision = next(SayCan(backend).plan(asked, WORKED, SKILLS))
    assert decision.prompt.endswith(
        "Human previous inquiry (not required to execute): An apple a day.\n"
        "Human previous inquiry (not required to execute): Mr. Pan agrees.\n"
        "Human pending instruction: Bring it.\nRobot:"
    )


def test_examples_are_the_fixed_part_of_the_prompt_and_the_same_within_a_task_type():
    backend = ScriptedBackend(["find an apple"] * 3)
    for text in ("Wash the apple.", "Rinse the egg.", "Heat the egg."):
        next(SayCan(backend).plan(Instruction(text, text), WORKED, SKILLS))
    fixed = [prompt.text[: prompt.fixed] for prompt in backend.prompts]
    assert fixed[0] == fixed[1] != fixed[2]
    assert "turn on the faucet" in fixed[0]
    assert "turn on the microwave" in fixed[2]


def test_the_fixed_set_shows_every_task_type_whatever_is_asked():
    backend = ScriptedBackend(["find an apple"])
    next(SayCan(backend, examples="fixed").plan(ASKED, WORKED, SKILLS))
    shown = backend.prompts[0].text[: backend.prompts[0].fixed]
    assert shown.count("Robot:") == 12


def test_it_chooses_among_the_skills_it_is_given_and_done():
    backend = ScriptedBackend(["find a zebra"])
    with pytest.raises(Exception, match="none of the 214 options"):
        next(SayCan(backend).plan(ASKED, WORKED, SKILLS))
