"""LaTeX tables have the paper's shape, and every row as many cells as there are columns."""

import re
from dataclasses import replace

import pytest

from reibench.__main__ import main
from reibench.commands.scoring import LATEX
from reibench.report.latex import escaped
from reibench.report.tables import TABLES
from tests.report.conftest import NONE


def tables_in(text):
    """Return each table's columns, and its rows as lists of cells; a cell that spans counts so."""
    for columns, body in re.findall(
        r"\\begin\{tabular\}\{(\w+)\}\n(.*?)\\end\{tabular\}", text, re.DOTALL
    ):
        lines = [line for line in body.splitlines() if line.endswith(r"\\")]
        rows = (re.split(r"(?<!\\)&", line.removesuffix(r"\\")) for line in lines)
        yield len(columns), [[cell.strip() for cell in cells] for cells in rows]


def width(cells):
    spans = (re.match(r"\s*\\multicolumn\{(\d+)\}", cell) for cell in cells)
    return sum(int(span.group(1)) if span else 1 for span in spans)


@pytest.mark.usefixtures("two_runs")
@pytest.mark.parametrize("name", LATEX)
def test_every_row_fills_every_column_and_braces_balance(score, name):
    text = score("--latex", name)
    assert text.count("{") == text.count("}")
    for kind in ("table*", "tabular", "center"):
        assert text.count(f"\\begin{{{kind}}}") == text.count(f"\\end{{{kind}}}") > 0
    for columns, rows in tables_in(text):
        assert [width(cells) for cells in rows] == [columns] * len(rows)


def test_the_command_line_offers_every_table():
    assert tuple(TABLES) == LATEX


@pytest.mark.usefixtures("two_runs")
def test_errors_by_model_show_the_difference_to_the_explicit_level(score):
    [(_, rows)] = tables_in(score("--latex", "errors-by-model"))
    assert [row[1:] for row in rows[2:]] == [
        ["Explicit REs", "0.0", "0.0", "0.0"],
        ["Mixed REs", r"50.0 (\(+50.0\))", r"0.0 (\(+0.0\))", r"50.0 (\(+50.0\))"],
        ["Implicit REs", r"50.0 (\(+50.0\))", r"50.0 (\(+50.0\))", r"100.0 (\(+100.0\))"],
    ]
    assert rows[2][0] == r"\multirow{3}{*}{toy}"


@pytest.mark.usefixtures("two_runs")
def test_errors_by_method_show_the_difference_to_no_method(score):
    [(_, rows)] = tables_in(score("--latex", "errors-by-method"))
    assert rows[5][0] == r"\multirow{3}{*}{+ TOCC}"
    assert [row[1:] for row in rows[5:]] == [
        ["Explicit REs", r"\textbf{0.0} (\(+0.0\))", "0.0", r"0.0 (\(+0.0\))"],
        ["Mixed REs", r"\textbf{0.0} (\(-50.0\))", "0.0", r"0.0 (\(-50.0\))"],
        ["Implicit REs", r"\textbf{0.0} (\(-50.0\))", "50.0", r"50.0 (\(-50.0\))"],
    ]


@pytest.mark.usefixtures("two_runs")
def test_the_appendix_has_all_nine_levels_and_no_differences(score):
    [(_, rows)] = tables_in(score("--latex", "errors-by-method-all-contexts"))
    assert len(rows) == 2 + 2 * 9
    assert [row[1] for row in rows[2:11:3]] == [
        r"\multirow{3}{*}{Standard}", r"\multirow{3}{*}{Noised}", r"\multirow{3}{*}{Short}",
    ]  # fmt: skip
    assert rows[10][2:] == ["Implicit REs", "50.0", "50.0", "100.0"]


@pytest.mark.usefixtures("two_runs")
def test_captions_say_what_the_rates_do_not(score):
    text = score("--latex", "errors-by-method")
    assert (
        "2 episodes in each cell. Of 8 episodes that count as solved, 3 were not said done." in text
    )


@pytest.mark.usefixtures("two_runs")
def test_the_success_table_has_both_readings(score):
    [(_, rows)] = tables_in(score("--latex", "success"))
    none = rows[2]
    assert none[0] == "SayCan, toy, none"
    assert none[1:4] == ["100.0~/ 50.0", "50.0~/ 50.0", "0.0~/ 0.0"]
    assert none[-2:] == ["50.0 [29.0, 71.0]", "33.3 [16.3, 56.3]"]


@pytest.mark.usefixtures("two_runs")
def test_the_token_table_counts_restating_in_and_says_it_apart(score):
    [(_, rows)] = tables_in(score("--latex", "tokens"))
    none, tocc = rows[2:]
    assert none[:7] == ["toy + SayCan", "100", "10", "5", "105", "250.00", none[6]]
    assert none[7:] == ["--", "83 + 4", none[9]]
    assert tocc[0] == "toy + SayCan + TOCC"
    assert tocc[7] == "40 + 8"
    assert int(tocc[1]) > 100


def test_two_runs_of_one_name_are_told_apart(play, store, solutions, score):
    play(store, NONE, {"pick_keys.explicit-standard": [*solutions["pick_keys"], "done"]})
    other = replace(NONE, code="other")
    play(store, other, {"pick_keys.explicit-standard": ["done"]})
    [(_, rows)] = tables_in(score("--latex", "errors-by-model"))
    assert rows[2][0] == f"\\multirow{{3}}{{*}}{{toy, run {NONE.id}}}"
    assert rows[5][0] == f"\\multirow{{3}}{{*}}{{toy, run {other.id}}}"
    # levels nobody played are empty, not zero
    assert rows[3][2:] == ["--", "--", "--"]


def test_an_expert_alone_makes_no_table(store, episodes, capsys):
    database = str(store.path)
    assert main(["run", "--planner", "expert", "--episodes", "pick_keys", "--db", database]) == 0
    assert main(["score", "--latex", "success", "--db", database]) == 2
    assert "No run with a model is among those chosen" in capsys.readouterr().err


def test_names_cannot_break_a_table():
    assert escaped("a_b&c%d#e{f}") == r"a\_b\&c\%d\#e\{f\}"
