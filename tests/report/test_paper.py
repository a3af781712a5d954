"""The paper's numbers beside ours: the same method at the same level."""

import pytest

from reibench.report.paper import beside_paper, in_words
from reibench.tally import records_frame

pytestmark = pytest.mark.usefixtures("two_runs")


def cells(row, reference, context, metric):
    [found] = [
        each
        for each in row["against_paper"]["errors"]
        if (each["reference"], each["context"], each["metric"]) == (reference, context, metric)
    ]
    return found


def test_every_level_and_kind_is_set_beside_the_paper_s(score_json):
    none, tocc = score_json("--against", "paper")
    assert len(none["against_paper"]["errors"]) == len(tocc["against_paper"]["errors"]) == 27
    ours = cells(tocc, "implicit", "short", "overall_error")
    assert (ours["ours"], ours["episodes"]) == (50.0, 2)
    easy = cells(tocc, "explicit", "short", "overall_error")
    assert (easy["ours"], easy["said_done"]) == (0.0, 50.0)
    assert [(cell["model"], cell["value"]) for cell in ours["published"]] == [("LLaMA3.1-8B", 74.9)]
    assert tocc["against_paper"]["cost"]["input_tokens"] == 1894


def test_without_a_method_all_three_models_stand_there(score_json):
    none, _ = score_json("--against", "paper")
    found = cells(none, "mixed", "standard", "object_omission")
    assert found["ours"] == 50.0
    assert {(cell["model"], cell["value"]) for cell in found["published"]} == {
        ("GPT-4o-mini", 37.0), ("LLaMA3.1-8B", 38.8), ("Deepseek-8B", 40.8),
    }  # fmt: skip
    assert len(found["published"]) == 2 * 2 + 4  # LLaMA stands in all four tables


def test_both_of_contradictory_cells_are_shown_with_their_tables(store):
    frame = records_frame(store)
    aware = frame[frame["method"] == "tocc"].assign(method="ap")
    [overall] = [
        each
        for each in beside_paper(aware).errors
        if (each.reference, each.context, each.metric) == ("explicit", "standard", "overall_error")
    ]
    assert {cell.table: cell.value for cell in overall.published} == {
        "error_rate_on_prompting_methods": 53.2,
        "appendix_error_rate_on_prompting_methods": 60.0,
    }
    shown = [{"table": c.table, "model": c.model, "value": c.value} for c in overall.published]
    assert in_words(shown) == "LLaMA3.1-8B 53.2 (main text) or 60.0 (appendix)"


def test_a_method_or_planner_the_paper_has_no_numbers_of_gets_none(store):
    frame = records_frame(store)
    mine = frame[frame["method"] == "tocc"]
    assert beside_paper(mine.assign(method="tocc-span")).errors == ()
    assert beside_paper(mine.assign(planner="hpe")).errors == ()
    assert beside_paper(frame).errors == ()


def test_text_and_markdown_set_them_beside(score):
    text = score("--against", "paper", "--method", "tocc")
    line = next(x.split() for x in text.splitlines() if "explicit-standard  object" in x)
    assert line[3:] == "0.0 [0.0, 65.8] paper: LLaMA3.1-8B 16.8 (main text and appendix)".split()
    assert "a planning step of the paper's LLaMA3.1-8B: 1,894 tokens in, 62 out, 598.4 ms" in text
    table = score("--against", "paper", "--method", "tocc", "--markdown")
    assert (
        "| saycan+tocc/scripted:toy | implicit-short | overall error | 50.0 [9.5, 90.5] |"
        " LLaMA3.1-8B 74.9 (appendix) |" in table.splitlines()
    )
