"""The teacher: does tasks by what it is told, and looks at nothing."""

from dataclasses import replace
from itertools import islice

import pytest

from reibench.dataset.realise.tasks import tasks
from reibench.dialogue import EXPLICIT_ALONE, Dialogue, Utterance
from reibench.episode import Episode, Goal, TaskType
from reibench.household import load_room, room_names
from reibench.household.plans import PLANS
from reibench.rollout import Rollout
from reibench.skill import SLICEABLE, in_words
from reibench.tuning.grounds import FIRST, made_up
from reibench.tuning.teacher import Teacher, Wish
from reibench.worlds.embedded import embedded_world
from reibench.worlds.rules import RULES

UNSAID = Dialogue((Utterance("human", ""),))


class Unseen:
    """A scene that nobody may look at."""

    def __getattr__(self, name):
        raise AssertionError(f"somebody looked at the scene's {name}")


@pytest.fixture(scope="module")
def rooms():
    with made_up(4) as made:
        yield made


def carry_out(task, wish, rules="strict"):
    """Let the teacher act on events without a scene; return the rollout."""
    rollout = Rollout(Episode(task, UNSAID, EXPLICIT_ALONE), embedded_world(RULES[rules]))
    start = rollout.start()
    plan = Teacher(wish).plan(None, replace(start, scene=Unseen()), ())
    decision = next(plan, None)
    while decision is not None and not rollout.over:
        event = rollout.step(decision).event
        try:
            decision = plan.send(replace(event, scene=Unseen()))
        except StopIteration:
            decision = None
    return rollout


@pytest.mark.parametrize("rules", RULES)
def test_it_solves_almost_every_task_without_a_look_at_the_room(rooms, rules):
    found = [seed.task for seed in islice(tasks(rooms, 3, lambda task: True), 120)]
    solved = [carry_out(task, Wish(task.goal), rules).status == "success" for task in found]
    assert sum(solved) >= 0.9 * len(solved)


def test_it_opens_what_the_message_says_the_thing_is_shut_in(rooms):
    done = [
        [str(step.decision.skill) for step in rollout.steps]
        for task in (seed.task for seed in islice(tasks(rooms, 4, lambda task: True), 150))
        for rollout in [carry_out(task, Wish(task.goal))]
        if any("which is closed" in step.event.message for step in rollout.steps)
    ]
    assert done
    assert all(any(skill.startswith("open the") for skill in skills) for skills in done)


def test_it_cuts_what_is_wanted_in_slices(rooms):
    for seed in islice(tasks(rooms, 5, lambda task: True), 400):
        goal = seed.task.goal
        if goal.object in SLICEABLE and {"Knife", "ButterKnife"} & set(seed.present):
            sliced = replace(seed.task, goal=replace(goal, sliced=True))
            rollout = carry_out(sliced, Wish(sliced.goal))
            skills = [str(step.decision.skill) for step in rollout.steps]
            assert f"slice the {in_words(goal.object)}" in skills
            assert rollout.status == "success"
            return
    pytest.fail("nothing can be cut in these rooms")


def test_a_word_of_several_meanings_is_tried_in_their_order(rooms):
    for seed in islice(tasks(rooms, 6, lambda task: True), 200):
        goal = seed.task.goal
        if goal.task_type is TaskType.EXAMINE and "DeskLamp" not in seed.present:
            meant = {goal.destination: ("DeskLamp", "FloorLamp")}
            rollout = carry_out(seed.task, Wish(goal, meant))
            skills = [str(step.decision.skill) for step in rollout.steps]
            assert skills.index("find a desk lamp") < skills.index("find a floor lamp")
            assert rollout.status == "success"
            return
    pytest.fail("each of these rooms has a desk lamp")


def test_what_is_not_there_ends_it():
    kitchen = [load_room("kitchen-1")]
    [seed] = islice(tasks(kitchen, 1, lambda task: True), 1)
    rollout = carry_out(seed.task, Wish(Goal(TaskType.PICK, "BasketBall", "Fridge")))
    assert [str(step.decision.skill) for step in rollout.steps] == ["find a basket ball"]


def test_the_rooms_are_none_of_the_shipped_ones_and_always_the_same(rooms):
    assert all(plan.seed < FIRST for plan in PLANS.values())
    assert not {room.name for room in rooms} & set(room_names())
    with made_up(1) as again:
        kept = {room.kind: room.objects for room in rooms[::4]}
        assert {room.kind: room.objects for room in again} == kept
