"""AI2-THOR's WSGI protocol, the build's side: answers are POSTed, responses hold the next action.

Written out rather than left to an HTTP library, because the client reads multipart bodies with a
parser of its own that wants header names spelled as here.
"""

import json
import socket
from typing import Any, BinaryIO

from reibench.household.unity.channel import Answer
from reibench.household.unity.packing import JsonFormat, Packer

BOUNDARY = "reibench-household-unity-boundary"


class WsgiChannel:
    """Requests to the client's web server, one for each answer."""

    def __init__(self, host: str, port: int, token: str) -> None:
        self._address = host, port
        self._token = token
        self._packer = Packer(JsonFormat())
        self._next: dict[str, Any] | None = None

    def send(self, answer: Answer) -> None:
        """Post the metadata as JSON and the images as files, and wait for the next action."""
        parts = [
            _text("metadata", self._packer.pack(answer.event, answer.number)),
            _text("token", self._token.encode()),
        ]
        parts += [_image("image", frame) for frame in answer.frames]
        parts += [_image("image-thirdParty-camera", frame) for frame in answer.camera_frames]
        body = b"".join([*parts, f"--{BOUNDARY}--\r\n".encode()])
        self._next = self._post(body)

    def receive(self) -> dict[str, Any] | None:
        """Return the action the last response held; a client that stops sends none."""
        return self._next if self._next and "action" in self._next else None

    def _post(self, body: bytes) -> dict[str, Any] | None:
        host, port = self._address
        head = (
            f"POST /train HTTP/1.1\r\nHost: {host}:{port}\r\n"
            f"Content-Type: multipart/form-data; boundary={BOUNDARY}\r\n"
            f"Content-Length: {len(body)}\r\nConnection: close\r\n\r\n"
        )
        with socket.create_connection(self._address) as connection:
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            connection.sendall(head.encode() + body)
            with connection.makefile("rb") as response:
                return _read_response(response)


def _read_response(response: BinaryIO) -> dict[str, Any] | None:
    """Read no further than the body goes: the client lingers until the connection is closed."""
    status = response.readline().split(None, 2)[1:2]
    if not status:
        return None
    if status != [b"200"]:
        raise ConnectionError(f"the client answered with status {status[0].decode()}")
    length = 0
    while line := response.readline().strip():
        name, _, value = line.partition(b":")
        if name.lower() == b"content-length":
            length = int(value)
    action: dict[str, Any] = json.loads(response.read(length))
    return action


def _text(name: str, text: bytes) -> bytes:
    return _part(f'name="{name}"', "text/plain; charset=utf-8", text)


def _image(name: str, frame: bytes) -> bytes:
    return _part(f'name="{name}"; filename="{name}"', "image/raw-rgb", frame)


def _part(naming: str, kind: str, body: bytes) -> bytes:
    head = (
        f"--{BOUNDARY}\r\nContent-disposition: form-data; {naming}\r\nContent-Type: {kind}\r\n\r\n"
    )
    return b"".join((head.encode(), body, b"\r\n"))
