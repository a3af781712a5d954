"""The engine treats people and planners alike."""

from dataclasses import replace

import pytest

from reibench.errors import StaleStep
from reibench.methods import Instruction
from reibench.planners import Decision
from reibench.planners.saycan import SayCan
from reibench.rollout import Rollout, drive
from reibench.run import RunSpec, evaluate
from reibench.skill import parse_skill
from reibench.worlds import worlds

TOLD = Instruction(text="Heat the potato.", original="Heat that thing.")


def answers(*skills):
    return [*(f" {text}" for text in skills), " done"]


def test_a_person_and_a_planner_leave_the_same_record(episode, click, script, solution):
    by_hand = click(episode, *solution)
    by_hand.finish()

    by_model = Rollout(episode, worlds.create("embedded"))
    by_model.start()
    list(drive(by_model, SayCan(script(*answers(*solution))), TOLD))

    human, model = by_hand.record("a", "person"), by_model.record("b", "saycan")
    assert human.status == model.status == "success"
    assert human.said_done
    assert model.said_done
    assert [s.decision.skill for s in human.steps] == [s.decision.skill for s in model.steps]
    assert [s.event for s in human.steps] == [s.event for s in model.steps]


def test_running_out_of_steps_is_truncation_and_costs_no_further_call(episode, script, store):
    backend = script(*answers("find an apple", "find an apple"))
    spec = RunSpec(model="scripted:x", max_steps=1)
    [record] = evaluate(spec, [episode], backend, worlds.create("embedded"), store)
    assert record.status == "truncated"
    assert len(backend.prompts) == 1


def test_reaching_the_goal_counts_even_if_the_budget_ends_there(episode, click, solution):
    rollout = click(episode, *solution, max_steps=len(solution))
    assert rollout.exhausted
    assert rollout.status == "success"


def test_an_episode_that_breaks_still_counts(episode, script, store, solution):
    second = replace(episode, task=replace(episode.task, id="second"))
    backend = script(" find an apple", " fly to the moon", *answers(*solution))
    spec = RunSpec(model="scripted:x")
    broken, solved = evaluate(spec, [episode, second], backend, worlds.create("embedded"), store)
    assert (broken.status, len(broken.steps)) == ("error", 1)
    assert "fly to the moon" in broken.error
    assert solved.status == "success"


def test_an_episode_whose_room_cannot_be_set_up_still_counts(episode, script, store):
    lost = replace(episode, task=replace(episode.task, id="lost"))
    lost = replace(lost, task=replace(lost.task, setup=replace(lost.task.setup, room="attic-9")))
    spec = RunSpec(model="scripted:x")
    [record] = evaluate(spec, [lost], script(" done"), worlds.create("embedded"), store)
    assert record.status == "error"
    assert "attic-9" in record.error
    assert record.start is None


def test_a_stale_or_doubled_click_is_refused_and_changes_nothing(episode, click):
    rollout = click(episode, "find a potato")
    skill = Decision(parse_skill("pick up the potato"))
    with pytest.raises(StaleStep, match="at step 2, but step 1 was asked for"):
        rollout.step(skill, expected=1)
    rollout.step(skill, expected=2)
    with pytest.raises(StaleStep):
        rollout.step(skill, expected=2)
    assert len(rollout.steps) == 2


def test_nothing_follows_done(episode, click):
    rollout = click(episode, "find a potato")
    rollout.finish()
    with pytest.raises(StaleStep, match="over after 1 steps"):
        rollout.step(Decision(parse_skill("find a potato")))
