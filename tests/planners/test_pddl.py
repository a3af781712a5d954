"""Fast Downward on problems of the household domain."""

from concurrent.futures import ThreadPoolExecutor

import pytest

from reibench.errors import InvalidGoal
from reibench.planners.pddl import solve

PROBLEM = """
(define (problem warm-up) (:domain household)
  (:objects apple microwave)
  (:init (portable apple) (openable microwave) (container microwave) (switchable microwave)
         (heats microwave) (fits apple microwave) (hand-empty))
  (:goal (and ({goal} apple))))
"""


def test_the_plan_is_found_and_no_file_is_left_and_nothing_printed(tmp_path, monkeypatch, capfd):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr("tempfile.tempdir", None)
    plan = solve(PROBLEM.format(goal="hot"))
    assert " ".join(map(str, plan)) == (
        "(find apple) (pick-up apple) (find microwave) (open microwave)"
        " (put-down apple microwave) (close microwave) (turn-on microwave)"
    )
    assert not list(tmp_path.iterdir())
    assert capfd.readouterr() == ("", "")


def test_what_cannot_be_reached_is_said_so():
    with pytest.raises(InvalidGoal, match="Nothing the robot can do reaches this goal"):
        solve(PROBLEM.format(goal="cold"))


def test_what_takes_too_long_is_ended():
    with pytest.raises(InvalidGoal, match=r"within 0\.01 seconds"):
        solve(PROBLEM.format(goal="hot"), seconds=0.01)


def test_several_threads_may_plan_at_a_time():
    with ThreadPoolExecutor(3) as pool:
        plans = set(pool.map(solve, [PROBLEM.format(goal="hot")] * 3))
    assert len(plans) == 1
