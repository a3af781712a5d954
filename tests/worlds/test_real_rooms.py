"""Real rooms are playable: what is there is found, and nothing done in any order breaks them."""

from random import Random

import pytest

from reibench.episode import Goal, SceneSetup, Task, TaskType
from reibench.skill import SKILLS, Verb
from reibench.worlds import worlds
from reibench.worlds.rules import RULES, rules_called

GOAL = Goal(TaskType.PICK, "Potato", "CounterTop")


def enter(room, rules):
    world = worlds.create("embedded", rules=rules_called(rules))
    scene = world.reset(Task("visit", SceneSetup(room, seed=1), GOAL)).scene
    types = {thing.type for thing in scene.objects}
    return world, [skill for skill in SKILLS if skill.object in types]


@pytest.mark.parametrize("rules", RULES)
def test_everything_in_a_real_room_can_be_found(rules, real_rooms):
    found = 0
    for room in real_rooms:
        world, skills = enter(room, rules)
        for skill in skills:
            if skill.verb is Verb.FIND:
                event = world.step(skill)
                assert event.success, (room, skill.text, event.message)
                found += 1
    assert found > 2000


@pytest.mark.parametrize("rules", RULES)
def test_any_skills_in_any_order_leave_a_real_room_possible(rules, real_rooms):
    done = 0
    for room in real_rooms:
        world, skills = enter(room, rules)
        random = Random(room)
        finds = [skill for skill in skills if skill.verb is Verb.FIND]
        for _ in range(20):
            gone_to = random.choice(finds)
            about = [skill for skill in skills if skill.object == gone_to.object]
            for skill in (gone_to, random.choice(about), *random.choices(skills, k=2)):
                event = world.step(skill)
                done += event.success
                assert_possible(room, event.scene)
    assert done > 3000


def assert_possible(room, scene):
    assert sum(thing.held for thing in scene.objects) <= 1
    for thing in scene.objects:
        if thing.held:
            assert not thing.parents, (room, thing.id)
        for parent in thing.parents:
            assert scene.by_id[parent].contents.count(thing.id) == 1, (room, thing.id)
        for name in thing.contents or ():
            assert thing.id in scene.by_id[name].parents, (room, thing.id)
    for name in scene.visible:
        thing = scene.by_id[name]
        assert not thing.pickupable or not scene.closed_around(thing), (room, name)
