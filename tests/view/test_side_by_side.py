"""Two runs are aligned so that what differs stands out."""

from dataclasses import replace

from reibench.methods import Instruction
from reibench.skill import parse_skill
from reibench.view.alignment import align, first_difference
from reibench.view.side_by_side import side_by_side


def skills(*texts):
    return [parse_skill(text) for text in texts]


def kinds(rows):
    return [row.kind for row in rows]


def test_runs_that_do_the_same_have_no_difference():
    run = skills("find an apple", "pick up the apple")
    rows = align(run, run)
    assert kinds(rows) == ["same", "same"]
    assert first_difference(rows) is None


def test_another_object_differs_and_an_extra_step_has_no_counterpart():
    left = skills("find an apple", "pick up the apple", "find a microwave")
    right = skills("find a tomato", "open the fridge", "pick up the tomato", "find a microwave")
    rows = align(left, right)
    assert kinds(rows) == ["differs", "right only", "differs", "same"]
    assert rows[1].left is None
    assert first_difference(rows) == 0


def test_steps_with_different_verbs_never_meet():
    rows = align(skills("find an apple"), skills("open the fridge"))
    assert sorted(kinds(rows)) == ["left only", "right only"]


def test_every_step_appears_once_and_in_order():
    left = skills("find an apple", "find an apple", "open the fridge", "close the fridge")
    right = skills("open the fridge", "find an apple", "close the fridge")
    rows = align(left, right)
    assert [row.left for row in rows if row.left is not None] == [0, 1, 2, 3]
    assert [row.right for row in rows if row.right is not None] == [0, 1, 2]


def test_an_empty_run_aligns_with_anything():
    assert kinds(align([], skills("find an apple"))) == ["right only"]
    assert align([], []) == ()


def test_the_comparison_shows_rewrite_steps_rooms_and_verdicts(
    episode, click, solution, sitting, tags
):
    wrong = click(episode, "find an apple", "pick up the apple")
    wrong.finish()
    left = sitting(wrong, over=True, actor="saycan+none/m")
    right_run = click(episode, *solution)
    right_run.instruction = Instruction(text="Heat the potato.", original="Heat the thing.")
    right_run.finish()
    right = sitting(right_run, over=True, actor="saycan+tocc/m")
    markup = side_by_side(episode, left, right)
    tags(markup)
    assert "<ins>potato</ins>" in markup
    assert "first<br>difference" in markup
    assert "Failed: object omission" in markup
    assert f"Succeeded in {len(solution)} of 30 steps" in markup
    assert markup.count("<svg class=") >= 2


def test_the_rooms_are_shown_as_they_were_at_the_chosen_row(episode, click, solution, sitting):
    run = click(episode, *solution)
    run.finish()
    both = sitting(run, over=True)
    early = side_by_side(episode, both, both, row=0)
    late = side_by_side(episode, both, both)
    assert 'data-row="0"' in early
    assert "<b>Step 1.</b>" in early
    assert "<b>End.</b>" in late


def test_before_and_during_the_runs_the_page_says_so(episode, click, sitting):
    assert 'data-do="watch"' in side_by_side(episode, None, None)
    running = replace(sitting(click(episode, "find an apple")), phase="planning")
    markup = side_by_side(episode, running, None)
    assert 'data-do="stop"' in markup
    assert "first<br>difference" not in markup
