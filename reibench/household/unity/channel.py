"""Channels: how answers reach AI2-THOR's client, and its actions come back."""

import os
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from reibench.household.controller import Event


@dataclass(frozen=True)
class Answer:
    """What the client is sent after an action."""

    event: Event
    number: int
    """The request's `sequenceId`."""
    frames: Sequence[bytes] = ()
    """RGB images of the robot's eye, bottom row first; none if the action wants none."""
    camera_frames: Sequence[bytes] = ()
    """The same of the third-party cameras, in their order."""


class Channel(Protocol):
    """A lock-step conversation with the client."""

    def send(self, answer: Answer) -> None:
        """Send an answer; raises ConnectionError when the client is gone."""
        ...

    def receive(self) -> dict[str, Any] | None:
        """Wait for the next action; None when the client is gone."""
        ...


def end_with_parent(every: float = 0.5) -> None:
    """End this process when the one that started it has ended, whatever it is doing then."""
    parent = os.getppid()

    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(every)
        os._exit(0)

    threading.Thread(target=watch, daemon=True).start()
