"""PDDL problems: what is said of a room, and what skills bring about."""

import pytest

from reibench.planners.goal_examples import goal_examples
from reibench.planners.pddl import Action
from reibench.planners.pddl_goals import PREDICATES, Fact, grammar, in_pddl
from reibench.planners.pddl_problem import brought_about, problem, skill_of, symbol, vocabulary
from reibench.skill import FINDABLE, parse_skill


def brings(*skills: str) -> str:
    return in_pddl(brought_about(parse_skill(skill) for skill in skills))


def test_every_type_has_a_name_of_its_own_that_leads_back_to_its_skill():
    names = [symbol(name) for name in FINDABLE]
    assert len(set(names)) == len(FINDABLE)
    for name in FINDABLE:
        assert skill_of(Action("find", (symbol(name),))).object == name


def test_the_problem_names_what_is_in_the_room_and_what_is_shut_in(world, episodes):
    scene = world.reset(episodes["heat_potato.mixed-noised"].task).scene
    stated = problem(scene, (), [Fact("hot", ("egg",))])
    assert "(shut-in egg fridge)" in stated
    assert "(shut-in potato" not in stated
    assert "(several fridge)" not in stated
    assert "(fits potato microwave)" in stated
    assert "sofa" not in stated


def test_what_no_device_of_the_room_can_do_is_no_condition_there(world, episodes):
    words = vocabulary(world.reset(episodes["pick_keys.mixed-noised"].task).scene)
    assert words.predicates == ["in", "lit", "holding"]
    assert '"(hot ' not in grammar(words)
    assert "sink" not in words.names


@pytest.mark.parametrize(
    ("skills", "goal"),
    [
        (("find an egg", "pick up the egg", "find a sink", "put down the egg"), "(in egg sink)"),
        (
            ("find an egg", "pick up the egg", "find a sink", "put down the egg",
             "turn on the faucet", "turn off the faucet", "pick up the egg"),
            "(clean egg)",
        ),
        (("find a book", "pick up the book", "find a desk lamp", "turn on the desk lamp"),
         "(lit book desk-lamp)"),
        (("find a desk lamp", "turn on the desk lamp"), ""),
    ],
)  # fmt: skip
def test_skills_bring_about_what_the_domain_says(skills, goal):
    assert brings(*skills) == f"(:goal (and {goal}))"


def test_a_slice_is_a_new_thing_that_was_not_treated():
    cut = ("find an apple", "pick up the apple", "find a fridge", "open the fridge",
           "put down the apple", "close the fridge", "open the fridge")  # fmt: skip
    assert "(cold apple)" in brings(*cut)
    assert "(cold apple)" not in brings(*cut, "slice the apple")


def test_the_examples_ask_for_what_their_plans_do():
    goals = dict(goal_examples())
    rinsed = goals["Rinse the spatula and lay it on the side table."]
    assert in_pddl(rinsed) == "(:goal (and (clean spatula) (in spatula side-table)))"
    assert {fact.predicate for goal in goals.values() for fact in goal} >= set(PREDICATES) - {
        "holding"
    }
