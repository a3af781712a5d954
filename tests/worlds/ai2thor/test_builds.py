"""Which Unity is used, what is said where it cannot be had, and how a published build comes here.

The download is the client's own, from a web server of this test: what stands for the build there
is the stand-in, so that it is known to have been started by what it is refused for.
"""

import io
import os
import subprocess
import sys
import threading
import time
import zipfile
from hashlib import sha256
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import pytest

from reibench.errors import ReibenchError, WorldUnavailable
from reibench.store import Store
from reibench.worlds.ai2thor.builds import PUBLISHED, Download, check, command_of
from reibench.worlds.ai2thor.settings import UnitySettings
from reibench.worlds.preparing import Preparation

NAME = f"thor-OSXIntel64-{PUBLISHED}"
"""The one platform that needs neither a display nor Vulkan to be started on Linux."""


def published() -> bytes:
    """Return a build as it is published, with the stand-in as its program."""
    written = io.BytesIO()
    with zipfile.ZipFile(written, "w") as archive:
        archive.writestr("metadata.json", '{"server_types": ["FIFO", "WSGI"]}')
        keys = "<key>CFBundleExecutable</key><string>thor</string>"
        archive.writestr(f"{NAME}.app/Contents/Info.plist", f"<plist><dict>{keys}</dict></plist>")
        program = f'#!/bin/sh\nexec "{sys.executable}" -m reibench.household.unity "$@"\n'
        archive.writestr(f"{NAME}.app/Contents/MacOS/thor", program)
    return written.getvalue()


class Publisher(BaseHTTPRequestHandler):
    """Answers for the server of AI2-THOR's builds."""

    build = published()
    digest = sha256(build).hexdigest()
    seconds = 0.0

    def do_HEAD(self):
        self.answer(b"")

    def do_GET(self):
        time.sleep(self.seconds)
        self.answer(self.digest.encode() if self.path.endswith(".sha256") else self.build)

    def answer(self, body):
        self.send_response(200 if NAME in self.path else 404)
        self.send_header("Content-Length", str(len(body) or len(self.build)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_):
        pass


@pytest.fixture
def publisher():
    """Serve builds until the test is over."""

    class One(Publisher):
        pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), One)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield One, f"http://127.0.0.1:{server.server_port}"
    server.shutdown()
    server.server_close()


@pytest.fixture
def run(publisher, tmp_path):
    """Run a program with this server for a proxy, and a home of its own."""
    given = {"http_proxy": publisher[1], "HOME": str(tmp_path), "no_proxy": ""}
    given["REIBENCH_UNITY_PLATFORM"] = "OSXIntel64"

    def one(*arguments: str):
        return subprocess.run(
            [sys.executable, *arguments],
            env=os.environ | given,
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
        )

    return one


def play(run, database):
    return run(
        *"-m reibench run --planner expert --world ai2thor --limit 1".split(), "--db", str(database)
    )


def test_the_published_build_is_announced_downloaded_once_and_started(run, tmp_path):
    first, second = play(run, tmp_path / "a.db"), play(run, tmp_path / "b.db")
    assert first.stderr.splitlines()[1].startswith(
        "Downloading AI2-THOR's build (http://s3-us-west"
    )
    assert str(tmp_path / ".ai2thor" / "releases") in first.stderr
    assert "Downloading" not in second.stderr
    for name in ("a.db", "b.db"):
        store = Store(tmp_path / name)
        [entry] = store.entries()
        assert (entry.status, entry.world) == ("error", f"ai2thor:{PUBLISHED}")
        # It ran: only what answers can say that it is the stand-in.
        assert "What answers is the wire stand-in" in store.record(entry.id).error


def test_a_damaged_download_is_one_sentence(run, publisher, tmp_path):
    publisher[0].digest = "0" * 64
    done = play(run, tmp_path / "a.db")
    assert done.returncode == 2
    last = done.stderr.splitlines()[-1]
    assert "failed: Digest mismatch" in last
    assert "REIBENCH_UNITY=PATH" in last
    assert Store(tmp_path / "a.db").entries() == []


WAITING = """
import time
from reibench.errors import WorldUnavailable
from reibench.worlds.preparing import Preparation
preparation = Preparation("ai2thor")
for _ in range(10):
    try:
        preparation.require()
        print("ready")
        break
    except WorldUnavailable as problem:
        print(problem)
"""


def test_a_page_says_what_is_being_downloaded_until_it_is_there(run, publisher):
    publisher[0].seconds = 1.5
    *waiting, last = run("-c", WAITING).stdout.splitlines()
    assert last == "ready"
    assert waiting
    assert all("Downloading AI2-THOR's build" in line for line in waiting)
    assert all("try again in a minute" in line for line in waiting)


def test_a_world_that_needs_no_preparation_is_ready_at_once():
    Preparation("ai2thor:stand-in").require()
    Preparation("embedded").require()


def test_a_build_that_cannot_be_had_is_said_with_what_to_do(run, tmp_path):
    done = run(
        *"-m reibench run --planner expert --limit 1 --world".split(), f"ai2thor:{'0' * 40}",
        "--db", str(tmp_path / "a.db"),
    )  # fmt: skip
    assert done.returncode == 2
    assert "cannot be downloaded" in done.stderr
    assert "Not Found" in done.stderr
    assert "ai2thor:stand-in" in done.stderr


def test_without_display_and_vulkan_it_says_what_to_install(monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.setattr("ctypes.util.find_library", lambda name: None)
    with pytest.raises(WorldUnavailable, match="apt-get install libvulkan1"):
        check(PUBLISHED, UnitySettings())


def test_the_folder_of_a_build_names_its_program(tmp_path):
    folder = tmp_path / "thor-Linux64-local"
    folder.mkdir()
    (folder / folder.name).write_text("#!/bin/sh\n")
    (folder / folder.name).chmod(0o755)
    assert check(str(folder), UnitySettings()) is None
    settings = UnitySettings(arguments="-logFile /dev/null")
    assert command_of(str(folder), settings) == f"{folder}/{folder.name} -logFile /dev/null"


def test_the_size_of_a_download_is_told_if_it_is_known(tmp_path):
    assert ", 812 MB" in str(Download("http://x", 812_000_000, tmp_path))
    assert "MB" not in str(Download("http://x", 0, tmp_path))


@pytest.mark.parametrize(
    ("name", "value", "sentence"),
    [
        ("SERVER", "http", "it can be fifo, wsgi"),
        ("PLATFORM", "Windows", "it can be CloudRendering, Linux64"),
        ("WIDTH", "wide", "positive number"),
        ("STEP_SECONDS", "-1", "positive number"),
    ],
)
def test_a_setting_of_no_use_is_said(name, value, sentence):
    with pytest.raises(ReibenchError, match=f"REIBENCH_UNITY_{name} is '{value}'.*{sentence}"):
        UnitySettings.from_environment({f"REIBENCH_UNITY_{name}": value})


def test_settings_come_from_the_environment():
    given = {"REIBENCH_UNITY_SERVER": "wsgi", "REIBENCH_UNITY_WIDTH": "640"}
    assert UnitySettings.from_environment(given) == UnitySettings(server="wsgi", width=640)
