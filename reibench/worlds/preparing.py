"""Getting a world ready in the background, for pages that should say what is going on meanwhile."""

import sys
import threading

from reibench.errors import ReibenchError, WorldUnavailable
from reibench.worlds.naming import create_world

PATIENCE = 2.0
"""Seconds within which most worlds are ready, or known not to be."""


class Preparation:
    """One world that is made ready when first needed; what failed is tried again."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._words = "The world is being prepared."
        self._lock = threading.Lock()
        self._worker: threading.Thread | None = None
        self._problem: ReibenchError | None = None
        self._ready = False

    def require(self) -> None:
        """Return if the world can be made at once.

        Raises:
            WorldUnavailable: in the words of what is still being fetched, or of what went wrong.
        """
        with self._lock:
            if self._ready:
                return
            if self._worker is None:
                # A daemon: a server that is stopped does not wait for a download.
                self._worker = threading.Thread(target=self._prepare, daemon=True)
                self._worker.start()
            worker = self._worker
        worker.join(PATIENCE)
        if worker.is_alive():
            raise WorldUnavailable(f"{self._words} This happens once; try again in a minute.")
        with self._lock:
            self._worker = None
            problem, self._problem = self._problem, None
        if problem is not None:
            raise problem

    def _prepare(self) -> None:
        try:
            create_world(self._name, announce=self._say).close()
            self._ready = True
        except ReibenchError as problem:
            self._problem = problem

    def _say(self, words: str) -> None:
        self._words = words
        sys.stderr.write(f"{words}\n")
