"""Patience with a server: what passes is tried again, at a pace that all threads keep together."""

import logging
import re
from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from email.utils import parsedate_to_datetime
from random import uniform
from threading import Lock
from time import monotonic, sleep
from typing import TypeVar

from reibench.errors import ModelUnavailable, ReibenchError

T = TypeVar("T")

TRIES = 6
LONGEST = 300.0
"""Seconds; a server that asks for more is given up at once."""
UNITS = {"h": 3600.0, "m": 60.0, "s": 1.0, "ms": 0.001, "": 1.0}

log = logging.getLogger(__name__)


class Trouble(Exception):
    """What may pass: the server is busy, broke off, or did not answer in time."""

    def __init__(self, text: str, *, wait: float = 0.0, status: int = 0) -> None:
        super().__init__(text)
        self.wait = wait
        """Seconds the server asks to be left alone; 0 where it does not say."""
        self.status = status
        """HTTP status; 0 where there was no answer."""


class Exhausted(ModelUnavailable):
    """A server that went on making trouble, however often it was asked."""

    def __init__(self, text: str, *, status: int = 0) -> None:
        super().__init__(text)
        self.status = status


class Refused(ReibenchError):
    """A request the server does not accept, and would not the next time."""

    def __init__(self, text: str, *, status: int, field: str = "") -> None:
        super().__init__(text)
        self.status = status
        self.field = field
        """The field of the request that it knows nothing of, if it is that."""


class Patience:
    """Asks again after trouble, waiting twice as long each time; safe to share among threads."""

    def __init__(
        self,
        *,
        tries: int = TRIES,
        first: float = 1.0,
        longest: float = 60.0,
        per_minute: float = 0.0,
    ) -> None:
        """Set the limits.

        Args:
            tries: how often one question is asked at most.
            first: seconds before the second try, up to half of which are left out at random.
            longest: seconds that the doubled waiting time never exceeds.
            per_minute: requests that all threads together send at most; 0 for no limit.
        """
        self._tries = tries
        self._first = first
        self._longest = longest
        self._interval = 60.0 / per_minute if per_minute else 0.0
        self._free = 0.0
        self._lock = Lock()

    def persist(self, ask: Callable[[], T]) -> T:
        """Return what `ask` returns as soon as it raises no Trouble; raises Exhausted."""
        tried = 0
        while True:
            while (left := self._claim()) > 0:
                sleep(left)
            tried += 1
            try:
                return ask()
            except Trouble as passing:
                trouble = passing
            if tried == self._tries or trouble.wait > LONGEST:
                break
            log.info("try %d of %d: %s", tried, self._tries, trouble)
            self.pause(trouble.wait)
            sleep(uniform(0.5, 1.0) * min(self._longest, self._first * 2 ** (tried - 1)))
        asked = f" and asks to wait {trouble.wait:.0f} s" if trouble.wait > LONGEST else ""
        times = "once" if tried == 1 else f"{tried} times"
        raise Exhausted(f"{trouble}{asked}; asked {times}, then given up.", status=trouble.status)

    def pause(self, seconds: float) -> None:
        """Let no thread ask anything for so long."""
        with self._lock:
            self._free = max(self._free, monotonic() + seconds)

    def _claim(self) -> float:
        """Take the next turn and return 0, or the seconds until it may be taken."""
        with self._lock:
            now = monotonic()
            if now < self._free:
                return self._free - now
            self._free = now + self._interval
            return 0.0


def asked_wait(headers: Mapping[str, str]) -> float:
    """Return the seconds that `Retry-After` asks for, or the time until a spent limit is reset."""
    if "retry-after-ms" in headers:
        return _duration(headers["retry-after-ms"] + "ms")
    after = headers.get("retry-after", "")
    if after and not after[0].isdigit():
        return _until(after)
    return _duration(after) or spent_for(headers)


def spent_for(headers: Mapping[str, str], tokens: int = 0) -> float:
    """Return the seconds until requests, or `tokens` more tokens, are allowed again; 0 for now."""
    waits = [0.0]
    for kind, needed in (("requests", 1), ("tokens", max(1, tokens))):
        left = headers.get(f"x-ratelimit-remaining-{kind}", "")
        if left.isdigit() and int(left) < needed:
            waits.append(_duration(headers.get(f"x-ratelimit-reset-{kind}", "")))
    return min(LONGEST, max(waits))


def _duration(text: str) -> float:
    """Return the seconds of `6m0s`, `20ms`, `1.5` and the like; 0 for anything else."""
    parts = re.findall(r"(\d+(?:\.\d+)?)(ms|h|m|s|)", text.strip())
    return sum(float(number) * UNITS[unit] for number, unit in parts)


def _until(date: str) -> float:
    try:
        moment = parsedate_to_datetime(date)
    except ValueError:
        return 0.0
    if moment.tzinfo is None:
        moment = moment.replace(tzinfo=UTC)
    return max(0.0, (moment - datetime.now(UTC)).total_seconds())
