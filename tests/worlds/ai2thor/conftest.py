"""Stand-ins that break on purpose, and what is left of them."""

import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from uuid import uuid4

import pytest

from reibench.pool import SWEEP
from reibench.worlds import World
from reibench.worlds.naming import create_world

Listing = Callable[[], list[int]]


@pytest.fixture(params=["fifo", "wsgi"])
def server(request, monkeypatch) -> str:
    monkeypatch.setenv("REIBENCH_UNITY_SERVER", request.param)
    return request.param


@pytest.fixture
def mark() -> str:
    """Return an argument that the stand-ins of this test have and no other process."""
    return f"--of-test={uuid4().hex}"


@pytest.fixture
def running(mark) -> Listing:
    """List the processes of this test, whoever their parent is now."""

    def look() -> list[int]:
        found = []
        for folder in Path("/proc").glob("[0-9]*"):
            try:
                command = folder.joinpath("cmdline").read_bytes().split(b"\0")
            except OSError:
                continue  # It ended while we looked.
            if mark.encode() in command:
                found.append(int(folder.name))
        return found

    return look


@pytest.fixture
def standing_in(mark, monkeypatch) -> Iterator[Callable[..., World]]:
    """Make worlds over stand-ins started with these arguments, impatiently."""
    monkeypatch.setenv("REIBENCH_UNITY_START_SECONDS", "3")
    monkeypatch.setenv("REIBENCH_UNITY_STEP_SECONDS", "1")
    made: list[World] = []

    def make(arguments: str = "", **settings: str) -> World:
        for name, value in settings.items():
            monkeypatch.setenv(f"REIBENCH_UNITY_{name.upper()}", value)
        monkeypatch.setenv("REIBENCH_UNITY_ARGUMENTS", f"{arguments} {mark}")
        made.append(create_world("ai2thor:stand-in"))
        return made[-1]

    yield make
    for world in made:
        world.close()


@pytest.fixture
def left_behind(running, tmp_path_factory, monkeypatch) -> Callable[[], list[object]]:
    """List what is there now and was not before: processes, threads, open pipes, folders."""
    folder = tmp_path_factory.mktemp("of-the-client")
    monkeypatch.setattr("tempfile.tempdir", str(folder))
    threads, files = set(threading.enumerate()), _open_files()

    def look() -> list[object]:
        limit = time.monotonic() + 2
        while running() and time.monotonic() < limit:
            time.sleep(0.02)  # A killed process that has lost its parent takes a moment to go.
        more = [
            thread
            for thread in threading.enumerate()
            # pages that other tests opened sweep their pools now and then
            if thread not in threads and thread.name != SWEEP
        ]
        return [*running(), *more, *folder.iterdir(), *(_open_files() - files)]

    return look


def _open_files() -> set[str]:
    """Return the pipes and sockets this process has open."""
    found = set()
    for each in Path("/proc/self/fd").iterdir():
        try:
            name = str(each.readlink())
        except OSError:
            continue  # The listing itself.
        if name.startswith(("pipe:", "socket:")) or ".pipe" in name:
            found.add(name)
    return found
