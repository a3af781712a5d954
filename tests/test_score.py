"""Scores count every episode begun, and their parts add up."""

from itertools import pairwise
from math import isnan

import pandas as pd
import pytest

from reibench.report import score_rows
from reibench.report.markdown import score_markdown
from reibench.report.text import score_report
from reibench.run import RunSpec, evaluate
from reibench.score import bootstrap, paired, sign_test, summarise, wilson
from reibench.tally import note_faults, records_frame
from reibench.worlds import worlds

DONE = RunSpec(model="scripted:done")
EXPERT = RunSpec(planner="expert")


@pytest.fixture
def scored(store, episodes, script):
    """Two runs over nine episodes: the expert, and a model that always says done at once."""
    chosen = [each for each in episodes.values() if each.task.id == "cool_apple"]
    list(evaluate(EXPERT, chosen, None, worlds.create("embedded"), store))
    backend = script(*[" done"] * 8, " juggle")
    list(evaluate(DONE, chosen, backend, worlds.create("embedded"), store))
    return store


def test_every_episode_counts_and_the_parts_add_up(scored):
    expert, done = score_rows(records_frame(scored))
    assert (expert["episodes"], expert["success"]) == (9, 9)
    assert (done["episodes"], done["success"]) == (9, 0)
    assert done["object_omission"] == 8
    assert done["breakdown"] == 1
    kinds = ("success", "object_omission", "execution_error", "breakdown")
    assert sum(done[kind] for kind in kinds) == done["episodes"]


def test_runs_are_compared_on_the_episodes_both_finished(scored):
    versus = paired(records_frame(scored), EXPERT.id, DONE.id)
    assert versus.episodes == versus.only_first == 9
    assert versus.p == pytest.approx(2 / 2**9)
    # nine levels of one task say nothing about other tasks
    assert (versus.tasks, versus.difference) == (1, -1.0)
    assert isnan(versus.low)


def test_levels_are_counted_apart(scored):
    levels = summarise(records_frame(scored), ["run", "level"])
    assert list(levels["episodes"]) == [1] * 18


def test_picking_the_object_but_missing_the_goal_is_an_execution_error(store, episodes, script):
    episode = episodes["cool_apple.mixed-short"]
    backend = script(" find an apple", " pick up the apple", " done")
    list(evaluate(DONE, [episode], backend, worlds.create("embedded"), store))
    [row] = score_rows(records_frame(store))
    assert (row["execution_error"], row["object_omission"]) == (1, 0)


def test_an_unlit_lamp_is_an_omitted_object(store, episodes, script):
    skills = (" find a credit card", " pick up the credit card", " done")
    backend = script(*skills)
    episode = episodes["light_card.mixed-short"]
    list(evaluate(DONE, [episode], backend, worlds.create("embedded"), store))
    [row] = score_rows(records_frame(store))
    assert (row["execution_error"], row["object_omission"]) == (0, 1)


def test_failures_judged_by_earlier_rules_are_judged_anew(store, episodes, script):
    skills = (" find a credit card", " pick up the credit card", " done")
    episode = episodes["light_card.mixed-short"]
    list(evaluate(DONE, [episode], script(*skills), worlds.create("embedded"), store))
    with store.writing() as database:
        database.execute("update records set error_kind = 'execution-error', fault = null")
    assert note_faults(store) == 1
    [row] = score_rows(records_frame(store))
    assert (row["execution_error"], row["object_omission"]) == (0, 1)
    assert note_faults(store) == 0


def test_underdetermined_episodes_are_shown_apart(scored):
    expert = score_rows(records_frame(scored))[0]
    assert (expert["episodes"], expert["determined_only"]["episodes"]) == (9, 8)
    assert "without 1 underdetermined: success   8 of 8" in score_report([expert])


def test_scores_make_a_markdown_table(scored):
    lines = score_markdown(score_rows(records_frame(scored))).splitlines()
    assert lines[0] == "| level | expert | saycan+none/scripted:done |"
    assert "| mixed-noised | 1/1 | 0/1 |" in lines
    assert "| **breakdown** | 0 of 9 0.0% [0.0%, 29.9%] | 1 of 9 11.1% [2.0%, 43.5%] |" in lines


def test_nothing_run_yet_is_said(store):
    assert score_report(score_rows(records_frame(store))) == "No episode has been run yet."


def test_wilson_intervals_are_the_textbook_ones():
    # Newcombe (1998), Table I: 81 of 263, 15 of 148, 0 of 20, 1 of 29.
    assert wilson(81, 263) == pytest.approx((0.2553, 0.3662), abs=1e-4)
    assert wilson(15, 148) == pytest.approx((0.0624, 0.1605), abs=1e-4)
    assert wilson(0, 20) == pytest.approx((0.0, 0.1611), abs=1e-4)
    assert wilson(1, 29) == pytest.approx((0.0061, 0.1718), abs=1e-4)


def test_wilson_intervals_shrink_with_more_trials():
    widths = [high - low for low, high in (wilson(n // 2, n) for n in (10, 100, 1000))]
    assert all(a > b for a, b in pairwise(widths))


def test_the_sign_test_is_exact():
    assert sign_test(13, 1) == pytest.approx(0.00183, abs=1e-5)
    assert sign_test(0, 0) == 1.0


def test_the_bootstrap_draws_whole_tasks():
    tasks = pd.Series([*"aaabbb"])
    # two tasks, one gained whole: a resample has none, one or two of it, 1 : 2 : 1
    assert bootstrap(pd.Series([1, 1, 1, 0, 0, 0]), tasks) == (0.0, 1.0)
    # gained alike in both tasks, nothing varies
    assert bootstrap(pd.Series([1, 0, 0, 1, 0, 0]), tasks) == pytest.approx((1 / 3, 1 / 3))


def test_the_bootstrap_agrees_with_theory_where_every_task_stands_once():
    gains = pd.Series([1] * 60 + [0] * 140 + [-1] * 20)
    low, high = bootstrap(gains, pd.Series(map(str, gains.index)))
    spread = 1.96 * gains.std(ddof=0) / len(gains) ** 0.5
    assert (low, high) == pytest.approx((gains.mean() - spread, gains.mean() + spread), abs=0.006)


def test_the_bootstrap_repeats_with_its_seed():
    gains, tasks = pd.Series([1, 0, -1, 1, 0] * 9), pd.Series([*"abcde"] * 9)
    assert bootstrap(gains, tasks) == bootstrap(gains, tasks)
