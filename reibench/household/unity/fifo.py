"""AI2-THOR's FIFO protocol, the build's side: two named pipes, fields with five-byte headers."""

import errno
import json
import os
import time
from contextlib import suppress
from struct import Struct
from typing import Any

from reibench.household.unity.channel import Answer
from reibench.household.unity.packing import MessagePackFormat, Packer

METADATA, ACTION, RGB, CAMERA_RGB, END = 1, 2, 4, 10, 255
"""The kinds of field there are between this build and the client."""
HEADER = Struct("!BI")
PIPE_SIZE = 1 << 20
"""Bytes a pipe should hold, so that a frame goes through in one piece."""
PATIENCE = 60.0
"""Seconds to wait for the client to open its end."""


class FifoChannel:
    """The two pipes; opened in the order the client expects."""

    def __init__(self, server_pipe: str, client_pipe: str) -> None:
        self._out = _open_for_writing(server_pipe)
        self._client_pipe = client_pipe
        self._in: int | None = None
        self._packer = Packer(MessagePackFormat())
        _enlarge(self._out)

    def send(self, answer: Answer) -> None:
        """Send the metadata as msgpack and the images as they are."""
        parts = _field(METADATA, self._packer.pack(answer.event, answer.number))
        for frame in answer.frames:
            parts += _field(RGB, frame)
        for frame in answer.camera_frames:
            parts += _field(CAMERA_RGB, frame)
        parts.append(HEADER.pack(END, 0))
        _write(self._out, b"".join(parts))

    def receive(self) -> dict[str, Any] | None:
        """Wait for an action, which is JSON."""
        if self._in is None:
            self._in = os.open(self._client_pipe, os.O_RDONLY)
        action = None
        while (header := _read(self._in, HEADER.size)) is not None:
            kind, length = HEADER.unpack(header)
            if kind == END:
                return action
            body = _read(self._in, length)
            if body is None:
                return None
            if kind == ACTION:
                action = json.loads(body)
        return None


def _field(kind: int, body: bytes) -> list[bytes]:
    return [HEADER.pack(kind, len(body)), body]


def _open_for_writing(path: str) -> int:
    """Open a pipe once the client reads from it, without being stuck should it never do so."""
    limit = time.monotonic() + PATIENCE
    while True:
        try:
            pipe = os.open(path, os.O_WRONLY | os.O_NONBLOCK)
        except OSError as error:
            if error.errno != errno.ENXIO:
                raise
            if time.monotonic() > limit:
                raise ConnectionError(f"nobody reads from {path}") from None
            time.sleep(0.002)
        else:
            os.set_blocking(pipe, True)
            return pipe


def _enlarge(pipe: int) -> None:
    import fcntl

    with suppress(AttributeError, OSError):  # Linux has it, within limits the machine sets.
        fcntl.fcntl(pipe, fcntl.F_SETPIPE_SZ, PIPE_SIZE)


def _write(pipe: int, message: bytes) -> None:
    left = memoryview(message)
    while left:
        left = left[os.write(pipe, left) :]


def _read(pipe: int, length: int) -> bytes | None:
    """Read exactly that much; None at the end."""
    parts = []
    while length:
        part = os.read(pipe, length)
        if not part:
            return None
        parts.append(part)
        length -= len(part)
    return b"".join(parts)
