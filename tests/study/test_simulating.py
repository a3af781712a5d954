"""Simulated people, and what they leave behind."""

import csv
import json
from collections import Counter
from dataclasses import replace

import pytest

from study.__main__ import main
from study.exporting import CODEBOOK, export, tables_of
from study.simulating import Character, Simulation
from study.status import status_of


@pytest.fixture
def played(enrolment, short):
    """A study that six simulated people took part in, half of whose trials are done right."""
    enrolment.create(short)
    character = Character(skill=0.5, quiz=1.0, reload=0.2)
    Simulation(enrolment, short.name, character, 1).run(6, together=3, tell=lambda line: None)
    return enrolment


def test_everyone_finishes_is_marked_and_takes_no_real_person_s_place(played, short):
    rows = played.store.query("select * from participants")
    assert Counter(row["state"] for row in rows) == {"finished": 6}
    assert all(row["simulated"] for row in rows)
    assert sum(status_of(played, short.name)["cells"].values()) == 0
    assert sum(status_of(played, short.name, simulated=True)["cells"].values()) == 12
    assert played.arrive(short.name, {}).slot == 0


def test_some_trials_succeed_and_some_do_not(played, short):
    trials = tables_of(played, short.name, everybody=True)["trials"]
    assert 0 < sum(row["status"] == "success" for row in trials) < len(trials) == 12


def test_the_same_seed_gives_the_same_people(enrolment, short):
    enrolment.create(short)
    done = []
    for name in ("one", "two"):
        enrolment.create(replace(short, name=name, seed=3))
        simulation = Simulation(enrolment, name, Character(quiz=1.0), 5)
        simulation.run(2, together=1, tell=lambda line: None)
        trials = tables_of(enrolment, name, everybody=True)["trials"]
        done.append(Counter((row["task"], row["level"]) for row in trials))
    assert done[0] == done[1]


def test_leavers_are_gone_but_counted(enrolment, short):
    enrolment.create(short)
    simulation = Simulation(enrolment, short.name, Character(leave=1.0, quiz=1.0), 1)
    outcomes = simulation.run(3, together=3, tell=lambda line: None)
    assert [outcome.state for outcome in outcomes] == ["withdrawn"] * 3
    assert not enrolment.store.query("select * from records")


def test_an_export_leaves_simulated_people_out_unless_asked(played, short, tmp_path):
    export(played, short.name, tmp_path / "real")
    assert (tmp_path / "real" / "trials.jsonl").read_text() == ""
    export(played, short.name, tmp_path / "all", everybody=True)
    lines = (tmp_path / "all" / "trials.jsonl").read_text().splitlines()
    assert len(lines) == 12


def test_each_table_has_the_columns_of_the_codebook_in_csv_and_jsonl(played, short, tmp_path):
    export(played, short.name, tmp_path, everybody=True)
    book = (tmp_path / "codebook.md").read_text()
    for table, columns in CODEBOOK.items():
        with (tmp_path / f"{table}.csv").open(newline="") as file:
            rows = list(csv.DictReader(file))
        assert rows
        assert list(rows[0]) == list(columns)
        first = json.loads((tmp_path / f"{table}.jsonl").read_text().splitlines()[0])
        assert list(first) == list(columns)
        assert all(f"| `{name}` |" in book for name in columns)


def test_a_cell_that_looks_like_a_formula_is_kept_from_being_one(played, short, tmp_path):
    [code] = [played.store.query("select code from participants limit 1")[0]["code"]]
    with played.store.writing() as database:
        database.execute(
            "update answers set answer = '=1+1' where question = 'remarks' and participant = ?",
            [code],
        )
    export(played, short.name, tmp_path, everybody=True)
    assert "'=1+1" in (tmp_path / "answers.csv").read_text()
    assert '"=1+1"' in (tmp_path / "answers.jsonl").read_text()


def test_the_command_line_simulates_and_exports(tmp_path, capsys, short, enrolment):
    enrolment.create(short)
    db = ["--db", str(enrolment.store.path)]
    assert main(["simulate", short.name, "--n", "2", *db]) == 0
    assert "finished" in capsys.readouterr().out
    assert main(["simulate", short.name, "--skill", "8", *db]) == 2
    assert main(["simulate", "nothing", *db]) == 2
    assert main(["export", short.name, "--out", str(tmp_path / "x"), *db]) == 0
    (tmp_path / "file").write_text("")
    assert main(["export", short.name, "--out", str(tmp_path / "file"), *db]) == 2
