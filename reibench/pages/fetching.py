"""Models on their way to this machine, for everyone who looks at the shelf."""

import threading
import time
from collections.abc import Iterator

from reibench import models
from reibench.errors import ReibenchError
from reibench.view.shelf import Fetching

_GLANCE = 0.7
"""Seconds between two looks at the progress."""


class Fetcher:
    """Fetches models one at a time, and knows how far each is."""

    def __init__(self) -> None:
        self._states: dict[str, Fetching] = {}
        self._lock = threading.Lock()

    @property
    def states(self) -> dict[str, Fetching]:
        """The models that are coming, or that could not be fetched, by name."""
        return dict(self._states)

    def known(self) -> frozenset[str]:
        """Return the names of the models that can be fetched."""
        return frozenset(model.name for model in models.shelf())

    def fetch(self, name: str) -> Iterator[None]:
        """Fetch a model, and yield now and then while it comes."""
        with self._lock:
            running = self._states.get(name)
            if running is None or running.error:
                self._states[name] = Fetching()
                threading.Thread(target=self._work, args=(name,), daemon=True).start()
        yield
        while name in self._states and not self._states[name].error:
            time.sleep(_GLANCE)
            yield

    def _work(self, name: str) -> None:
        began = time.monotonic()
        first = 0

        def note(done: int, total: int) -> None:
            nonlocal first
            first = first or done
            passed, come = time.monotonic() - began, done - first
            left = (total - done) * passed / come if come > 0 and passed > 2 else None
            self._states[name] = Fetching(done, total, left)

        try:
            models.get(name, note)
        except ReibenchError as problem:
            self._states[name] = Fetching(error=str(problem))
        else:
            del self._states[name]
