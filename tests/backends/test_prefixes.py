"""Prefixes on disk: found whole, kept within bounds, and never a reason to fail."""

import logging
import os
import time

import pytest

from reibench.backends.prefixes import Prefixes, fingerprint, prepare


@pytest.fixture
def prefixes(tmp_path) -> Prefixes:
    return Prefixes(tmp_path, "model 1")


def keep(prefixes: Prefixes, prefix: str, content: bytes) -> None:
    (prefixes.where / prefixes.part(prefix)).write_bytes(content)
    prefixes.keep(prefix, len(content))


def test_a_prefix_is_found_by_its_text_and_by_nothing_else(prefixes):
    keep(prefixes, "Examples:", b"state")
    assert (prefixes.where / prefixes.find("Examples:")).read_bytes() == b"state"
    assert prefixes.find("Other examples:") == ""
    assert Prefixes(prefixes.where, "model 2").find("Examples:") == ""


@pytest.mark.parametrize("damage", [b"stale", b"sta", b"", b"state and more"])
def test_a_damaged_file_is_said_to_be_and_is_gone(prefixes, caplog, damage):
    keep(prefixes, "Examples:", b"state")
    path = prefixes.where / prefixes.find("Examples:")
    path.write_bytes(damage)
    with caplog.at_level(logging.WARNING):
        assert prefixes.find("Examples:") == ""
    assert f"{path} is damaged" in caplog.text
    assert not path.exists()


def test_what_was_not_written_whole_is_not_kept(prefixes):
    (prefixes.where / prefixes.part("Examples:")).write_bytes(b"sta")
    prefixes.keep("Examples:", len(b"state"))
    assert prefixes.find("Examples:") == ""
    assert list(prefixes.where.iterdir()) == []


def test_those_unused_longest_make_room(tmp_path):
    prefixes = Prefixes(tmp_path, "model", limit=25)
    for hours, prefix in ((3, "a"), (2, "b")):
        keep(prefixes, prefix, prefix.encode() * 10)
        os.utime(tmp_path / prefixes.find(prefix), (time.time() - 3600 * hours,) * 2)
    assert prefixes.find("a")  # so b is now the one unused longest
    keep(prefixes, "c", b"c" * 10)
    assert [bool(prefixes.find(prefix)) for prefix in "abc"] == [True, False, True]


def test_other_files_are_left_alone(tmp_path):
    (tmp_path / "my-notes.kv").write_bytes(b"mine")
    keep(Prefixes(tmp_path, "model", limit=0), "Examples:", b"state")
    assert [path.name for path in tmp_path.iterdir()] == ["my-notes.kv"]


def test_a_folder_that_cannot_be_made_is_said_and_does_without(tmp_path, caplog):
    (tmp_path / "file").write_text("no folder")
    assert prepare(tmp_path / "file" / "prefixes") is None
    assert "cannot be written to" in caplog.text
    assert prepare(tmp_path / "new" / "prefixes") == tmp_path / "new" / "prefixes"


def test_models_are_told_apart_by_what_is_in_them(tmp_path):
    one, other = tmp_path / "one.gguf", tmp_path / "other.gguf"
    one.write_bytes(b"GGUF" + bytes(10_000_000))
    other.write_bytes(one.read_bytes()[:-1] + b"\1")
    for path in (one, other):
        os.utime(path, (1, 1))
    assert fingerprint(one) == fingerprint(one) != fingerprint(other)
