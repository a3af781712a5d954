"""The watchdog: one Unity process and its client, which always come to an end.

The client can wait for ever for a process that has died or hangs, and spin while it does so.
Here it works on a thread of its own, whoever asks waits with a limit, and what does not answer is
ended with everything it has made.
"""

import atexit
import subprocess
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, wait
from contextlib import suppress
from time import monotonic
from typing import TYPE_CHECKING, TypeVar

from reibench.errors import ReibenchError, WorldBroken

if TYPE_CHECKING:
    from reibench.worlds.ai2thor.client import Client

T = TypeVar("T")
LOOK_EVERY = 0.05
"""Seconds between two looks at whether the process still lives, while it is waited for."""
ENDS_WITHIN = 0.5
"""Seconds for a process to have ended once the client says that the connection broke."""
UNBLOCKED_WITHIN = 5.0
"""Seconds for the client's thread to give up once the process has been killed."""


class Conversation:
    """A running client; after a WorldBroken it is over, and nothing of it is left."""

    def __init__(self, client: "Client") -> None:
        self.over = False
        self._client = client
        self._thread = ThreadPoolExecutor(1, thread_name_prefix="ai2thor")
        self._working: Future[object] | None = None

    def start(self, room: str, seconds: float) -> None:
        """Start the process and load a room, in `seconds` from when the process runs.

        Raises:
            UnknownName: for a room that is not there; the process runs all the same.
            WorldBroken: when it does not start.
        """
        atexit.register(self.end)
        self.ask("its start", lambda: self._client.open(room), seconds)
        self._client.forget_pipes()

    def ask(self, doing: str, call: Callable[[], T], seconds: float) -> T:
        """Return what `call` does on the client's thread.

        Raises:
            WorldBroken: when it takes longer than `seconds`, or the client fails.
        """
        if self.over:
            raise WorldBroken(f"Unity has ended; {doing} needs a fresh start.")
        future = self._thread.submit(call)
        self._working = future  # type: ignore[assignment]
        try:
            problem = self._outcome(future, seconds)
        except BaseException:
            # Interrupted (Ctrl-C), or given up: the client's answer would come out of turn.
            self.end()
            raise
        if problem is None:
            return future.result()
        if isinstance(problem, ReibenchError):
            raise problem
        raise self._broken(doing, problem, seconds) from problem

    def _outcome(self, future: "Future[T]", seconds: float) -> BaseException | None:
        """Return what went wrong, if anything; a TimeoutError if no answer is to be expected."""
        since = monotonic()
        while True:
            try:
                return future.exception(timeout=LOOK_EVERY)
            except TimeoutError as waiting:
                process = self._client.process
                if process is None:
                    since = monotonic()
                elif process.poll() is not None or monotonic() - since > seconds:
                    return waiting

    def _broken(self, doing: str, problem: BaseException, seconds: float) -> WorldBroken:
        """End the conversation and say why."""
        process = self._client.process
        client_failed = self._working is not None and self._working.done()
        if process and client_failed:
            # A process that is killed lets its pipes go a moment before it has ended.
            with suppress(subprocess.TimeoutExpired):
                process.wait(ENDS_WITHIN)
        status = process.poll() if process else None
        self.end()
        if status is not None:
            return WorldBroken(f"Unity ended by itself during {doing} (exit status {status}).")
        if client_failed:
            what = f"{type(problem).__name__}: {problem}"
            return WorldBroken(f"AI2-THOR's client failed during {doing} ({what}).")
        return WorldBroken(
            f"Unity stopped answering during {doing} after {seconds:g} s; it was ended."
        )

    def end(self) -> None:
        """Kill the process, free the client's thread and remove what they made."""
        if self.over:
            return
        self.over = True
        working, limit = self._working, monotonic() + UNBLOCKED_WITHIN
        self._client.kill()
        while working and not working.done() and monotonic() < limit:
            self._client.unblock()
            wait([working], LOOK_EVERY)
            self._client.kill()
        self._thread.shutdown(wait=working is None or working.done())
        self._client.release()
        atexit.unregister(self.end)
