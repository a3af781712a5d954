"""Scores as text and Markdown."""

import pytest

from tests.report.conftest import NONE, TOCC


@pytest.mark.usefixtures("two_runs")
def test_the_text_says_both_readings_the_finer_kinds_and_the_costs(score):
    lines = score("--runs", "").splitlines()
    assert "  success             9 of 18   50.0%  [29.0%, 71.0%]" in lines
    assert "  … and said done     6 of 18   33.3%  [16.3%, 56.3%]" in lines
    at = lines.index("  object omission     6 of 18   33.3%  [16.3%, 56.3%]")
    assert lines[at + 1] == "      wrong object 3, stopped early 3"
    level = next(line for line in lines if "explicit-standard" in line)
    assert (
        level.split()
        == "explicit-standard success 2 of 2 100.0% [34.2%, 100.0%] (1 said done)".split()
    )
    assert "100 tokens in (10 evaluated), 5.0 out; model 250 ms" in "\n".join(lines)
    assert any("of that restating, an episode: 40 in (30 evaluated), 8.0 out" in x for x in lines)


@pytest.mark.usefixtures("two_runs")
def test_the_text_compares_runs_with_an_interval(score):
    text = score()
    assert "success          +33.3 points [+33.3, +33.3]; only here 6, only there 0" in text
    assert "… and said done  +16.7 points [+0.0, +33.3]; only here 3, only there 0" in text


def test_runs_that_share_no_episode_are_said_to(store, play, score):
    play(store, NONE, {"pick_keys.mixed-short": ["done"]})
    play(store, TOCC, {"pick_keys.mixed-noised": ["Do it.", "done"]})
    shared = f"  no episode is shared with run {NONE.id} (saycan+none/scripted:toy)"
    assert score().splitlines()[-1] == shared


@pytest.mark.usefixtures("two_runs")
def test_markdown_tables_have_as_many_cells_in_every_row(score):
    for table in score("--markdown", "--against", "paper").strip().split("\n\n"):
        widths = {line.count("|") for line in table.splitlines()}
        assert len(widths) == 1, table


@pytest.mark.usefixtures("two_runs")
def test_markdown_shows_solved_of_played_and_the_second_reading(score):
    lines = score("--markdown").splitlines()
    assert lines[0] == "| level | saycan+none/scripted:toy | saycan+tocc/scripted:toy |"
    assert "| explicit-standard | 2/2 (1) | 2/2 (1) |" in lines
    assert "| mixed-noised | 1/2 | 2/2 (1) |" in lines
    assert "| – wrong object | 3 | 0 |" in lines


@pytest.mark.usefixtures("two_runs")
def test_underdetermined_episodes_are_also_left_out_of_one_row(store, score):
    with store.writing() as database:
        database.execute("update records set underdetermined = 1 where level = 'implicit-short'")
    row = next(x for x in score("--markdown").splitlines() if "underdetermined" in x)
    assert row.split(" | ")[1:] == [
        "9 of 16 56.2% [33.2%, 76.9%]",
        "14 of 16 87.5% [64.0%, 96.5%] |",
    ]


@pytest.mark.usefixtures("two_runs")
def test_a_grouping_that_pools_runs_names_what_they_share(score):
    assert score("--by", "planner").startswith(
        "planner saycan  ·  strict rules, 12 steps, 2 runs together"
    )
