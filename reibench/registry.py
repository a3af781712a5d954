"""Names for the parts an experiment can swap.

A part registers itself in its own file; a registry imports every file of its folder when it is
first asked, so a new part is one new file and importing the library loads none of them.
"""

from collections.abc import Callable
from importlib import import_module
from pkgutil import iter_modules
from threading import RLock
from typing import Generic, TypeVar

from reibench.errors import unknown

T = TypeVar("T")
F = TypeVar("F")


class Registry(Generic[T]):
    """Factories of one kind of part, by name."""

    def __init__(self, kind: str, package: str) -> None:
        self.kind = kind
        self._package = package
        self._factories: dict[str, Callable[..., T]] = {}
        self._searched = False
        self._searching = RLock()

    def register(self, name: str) -> Callable[[F], F]:
        """Register the decorated class or function under `name`."""

        def add(factory: F) -> F:
            if name in self._factories:
                raise ValueError(f"{self.kind} {name!r} is registered twice")
            self._factories[name] = factory  # type: ignore[assignment]
            return factory

        return add

    def get(self, name: str) -> Callable[..., T]:
        """Return the factory called `name`.

        Raises:
            UnknownName: with the nearest known name.
        """
        self._search()
        if name not in self._factories:
            raise unknown(self.kind, name, self.names())
        return self._factories[name]

    def create(self, name: str, **options: object) -> T:
        """Build the part called `name`."""
        return self.get(name)(**options)

    def names(self) -> list[str]:
        """Return the registered names, sorted."""
        self._search()
        return sorted(self._factories)

    def _search(self) -> None:
        with self._searching:  # no thread may look at half a search
            if self._searched:
                return
            self._searched = True
            for module in iter_modules(import_module(self._package).__path__):
                import_module(f"{self._package}.{module.name}")
