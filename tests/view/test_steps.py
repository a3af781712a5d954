"""Steps, budget, goals and verdict say what happened and why."""

from dataclasses import replace

from reibench.backends import Alternative
from reibench.view.actor_panel import model_panel, person_panel, record_of
from reibench.view.outcome import goal_conditions, person_verdict, since, verdict
from reibench.view.steps import announcement, budget, step_list


def test_a_refused_step_shows_its_reason_and_not_only_a_colour(episode, click, tags):
    rollout = click(episode, "find a potato", "put down the potato")
    markup = step_list(rollout.steps)
    tags(markup)
    assert rollout.steps[1].event.message[1:].rstrip(".") in markup
    assert "refused:" in markup
    assert 'href="#b-no"' in markup


def test_the_budget_says_how_much_is_used(tags):
    [bar] = [each for each in tags(budget(6, 30)) if each.get("role") == "progressbar"]
    assert (bar["aria-valuenow"], bar["aria-valuemax"]) == ("6", "30")
    assert "6 of 30" in budget(6, 30)


def test_a_screen_reader_hears_each_outcome(episode, click):
    [step] = click(episode, "open the safe").steps
    assert announcement(step).startswith("Step 1, open the safe: refused. ")


def test_a_goal_condition_tells_since_which_step_it_holds(episode, click, solution):
    rollout = click(episode, *solution)
    last = rollout.last_event
    assert last.solved
    numbers = [since(goal, rollout.steps) for goal in last.goals]
    assert all(numbers)
    assert max(numbers) == len(rollout.steps)
    assert f"step {len(rollout.steps)}" in goal_conditions(rollout.first_event, rollout.steps)


def test_a_solved_episode_is_said_to_be_carried_out(episode, click, solution, sitting):
    rollout = click(episode, *solution)
    rollout.finish()
    record = rollout.record("r", "person")
    assert verdict(record, budget=30).title == f"Succeeded in {len(solution)} of 30 steps"
    assert person_verdict("success", record, 30).tone == "good"
    markup = person_panel(sitting(rollout, over=True))
    assert "Done: the instruction is carried out." in markup
    assert 'data-over="true"' in markup


def test_taking_the_wrong_thing_is_named_as_such(episode, click):
    rollout = click(episode, "find an apple", "pick up the apple")
    rollout.finish()
    found = verdict(rollout.record("r", "person"), budget=30)
    assert found.title == "Failed: object omission"
    said = episode.dialogue.instruction.expressions
    meant = next(one.text for one in said if one.referent == "Potato")
    assert found.sentence == f"“{meant}” was taken for an apple at step 1; it means the potato."


def test_finding_everything_and_still_failing_names_what_never_came_true(episode, click, solution):
    picked = solution.index("pick up the potato") + 1
    rollout = click(episode, *solution[:picked])
    rollout.finish()
    found = verdict(rollout.record("r", "person"), budget=30)
    assert found.title == "Failed: execution error"
    assert "never came true" in found.sentence


def test_a_used_up_budget_is_said_in_a_sentence(episode, click):
    rollout = click(episode, "find an apple", max_steps=1)
    record = rollout.record("r", "person")
    assert record.status == "truncated"
    assert "none was ever picked up" in verdict(record, budget=1).sentence
    assert person_verdict("truncated", record, 1).title == "All 1 steps are used."


def test_a_stopped_run_is_no_failure(episode, click):
    record = click(episode, "find an apple").record("r", "saycan", error="stopped by the visitor")
    found = verdict(record, budget=30)
    assert (found.title, found.tone) == ("Stopped after 1 steps", "plain")


def test_a_model_s_step_tells_how_sure_it_was(episode, click):
    [step] = click(episode, "find an apple").steps
    options = (Alternative(" find an apple", 0.62), Alternative(" find a potato", 0.3))
    unsure = replace(step, decision=replace(step.decision, alternatives=options))
    markup = step_list([unsure])
    assert "62 % sure · find a potato 30 %" in markup


def test_while_a_model_acts_one_can_stop_it_and_afterwards_compare(episode, click, sitting):
    running = replace(sitting(click(episode, "find an apple")), phase="planning")
    markup = model_panel("SayCan", "gemma", running, ready=True)
    assert 'data-do="stop"' in markup
    assert "thinking about the next step" in markup
    rollout = click(episode, "find an apple")
    rollout.finish()
    over = model_panel("SayCan", "gemma", sitting(rollout, over=True), ready=True)
    assert 'data-do="compare"' in over
    assert "object omission" in over


def test_a_sitting_makes_the_record_its_verdict_is_read_from(episode, click, sitting):
    rollout = click(episode, "find an apple")
    record = record_of(sitting(rollout))
    assert record.steps == tuple(rollout.steps)
    assert record.start == rollout.first_event
