"""What an analysis says, against numbers computed by hand and people whose skill is known."""

from dataclasses import replace
from math import isclose
from statistics import median

import pandas as pd
import pytest

from reibench.errors import ReibenchError
from reibench.run import RunSpec, evaluate
from reibench.worlds.embedded import embedded_world
from study.__main__ import main
from study.analysis import agreement, analyse, draw, mixed_model, trials_frame, versus
from study.config import from_json
from study.exporting import tables_of
from study.simulating import Character, Simulation
from study.telling import lines


def frame(rows):
    columns = ["participant", "episode_digest", "task", "status"]
    return pd.DataFrame(rows, columns=columns)


PEOPLE = frame(
    [
        ("A", "e1", "t1", "success"),
        ("A", "e2", "t2", "success"),
        ("B", "e1", "t1", "failure"),
        ("B", "e3", "t3", "success"),
        ("C", "e1", "t1", "success"),
        ("C", "e9", "t9", "success"),
    ]
)
RUN = pd.DataFrame(
    [("r", "planner", "e1", "t1", "success"), ("r", "planner", "e2", "t2", "failure"),
     ("r", "planner", "e3", "t3", "truncated"), ("r", "planner", "e4", "t4", "success")],
    columns=["run", "actor", "episode_digest", "task", "status"],
)  # fmt: skip


def test_people_and_a_planner_are_compared_on_the_same_episodes_as_by_hand():
    found = versus(PEOPLE, RUN, "r")
    assert (found.trials, found.episodes, found.tasks) == (5, 3, 3)
    assert found.person == 4 / 5
    assert found.other == 3 / 5  # e1 three times, as often as people played it
    assert (found.only_person, found.only_other) == (2, 1)
    assert found.p == 1.0
    assert isclose(found.difference, 0.2)
    assert found.low < 0.2 < found.high


def test_agreement_counts_pairs_on_one_episode():
    assert agreement(PEOPLE) == {"pairs": 3, "same": 1, "share": 1 / 3}


def test_a_model_is_not_made_of_nothing():
    assert "note" in mixed_model(PEOPLE.iloc[:1], RUN, "r")


@pytest.fixture(scope="module")
def studied(tmp_path_factory, example):
    from reibench.store import Store
    from study.enrolment import Enrolment

    enrolment = Enrolment(Store(tmp_path_factory.mktemp("analysis") / "study.db"))
    study = replace(example, trials=6, tasks=6, practice=(), people=0)
    enrolment.create(study)
    character = Character(skill=0.7, quiz=1.0, hesitation=0.1, reload=0.0)
    Simulation(enrolment, study.name, character, 3).run(9, together=3, tell=lambda line: None)
    spec = RunSpec(planner="expert").versioned()
    list(evaluate(spec, study.chosen()[:27], None, embedded_world(), enrolment.store))
    return enrolment, study


def test_it_recovers_the_skill_of_simulated_people_within_its_interval(studied):
    enrolment, study = studied
    found = analyse(enrolment, study.name, everybody=True)
    [overall] = found["overall"]
    assert (found["people"], found["trials"]) == (9, 54)
    assert overall["success_low"] <= 0.7 <= overall["success_high"]
    assert sum(row["episodes"] for row in found["by_level"]) == 54
    assert found["steps_per_expert_step"]["median"] < 1.3


def test_what_people_took_the_words_to_mean_is_counted_as_by_hand(studied):
    enrolment, study = studied
    meant = {episode.id: episode.task.goal.object for episode in study.chosen()}
    rows = enrolment.store.query(
        "select answer, episode, level from answers as w join assignments as a"
        " on a.participant = w.participant and a.place = w.place and a.kind = 'trial'"
        " where w.question = 'meant'"
    )
    found = analyse(enrolment, study.name, everybody=True)["meant"]
    assert [one["reference"] for one in found] == ["explicit", "mixed", "implicit"]
    for one in found:
        here = [row for row in rows if row["level"].startswith(one["reference"])]
        assert one["asked"] == len(here)
        assert one["right"] == sum(row["answer"] == meant[row["episode"]] for row in here)
        assert one["low"] <= one["right"] / one["asked"] <= one["high"]


def test_an_export_is_enough_to_count_it_again(studied):
    enrolment, study = studied
    found = analyse(enrolment, study.name, everybody=True)
    tables = tables_of(enrolment, study.name, everybody=True)
    trials = {(row["participant"], row["place"]): row for row in tables["trials"]}
    assert (
        sum(row["status"] == "success" for row in trials.values()) == found["overall"][0]["success"]
    )
    named = [row for row in tables["answers"] if row["question"] == "meant"]
    right = [row["answer"] == trials[row["participant"], row["place"]]["object"] for row in named]
    assert sum(right) == sum(one["right"] for one in found["meant"])
    [version] = tables["versions"]
    assert {row["version"] for row in tables["participants"]} == {version["version"]}
    assert from_json(version["definition"]) == study


def test_it_says_who_is_counted(studied):
    enrolment, study = studied
    found = analyse(enrolment, study.name, everybody=True)
    assert sum(n for state, n in found["states"].items() if state != "missed a check") == 9
    assert "finished" in lines(found)[0]


def test_a_step_takes_as_long_as_its_clicks_did(studied):
    enrolment, study = studied
    rows = enrolment.store.query(
        "select avg(seconds) as mean from steps as s join assignments as a on a.record = s.record"
        " where kind = 'trial' group by s.record"
    )
    found = analyse(enrolment, study.name, everybody=True)["seconds_a_step"]
    assert found["number"] == len(rows)
    assert isclose(found["median"], median(row["mean"] for row in rows), abs_tol=1e-6)


def test_people_are_counted_beside_every_run_of_the_database(studied):
    enrolment, study = studied
    found = analyse(enrolment, study.name, everybody=True)
    [against] = found["versus"]
    assert against["other"] == 1.0
    assert against["only_person"] == 0
    assert against["difference"] <= 0
    [fit] = found["model"]
    assert fit["person_log_odds"] < 0
    told = "\n".join(lines(found))
    assert "people against expert" in told
    assert "named the object that was meant:" in told
    assert "log odds of a person -" in told


def test_people_are_drawn_a_bar_a_level(studied, tmp_path):
    enrolment, study = studied
    files = draw(enrolment, study.name, tmp_path, everybody=True)
    assert {file.suffix for file in files} == {".svg", ".png", ".pdf"}
    svg = (tmp_path / "people-by-level.svg").read_text()
    for level in study.chosen()[:9]:
        reference, context = level.vagueness
        assert f"people {reference}-{context} solved" in svg


def test_simulated_people_are_left_out_unless_asked_for(studied, capsys):
    enrolment, study = studied
    with pytest.raises(ReibenchError, match="--everybody"):
        trials_frame(enrolment, study.name)
    db = ["--db", str(enrolment.store.path)]
    assert main(["analysis", study.name, *db]) == 2
    assert main(["analysis", study.name, "--everybody", "--json", *db]) == 0
    assert '"trials": 54' in capsys.readouterr().out
    assert main(["analysis", study.name, "--everybody", "--runs", "none", *db]) == 2
