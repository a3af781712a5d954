"""Stand-ins that break on purpose, and what is left of them."""

import os
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from reibench.worlds import World
from reibench.worlds.naming import create_world

STAND_IN = "reibench.household.unity"


@pytest.fixture(params=["fifo", "wsgi"])
def server(request, monkeypatch) -> str:
    monkeypatch.setenv("REIBENCH_UNITY_SERVER", request.param)
    return request.param


@pytest.fixture
def standing_in(monkeypatch) -> Iterator[Callable[..., World]]:
    """Make worlds over stand-ins started with these arguments, impatiently."""
    monkeypatch.setenv("REIBENCH_UNITY_START_SECONDS", "3")
    monkeypatch.setenv("REIBENCH_UNITY_STEP_SECONDS", "1")
    made: list[World] = []

    def make(arguments: str = "", **options: object) -> World:
        monkeypatch.setenv("REIBENCH_UNITY_ARGUMENTS", arguments)
        made.append(create_world("ai2thor:stand-in", **options))
        monkeypatch.delenv("REIBENCH_UNITY_ARGUMENTS")
        return made[-1]

    yield make
    for world in made:
        world.close()


@pytest.fixture
def running() -> Callable[[], set[int]]:
    """Return the stand-ins that this test has started and that still run, or are not reaped."""
    here = str(os.getpid())

    def look() -> set[int]:
        found = set()
        for folder in Path("/proc").glob("[0-9]*"):
            try:
                parent = folder.joinpath("stat").read_text().rpartition(")")[2].split()[1]
            except OSError:
                continue  # It ended while we looked.
            if parent == here:
                found.add(int(folder.name))
        return found

    before = look()
    return lambda: look() - before


@pytest.fixture
def left_behind(running, tmp_path, monkeypatch) -> Callable[[], list[object]]:
    """Return what is there now and was not before: processes, threads, files and folders."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    threads, pipes = set(threading.enumerate()), _open_files()

    def look() -> list[object]:
        more = [thread for thread in threading.enumerate() if thread not in threads]
        return [*running(), *more, *tmp_path.iterdir(), *(_open_files() - pipes)]

    return look


def _open_files() -> set[str]:
    """Return the pipes and sockets this process has open."""
    folder = Path("/proc/self/fd")
    found = {str(each.readlink()) for each in folder.iterdir() if each.is_symlink()}
    return {each for each in found if each.startswith(("pipe:", "socket:")) or ".pipe" in each}
