"""Power: what the analysis would find, before there is anybody."""

from dataclasses import replace

import pytest

from reibench.errors import ReibenchError
from reibench.rollout import Rollout
from reibench.run import RunSpec, evaluate
from reibench.store import Store
from reibench.worlds.embedded import embedded_world
from study.__main__ import main
from study.power import Expected, by_reference, outcomes_of, power
from study.reading import read_study
from tests.study.conftest import EXAMPLE


def expected(person, planner):
    return Expected(by_reference(person, "person"), {**by_reference(planner, "planner")})


@pytest.fixture(scope="module")
def small(example):
    return replace(example, tasks=9, trials=3, people=0)


def test_more_people_and_larger_differences_are_found_more_often(small):
    weak, strong = power(small, expected("0.8", "0.6"), [3, 24], simulations=40)
    assert weak.mcnemar < strong.mcnemar
    [clear] = power(small, expected("0.98", "0.2"), [9], simulations=20)
    assert clear.mcnemar == 1.0
    assert 0.6 < clear.difference < 0.9


def test_where_there_is_no_difference_it_is_hardly_ever_found(small):
    same = replace(expected("0.7", "0.7"), between_people=0.0, between_tasks=0.0)
    [none] = power(small, same, [9], simulations=80)
    assert none.mcnemar <= 0.12
    assert abs(none.difference) < 0.06


def test_a_run_s_own_outcomes_stand_for_the_planner(small):
    outcomes = {episode.id: False for episode in small.chosen()}
    known = replace(expected("0.9", "0.9"), planner={**by_reference("0.9", ""), **outcomes})
    [found] = power(small, known, [6], simulations=10)
    assert found.difference > 0.7


def test_a_run_is_what_the_command_line_recorded_not_what_a_visitor_watched(tmp_path, capsys):
    store = Store(tmp_path / "runs.db")
    spec = RunSpec(planner="expert").versioned()
    episode = read_study(EXAMPLE).chosen()[0]
    list(evaluate(spec, [episode], None, embedded_world(), store))
    watched = Rollout(episode, embedded_world())
    watched.start()
    started = store.begin(spec, episode, origin="demo", visitor="v", start=watched.first_event)
    store.finish(started, watched, "expert", error="The visitor left before it was over.")
    assert outcomes_of(store, spec.id) == {episode.id: True}


@pytest.mark.parametrize("text", ["2", "x", "explicit=0.5", "explicit=0.5,odd=0.2", ""])
def test_shares_that_are_none_are_refused(text):
    with pytest.raises(ReibenchError):
        by_reference(text, "--person")


def test_the_command_line_prints_a_table_and_draws_the_curve(tmp_path, capsys):
    curve = tmp_path / "power.png"
    asked = ["power", str(EXAMPLE), "--people", "2,4", "--simulations", "5", "--figure", str(curve)]
    assert main(asked) == 0
    assert "power (McNemar)" in capsys.readouterr().out
    assert curve.stat().st_size > 5000
    assert main(["power", str(EXAMPLE), "--people", "many"]) == 2
