"""The world pool: lends each owner a world, and takes the longest idle one back when it is full."""

import threading
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Generic, TypeVar

T = TypeVar("T")


@dataclass
class Lease(Generic[T]):
    """Something lent, with the lock its user holds while working with it."""

    value: T
    lock: threading.Lock = field(default_factory=threading.Lock)


class Pool(Generic[T]):
    """Keeps at most `size` things by owner; the least recently used one leaves first."""

    def __init__(self, size: int, on_return: Callable[[T], None]) -> None:
        self._size = size
        self._on_return = on_return
        self._leases: OrderedDict[str, Lease[T]] = OrderedDict()
        self._lock = threading.Lock()

    def lend(self, owner: str, make: Callable[[], T]) -> Lease[T]:
        """Return what `owner` has, or make it; what is in use is never taken back."""
        with self._lock:
            if owner not in self._leases:
                self._leases[owner] = Lease(make())
                self._make_room(owner)
            self._leases.move_to_end(owner)
            return self._leases[owner]

    def take_back(self, owner: str) -> None:
        """Take back what `owner` has, if anything."""
        with self._lock:
            lease = self._leases.pop(owner, None)
        if lease:
            self._on_return(lease.value)

    def __len__(self) -> int:
        return len(self._leases)

    def _make_room(self, newcomer: str) -> None:
        idle = [
            owner
            for owner, lease in self._leases.items()
            if owner != newcomer and not lease.lock.locked()
        ]
        for owner in idle[: max(len(self._leases) - self._size, 0)]:
            self._on_return(self._leases.pop(owner).value)
