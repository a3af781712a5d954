"""The solved examples, and the keyword rule that finds the nearest."""

from collections import Counter

import pytest

from reibench.episode import TaskType
from reibench.planners.examples import examples, fixed_set, nearest, nearest_type
from reibench.skill import parse_skill


def test_there_are_three_examples_of_every_task_type_and_two_in_the_fixed_set():
    assert set(Counter(one.task_type for one in examples()).values()) == {3}
    assert Counter(one.task_type for one in fixed_set()) == dict.fromkeys(TaskType, 2)


@pytest.mark.parametrize("example", examples(), ids=lambda example: example.instruction)
def test_an_example_consists_of_skills_and_is_found_by_the_rule(example):
    for step in example.plan.split(", "):
        if "(" not in step and not step.endswith(")"):
            parse_skill(step)
    assert nearest_type(example.instruction) is example.task_type


@pytest.mark.parametrize(
    ("instruction", "task_type"),
    [
        ("Drop the CD into the safe.", TaskType.PICK),
        ("Put the ladle in the pot and take the pot to the sink.", TaskType.STACK),
        ("Scrub the pot and stand it on the shelf.", TaskType.CLEAN),
        ("I want a warmed plate on the cart.", TaskType.HEAT),
        ("A chilled bottle of wine on the desk, please.", TaskType.COOL),
        ("Hold the watch under the lamp and turn it on.", TaskType.EXAMINE),
        ("Put the hotel key on the coldest shelf.", TaskType.PICK),
    ],
)
def test_verb_cues_give_the_task_type_away(instruction, task_type):
    assert nearest_type(instruction) is task_type
    assert {example.task_type for example in nearest(instruction)} == {task_type}
