"""Every way in which AI2-THOR's client gets stuck ends in one sentence, and nothing is left.

The cases are those found with the real client: processes that exit, hang, spin or crash at their
start or later, and clients that wait for them for ever.
"""

import os
import re
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from reibench.errors import UnknownName, WorldBroken, WorldUnavailable
from reibench.skill import parse_skill
from reibench.worlds.naming import check_world, create_world

FIND = parse_skill("find a potato")
PICK_UP = parse_skill("pick up the potato")
SOON = 9.0
"""Seconds: the limits of these tests, and five for the end; users are promised fifteen."""


def broken(call) -> str:
    """Return the sentence, and check that it came soon and without burning the processor."""
    begin, busy = time.monotonic(), time.process_time()
    with pytest.raises(WorldBroken) as caught:
        call()
    assert time.monotonic() - begin < SOON
    assert time.process_time() - busy < 1.5
    return str(caught.value)


def test_no_display_is_needed(standing_in, server, episode, monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    assert standing_in().reset(episode.task).success


def test_a_graphics_card_chosen_for_models_does_not_matter(standing_in, episode, monkeypatch):
    monkeypatch.setenv("CUDA_VISIBLE_DEVICES", "0")
    assert standing_in().reset(episode.task).success


@pytest.mark.parametrize(
    ("fault", "sentence"),
    [
        ("exit-at-start", r"Unity ended by itself during its start \(exit status 3\)"),
        ("die-after:1", r"Unity ended by itself during its start \(exit status 3\)"),
        ("crash-after:2", r"Unity ended by itself during its start \(exit status -6\)"),
        ("hang-at-start", r"Unity stopped answering during its start after 3 s; it was ended"),
        ("spin-after:2", r"Unity stopped answering during its start after 3 s; it was ended"),
        ("die-after:6", r"Unity ended by itself during \w+ \(exit status 3\)"),
        ("crash-after:6", r"Unity ended by itself during \w+ \(exit status -6\)"),
        ("hang-after:6", r"Unity stopped answering during \w+ after 1 s; it was ended"),
        ("spin-after:6", r"Unity stopped answering during \w+ after 1 s; it was ended"),
    ],
)
def test_a_unity_that_breaks_is_said_in_a_sentence_and_leaves_nothing(
    fault, sentence, server, standing_in, episode, left_behind
):
    world = standing_in(f"--fault {fault}")

    def play():
        world.reset(episode.task)
        for _ in range(5):
            world.step(FIND)
            world.step(parse_skill("find a mug"))

    said = broken(play)
    assert re.search(sentence, said), said
    assert left_behind() == []


@pytest.mark.parametrize(
    ("end", "said"),
    [
        (signal.SIGKILL, "(exit status -9)."),
        (signal.SIGSEGV, "(exit status -11)."),
        (signal.SIGSTOP, "stopped answering during PickupObject after 1 s; it was ended."),
    ],
)
def test_a_fresh_unity_replaces_one_that_broke_between_steps(
    end, said, server, standing_in, episode, running, left_behind
):
    world = standing_in()
    before = world.reset(episode.task)
    world.step(FIND)
    [process] = running()
    os.kill(process, end)
    time.sleep(0.1)
    assert broken(lambda: world.step(PICK_UP)).endswith(said)
    assert left_behind() == []
    assert world.reset(episode.task) == before
    assert world.step(FIND).success
    [again] = running()
    assert again != process


def test_a_unity_killed_in_the_middle_of_a_step_is_noticed_then(
    server, standing_in, episode, running, left_behind
):
    world = standing_in()
    world.reset(episode.task)
    world.step(FIND)
    [process] = running()
    os.kill(process, signal.SIGSTOP)
    threading.Timer(0.3, os.kill, (process, signal.SIGKILL)).start()
    said = broken(lambda: world.step(PICK_UP))
    assert said == "Unity ended by itself during PickupObject (exit status -9)."
    assert left_behind() == []


def test_closing_leaves_nothing(server, standing_in, episode, running, left_behind):
    world = standing_in()
    world.reset(episode.task)
    world.step(FIND)
    assert len(running()) == 1
    world.close()
    assert left_behind() == []
    world.close()


def test_a_room_that_unity_lacks_is_named_and_the_same_unity_goes_on(
    server, standing_in, episodes, running
):
    from dataclasses import replace

    task = episodes["heat_potato.mixed-noised"].task
    nowhere = replace(task, setup=replace(task.setup, room="kitchen-1x"))
    world = standing_in()
    with pytest.raises(UnknownName, match="Did you mean 'kitchen-1'"):
        world.reset(nowhere)
    [process] = running()
    assert world.reset(task).success
    assert running() == [process]


def test_a_program_that_is_not_there_is_said_before_anything_starts(tmp_path):
    with pytest.raises(WorldUnavailable, match="There is no Unity executable"):
        create_world(f"ai2thor:{tmp_path}/thor")
    (tmp_path / "thor").write_text("not to be run")
    with pytest.raises(WorldUnavailable, match="chmod"):
        check_world(f"ai2thor:{tmp_path}/thor")


def wrapper(folder: Path, mark: str, *, then: str = "") -> Path:
    """Write a program that starts the stand-in as a child of its own, as wrappers of Unity do."""
    script = folder / "thor wrapper"
    stand_in = f'"{sys.executable}" -m reibench.household.unity "$@" {mark}'
    script.write_text(f"#!/bin/sh\n{stand_in}{then}\nexit 5\n")
    script.chmod(0o755)
    return script


def test_the_stand_in_under_another_name_is_refused(server, tmp_path, mark, episode, left_behind):
    world = create_world(f"ai2thor:{wrapper(tmp_path, mark)}")
    with pytest.raises(WorldBroken, match="What answers is the wire stand-in"):
        world.reset(episode.task)
    assert left_behind() == []


def test_a_program_that_leaves_a_child_and_exits_is_ended_with_it(
    server, tmp_path, mark, episode, left_behind, monkeypatch
):
    monkeypatch.setenv("REIBENCH_UNITY_START_SECONDS", "3")
    hanging = wrapper(tmp_path, f"--fault hang-at-start {mark}", then=" & sleep 0.5")
    world = create_world(f"ai2thor:{hanging}")
    assert "exit status 5" in broken(lambda: world.reset(episode.task))
    assert left_behind() == []


PARENT = """
import sys, time
from reibench.dataset.files import shipped_episodes
from reibench.worlds.naming import create_world
world = create_world("ai2thor:stand-in")
world.reset(shipped_episodes()[0].task)
print("ready", flush=True)
if sys.argv[1] == "wait":
    time.sleep(60)
"""


def parent(mark: str, how: str, folder: Path) -> "subprocess.Popen[bytes]":
    environment = os.environ | {"REIBENCH_UNITY_ARGUMENTS": mark, "TMPDIR": str(folder)}
    return subprocess.Popen(
        [sys.executable, "-c", PARENT, how],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=environment,
    )


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
def test_a_parent_that_is_ended_takes_its_unity_along(how, server, mark, running, tmp_path):
    program = parent(mark, "wait", tmp_path)
    assert program.stdout.readline() == b"ready\n"
    assert len(running()) == 1
    program.send_signal(how)
    program.communicate(timeout=10)
    assert gone(running)
    assert list(tmp_path.iterdir()) == []


def test_a_program_that_forgets_to_close_ends_cleanly(server, mark, running, tmp_path):
    program = parent(mark, "end", tmp_path)
    _, complaints = program.communicate(timeout=20)
    assert (program.returncode, complaints) == (0, b"")
    assert gone(running)
    assert list(tmp_path.iterdir()) == []


def gone(running, within: float = 3.0) -> bool:
    """Whether no process is left, which may take the kernel a moment."""
    limit = time.monotonic() + within
    while running() and time.monotonic() < limit:
        time.sleep(0.05)
    return not running()
