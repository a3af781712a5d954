"""What can be chosen, and what is offered first."""

import json

from reibench.skill import SKILLS, Verb, parse_skill
from reibench.view.likely import MOST, last_found, likely
from reibench.view.picker import picker


def test_the_picker_carries_every_skill_in_the_planners_order(tags):
    [box] = [each for each in tags(picker(SKILLS)) if each.get("class") == "pick"]
    sent = json.loads(box["data-skills"])
    assert [text for _, _, text in sent] == [skill.text for skill in SKILLS]


def test_each_verb_has_a_chip_with_its_count(tags):
    chips = [each for each in tags(picker(SKILLS), "button") if each.get("data-verb")]
    assert [chip["data-verb"] for chip in chips] == [str(verb) for verb in Verb]
    assert "find<i>80</i>" in picker(SKILLS)


def test_what_is_held_comes_first(episode, click, solution):
    picked = solution.index("pick up the potato") + 1
    rollout = click(episode, *solution[:picked])
    first = likely(rollout.last_event.scene, rollout.steps)[0]
    assert first.text == "put down the potato"


def test_a_closed_door_is_to_be_opened_and_an_open_one_closed(episode, click):
    rollout = click(episode, "find a fridge")
    offered = [each.text for each in likely(rollout.last_event.scene, rollout.steps)]
    assert "open the fridge" in offered
    rollout = click(episode, "find a fridge", "open the fridge")
    offered = [each.text for each in likely(rollout.last_event.scene, rollout.steps)]
    assert "close the fridge" in offered
    assert "open the fridge" not in offered


def test_nothing_out_of_reach_is_likely(episode, click):
    rollout = click(episode, "find a fridge")
    scene = rollout.last_event.scene
    kinds = {scene.by_id[key].type for key in scene.visible}
    offered = likely(scene, rollout.steps)
    assert len(offered) <= MOST
    assert {skill.object for skill in offered} <= kinds


def test_the_robot_is_near_what_it_found_last(episode, click):
    rollout = click(episode, "find a fridge", "find a safe", "open the fridge")
    assert last_found(rollout.steps) == "Fridge"
    assert last_found(()) == ""
    assert parse_skill("find a fridge") in SKILLS
