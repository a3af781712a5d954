"""Every planner with every method over the 54 episodes that set the standard, and its tables."""

import csv
import io
import json
from itertools import product

import pytest

from reibench.__main__ import main
from reibench.methods import methods
from reibench.report.tables import TABLES
from tests.conftest import HOT_POTATO

PLANNERS = ("saycan", "dag-plan", "hpe", "llm-p")


@pytest.fixture(scope="module")
def database(tmp_path_factory):
    """Play all of it with one command, the way a researcher does."""
    path = tmp_path_factory.mktemp("table") / "records.db"
    status = main([
        "run", "--planner", ",".join(PLANNERS), "--method", ",".join(methods.names()),
        "--model", HOT_POTATO, "--episodes", "gold", "--db", str(path),
    ])  # fmt: skip
    assert status == 0
    return path


@pytest.fixture
def printed(database, capsys):
    """Return what one `score` command prints about all of it."""

    def score(*options):
        assert main(["score", "--db", str(database), *options]) == 0
        return capsys.readouterr().out

    return score


def test_each_of_the_40_played_all_54_and_none_broke(printed):
    rows = json.loads(printed("--json"))
    played = {(row["spec"]["planner"], row["spec"]["method"]): row for row in rows}
    assert set(played) == set(product(PLANNERS, methods.names()))
    assert {(row["episodes"], row["breakdown"], row["unfinished"]) for row in rows} == {(54, 0, 0)}


def test_the_one_task_the_script_knows_is_solved_at_all_nine_levels_by_every_planner(printed):
    for row in json.loads(printed("--json")):
        assert row["success"] == 9, row["spec"]


@pytest.mark.parametrize("table", sorted(TABLES))
def test_it_prints_the_tables_of_the_paper(printed, table):
    latex = printed("--latex", table)
    assert latex.count(r"\begin{tabular}") == latex.count(r"\end{tabular}") >= 1
    assert "nan" not in latex


def test_it_prints_every_run_as_text_and_as_one_long_table(printed):
    assert printed("--markdown").count("tocc-span") >= len(PLANNERS)
    rows = list(csv.DictReader(io.StringIO(printed("--csv"))))
    assert len(rows) >= len(PLANNERS) * len(methods.names())
