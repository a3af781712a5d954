"""Faults on purpose: a stand-in that really exits, crashes, hangs or spins when told to."""

import os
import signal
import sys
import time
from argparse import ArgumentTypeError
from dataclasses import dataclass

AT_START = ("exit-at-start", "hang-at-start")
AFTER = ("die-after", "crash-after", "hang-after", "spin-after")
STATUS = 3


@dataclass(frozen=True)
class Fault:
    """What goes wrong, and before which action."""

    kind: str
    after: int = 0
    """Actions answered before it happens."""

    @classmethod
    def parse(cls, text: str) -> "Fault":
        """Read `kind` or `kind:N`; raises ArgumentTypeError."""
        kind, colon, number = text.partition(":")
        if kind in AT_START and not colon:
            return cls(kind)
        if kind in AFTER and number.isdecimal():
            return cls(kind, int(number))
        known = ", ".join((*AT_START, *(f"{name}:N" for name in AFTER)))
        raise ArgumentTypeError(f"no fault {text!r}; known: {known}")

    def strike_at_start(self) -> None:
        """Go wrong before a word is said, if that is the fault."""
        if self.kind == "exit-at-start":
            sys.exit(STATUS)
        if self.kind == "hang-at-start":
            _hang()

    def strike(self, answered: int) -> None:
        """Go wrong if so many actions have been answered that it is time to."""
        if self.kind not in AFTER or answered < self.after:
            return
        if self.kind == "die-after":
            sys.exit(STATUS)
        if self.kind == "crash-after":
            _crash()
        if self.kind == "hang-after":
            _hang()
        while True:
            pass


NO_FAULT = Fault("none")


def _hang() -> None:
    while True:
        time.sleep(3600)


def _crash() -> None:
    import resource

    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))  # Nobody wants the core file.
    signal.signal(signal.SIGABRT, signal.SIG_DFL)
    os.abort()
