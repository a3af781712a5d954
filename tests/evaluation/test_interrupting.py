"""Ctrl-C: everything finished is kept, nothing is left over, and the same command goes on."""

import os
import signal

import pytest

from tests.evaluation.conftest import group_is_gone

CHOICE = ("--episodes", "mixed-noised", "--limit", "20")


def interrupt(run, moment):
    """Press Ctrl-C, which the whole process group gets, once a line begins with `moment`."""
    said = []
    for line in run.start():
        said.append(line)
        if line.startswith(moment):
            os.killpg(run.process.pid, signal.SIGINT)
            break
    _, rest = run.process.communicate(timeout=60)
    return run.process.returncode, "".join(said) + rest


@pytest.mark.parametrize("workers", ["1", "3"])
def test_ctrl_c_keeps_what_was_done_and_the_same_command_goes_on(troubled, workers):
    run = troubled("*=slow", *CHOICE, "--workers", workers)
    status, said = interrupt(run, "[4/")
    assert status == 130
    assert "Traceback" not in said
    assert "the same command goes on from there" in said
    assert group_is_gone(run.process)
    finished = [record for record in run.records if record["status"]]
    assert 4 <= len(finished) < 20
    assert f"{len(finished)} of 20 episodes recorded" in said
    status, [row], said = run.whole("")
    assert (status, row["episodes"], row["success"], row["unfinished"]) == (0, 20, 20, 0)
    assert f"20 episodes, {len(finished)} finished before" in said


def test_a_ctrl_c_is_answered_before_the_end_is_told(troubled):
    run = troubled("*=slow", *CHOICE)
    _, said = interrupt(run, "[2/")
    answer, end = "Stopping; Ctrl-C once more", "episodes recorded in"
    assert 0 <= said.find(answer) < said.find(end)


def test_a_run_that_is_killed_leaves_no_process_behind(troubled):
    run = troubled("*=slow", *CHOICE, "--workers", "3")
    for line in run.start():
        if line.startswith("[3/"):
            run.process.kill()
            break
    run.process.communicate(timeout=60)  # its workers hold the other end of the pipes
    assert group_is_gone(run.process)
    status, [row], _ = run.whole("")
    assert (status, row["episodes"], row["unfinished"]) == (0, 20, 0)


def test_a_second_ctrl_c_ends_even_what_hangs_in_foreign_code(troubled):
    run = troubled("*=hangs", *CHOICE)
    lines = run.start()
    for line in lines:
        if line.startswith("troubled: 20 episodes"):
            break
    run.hangs()
    os.killpg(run.process.pid, signal.SIGINT)
    assert lines.readline() == "Stopping; Ctrl-C once more stops at once.\n"
    assert run.process.poll() is None
    os.killpg(run.process.pid, signal.SIGINT)
    _, rest = run.process.communicate(timeout=60)
    assert run.process.returncode == 130
    assert "Traceback" not in rest
