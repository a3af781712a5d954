"""Scores as JSON and CSV: counted by hand."""

import csv
import io
import sqlite3

import pytest

from reibench.__main__ import main
from tests.report.conftest import NONE, TOCC

pytestmark = pytest.mark.usefixtures("two_runs")


def test_both_readings_of_success_are_counted(score_json):
    none, tocc = score_json()
    assert (none["episodes"], none["success"], none["success_said_done"]) == (18, 9, 6)
    assert (tocc["episodes"], tocc["success"], tocc["success_said_done"]) == (18, 15, 9)


def test_the_finer_kinds_add_up_to_the_paper_s(score_json):
    none, _ = score_json()
    assert (none["object_omission"], none["execution_error"]) == (6, 3)
    counted = {kind: {f: n for f, n in all_.items() if n} for kind, all_ in none["faults"].items()}
    assert counted["object_omission"] == {"stopped-early": 3, "wrong-object": 3}
    assert counted["execution_error"] == {"stopped-early": 3}


def test_levels_come_in_the_paper_s_order_with_their_own_intervals(score_json):
    none, _ = score_json()
    assert [each["level"] for each in none["by_level"]][:4] == [
        "explicit-standard", "explicit-noised", "explicit-short", "mixed-standard",
    ]  # fmt: skip
    mixed = none["by_level"][3]
    assert (mixed["success"], mixed["episodes"]) == (1, 2)
    assert (mixed["success_low"], mixed["success_high"]) == pytest.approx(
        (0.0945, 0.9055), abs=1e-4
    )


def test_several_groupings_make_several_tables_and_commas_cross_columns(score_json):
    none, _ = score_json("--by", "reference,task", "--by", "context")
    crossed = {(g["reference"], g["task"]): g["success"] for g in none["by_reference,task"]}
    assert crossed[("mixed", "heat_potato")] == 0
    assert crossed[("mixed", "pick_keys")] == 3
    assert [group["success"] for group in none["by_context"]] == [3, 3, 3]


def test_columns_of_runs_pool_the_runs_that_share_them(score_json):
    [pooled] = score_json("--by", "planner")
    assert (pooled["planner"], pooled["episodes"], pooled["success"]) == ("saycan", 36, 24)
    assert pooled["runs"] == [NONE.id, TOCC.id]
    assert [row["method"] for row in score_json("--by", "method,level")] == ["none", "tocc"]


def test_runs_are_chosen_by_id_planner_method_and_model(score_json):
    assert [row["run"] for row in score_json("--runs", TOCC.id)] == [TOCC.id]
    assert [row["run"] for row in score_json("--method", "tocc", "--model", "toy")] == [TOCC.id]
    assert len(score_json("--planner", "saycan", "--model", "scripted:toy")) == 2


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--runs", "nobody"], "No run called 'nobody'"),
        (["--method", "toc"], "Did you mean 'tocc'?"),
        (["--by", "levle"], "Did you mean 'level'?"),
        (["--against", "papr"], "Did you mean 'paper'?"),
        (["--method", "none", "--runs", TOCC.id], "No run is all of what was chosen"),
    ],
)
def test_what_is_not_there_is_one_clear_sentence(store, capsys, arguments, said):
    assert main(["score", "--db", str(store.path), *arguments]) == 2
    printed = capsys.readouterr()
    assert said in printed.err
    assert (printed.out, len(printed.err.splitlines())) == ("", 1)


def test_runs_are_compared_pair_by_pair_in_both_readings(score_json):
    none, tocc = score_json()
    assert "paired" not in none
    shared = tocc["paired"]["success"]
    assert (shared["episodes"], shared["tasks"]) == (18, 2)
    assert (shared["both"], shared["only_first"], shared["only_second"]) == (9, 0, 6)
    assert shared["p"] == pytest.approx(2 / 2**6)
    # three of nine episodes are gained in each of the two tasks, so every resample gains a third
    assert [shared[each] for each in ("difference", "low", "high")] == pytest.approx(
        [1 / 3] * 3, abs=1e-6
    )
    strict = tocc["paired"]["success_said_done"]
    # here the keys' implicit levels are all that is gained: one task has a third, the other none
    assert strict["difference"] == pytest.approx(3 / 18, abs=1e-6)
    assert (strict["low"], strict["high"]) == pytest.approx((0, 1 / 3), abs=1e-6)


def test_the_run_others_are_compared_to_can_be_named(score_json):
    none, tocc = score_json("--against", TOCC.id)
    assert "paired" not in tocc
    assert none["paired"]["success"]["difference"] == pytest.approx(-1 / 3, abs=1e-6)


def test_costs_count_every_call_per_planning_step(score_json, solutions):
    none, tocc = score_json("--by", "task")
    steps = 3 * BUDGET_STEPS["none"](solutions)
    cost = none["cost"]
    assert cost["decisions"] == steps
    assert cost["input_tokens"] == pytest.approx(100)
    assert cost["evaluated_tokens"] == pytest.approx(10)
    assert cost["output_tokens"] == pytest.approx(5)
    assert cost["model_ms"] == pytest.approx(250)
    assert cost["dollars"] == pytest.approx(0.001 * steps)
    assert cost["method_input_tokens"] == 0
    # done is said in 15 of 18 episodes: all but the three in which heating takes every step
    assert cost["closing_input_tokens"] == pytest.approx(100 * 15 / 18)
    told = tocc["cost"]
    assert (told["method_input_tokens"], told["method_output_tokens"]) == (40, 8)
    assert told["method_evaluated_tokens"] == 30
    assert told["input_tokens"] == pytest.approx(100 + 40 * 18 / told["decisions"])
    assert told["model_ms"] == pytest.approx(250 + 500 * 18 / told["decisions"])


BUDGET_STEPS = {
    # explicit: heat, keys and done; mixed: done, keys and done; implicit: two steps and done, twice
    "none": lambda plans: len(plans["heat_potato"]) + 2 * (len(plans["pick_keys"]) + 1) + 7,
}


def test_csv_has_a_row_for_each_run_and_group(score):
    rows = list(csv.DictReader(io.StringIO(score("--csv", "--by", "reference"))))
    assert len(rows) == 2 * (1 + 3)
    whole = next(row for row in rows if row["method"] == "none" and not row["by"])
    assert (whole["episodes"], whole["success"], whole["success_said_done"]) == ("18", "9", "6")
    assert whole["object_omission_wrong_object"] == "3"
    assert (whole["input_tokens"], whole["planner"], whole["rules"]) == ("100", "saycan", "strict")
    mixed = next(
        r for r in rows if (r["method"], r["by"], r["group"]) == ("tocc", "reference", "mixed")
    )
    assert (mixed["episodes"], mixed["success_rate"]) == ("6", "1")


def test_faults_of_records_made_before_there_were_faults_are_found_and_kept(store, score_json):
    before = score_json()
    with store.writing() as database:
        database.execute("update records set fault = null")
    assert score_json() == before
    with sqlite3.connect(store.path) as database:
        [(kept,)] = database.execute("select count(*) from records where fault = 'wrong-object'")
    assert kept == 3


def test_an_unfinished_episode_is_told_apart_and_not_counted(store, episodes, score_json):
    store.begin(NONE, episodes["light_card.mixed-short"])
    none, _ = score_json()
    assert (none["episodes"], none["unfinished"], none["success"]) == (18, 1, 9)
