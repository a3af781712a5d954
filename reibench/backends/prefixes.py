"""Evaluated prompt prefixes on disk, so that they survive the process that evaluated them."""

import hashlib
import logging
import os
import re
from pathlib import Path
from time import time

ROOT = Path(__file__).parents[2]
LIMIT = 1_000_000_000
"""Bytes that all models' prefixes together may occupy."""
ABANDONED = 3600
"""Seconds after which a file that is still being written belongs to nobody any more."""
OURS = re.compile(r"[0-9a-f]{32}-[0-9a-f]{32}\.kv|[0-9a-f]{32}-\d+\.part")
"""Files made here: what they were made for, then their checksum or who is writing."""
SAMPLES = 64
SAMPLE = 1 << 16
"""Bytes of each of the samples of a model file that tell it from others."""

log = logging.getLogger(__name__)


def folder() -> Path:
    """Where prefixes are kept: below `REIBENCH_CACHE`, or `data/cache` under the project."""
    cache = os.environ.get("REIBENCH_CACHE") or ROOT / "data" / "cache"
    return Path(cache).expanduser() / "prefixes"


def prepare(where: Path) -> Path | None:
    """Return `where` once it is there and can be written to; None, and a log line, if it cannot."""
    probe = where / f"{os.getpid()}.part"
    try:
        where.mkdir(parents=True, exist_ok=True)
        probe.write_bytes(b"")
        probe.unlink()
    except OSError as error:
        log.warning("prefixes are not kept, %s cannot be written to: %s", where, error.strerror)
        return None
    return where


def fingerprint(model: Path) -> str:
    """Return what tells a model file from others: a digest of its size, age and samples of it."""
    about = model.stat()
    digest = hashlib.sha256(f"{about.st_size} {about.st_mtime_ns}".encode())
    with model.open("rb") as file:
        for number in range(SAMPLES):
            file.seek(max(0, about.st_size - SAMPLE) * number // (SAMPLES - 1))
            digest.update(file.read(SAMPLE))
    return digest.hexdigest()


class Prefixes:
    """The prefixes of one model, as evaluated by one version of one program.

    A file is called by what it was made for and by its own checksum, so one that is damaged, cut
    off or somebody else's is known by its name; such files are ignored, and only our own deleted.
    """

    def __init__(self, where: Path, maker: str, *, limit: int = LIMIT) -> None:
        """Keep them in `where`, which is there; `maker` names model, program and its version."""
        self.where = where
        self._maker = maker
        self._limit = limit

    def find(self, prefix: str) -> str:
        """Return the name of the intact file with `prefix` evaluated, or nothing."""
        for path in sorted(self.where.glob(f"{self._key(prefix)}-*.kv")):
            if path.stem.rpartition("-")[2] == _checksum(path):
                os.utime(path)  # the one unused longest goes first
                return path.name
            log.warning("%s is damaged and not used; it is made anew", path)
            path.unlink(missing_ok=True)
        return ""

    def part(self, prefix: str) -> str:
        """Return the name under which `prefix` is to be written before it is kept."""
        return f"{self._key(prefix)}-{os.getpid()}.part"

    def keep(self, prefix: str, size: int) -> None:
        """Give what was written as `part` its lasting name, if it has all its `size` bytes."""
        part = self.where / self.part(prefix)
        if not part.is_file() or part.stat().st_size != size:
            log.warning("%s was not written whole (is the disk full?) and is not kept", part)
            part.unlink(missing_ok=True)
            return
        part.replace(self.where / f"{self._key(prefix)}-{_checksum(part)}.kv")
        self._make_room()

    def drop(self, name: str) -> None:
        """Delete a file that turned out to be of no use."""
        (self.where / name).unlink(missing_ok=True)

    def _key(self, prefix: str) -> str:
        # a NUL keeps where one ends and the other begins apart
        return hashlib.sha256(f"{self._maker}\0{prefix}".encode()).hexdigest()[:32]

    def _make_room(self) -> None:
        ours = [path for path in self.where.iterdir() if OURS.fullmatch(path.name)]
        kept = {path: path.stat() for path in ours if path.suffix == ".kv"}
        for part in set(ours) - set(kept):
            if time() - part.stat().st_mtime > ABANDONED:
                part.unlink(missing_ok=True)
        total = sum(about.st_size for about in kept.values())
        for path, about in sorted(kept.items(), key=lambda one: one[1].st_mtime):
            if total <= self._limit:
                break
            path.unlink(missing_ok=True)
            total -= about.st_size


def _checksum(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()[:32]
