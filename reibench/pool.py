"""The world pool: lends each owner a world, and takes the longest idle one back when it is full."""

import threading
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, field
from time import monotonic
from typing import Generic, TypeVar

T = TypeVar("T")
SWEEP = "pool-sweep"
"""What the thread is called that waits for things to be idle long enough."""
JUST_LENT = 2.0
"""Seconds in which who was lent something has not locked it yet, but will."""


@dataclass
class Lease(Generic[T]):
    """Something lent, with the lock its user holds while working with it."""

    value: T
    lock: threading.Lock = field(default_factory=threading.Lock)
    used: float = field(default_factory=monotonic)

    def idle_for(self, seconds: float) -> bool:
        """Whether nobody has it in use, nor had within so many seconds."""
        return not self.lock.locked() and monotonic() - self.used > seconds


class Pool(Generic[T]):
    """Keeps at most `size` things by owner; the least recently used one leaves first."""

    def __init__(
        self, size: int, on_return: Callable[[T], None], *, idle: float | None = None
    ) -> None:
        """Make an empty pool; what nobody used for `idle` seconds leaves too."""
        self._size = size
        self._on_return = on_return
        self._idle = idle
        self._leases: OrderedDict[str, Lease[T]] = OrderedDict()
        self._lock = threading.Lock()
        self._makers = tuple(threading.Lock() for _ in range(16))
        self._sweeping = False

    def lend(self, owner: str, make: Callable[[], T]) -> Lease[T]:
        """Return what `owner` has, or make it; what is in use is never taken back.

        Others are not kept waiting while it is made, which may take seconds.
        """
        with self._makers[hash(owner) % len(self._makers)]:
            with self._lock:
                lease = self._leases.get(owner)
            if lease is None:
                lease = Lease(make())
            with self._lock:
                lease.used = monotonic()
                self._leases[owner] = lease
                self._leases.move_to_end(owner)
                surplus = max(len(self._leases) - self._size, 0)
                gone = self._pop(JUST_LENT, surplus)
                self._sweep_later()
        for value in gone:
            self._on_return(value)
        return lease

    def peek(self, owner: str) -> T | None:
        """Return what `owner` has, without lending it; None if that is nothing."""
        with self._lock:
            lease = self._leases.get(owner)
        return lease.value if lease else None

    def take_back(self, owner: str) -> None:
        """Take back what `owner` has, if anything."""
        with self._lock:
            lease = self._leases.pop(owner, None)
        if lease:
            self._on_return(lease.value)

    def close(self) -> None:
        """Take back everything."""
        for owner in tuple(self._leases):
            self.take_back(owner)

    def __len__(self) -> int:
        return len(self._leases)

    def _pop(self, idle: float, most: int) -> list[T]:
        """Take out what has been idle for so long, the longest first."""
        owners = [owner for owner, lease in self._leases.items() if lease.idle_for(idle)]
        return [self._leases.pop(owner).value for owner in owners[:most]]

    def _sweep_later(self) -> None:
        if self._idle is not None and not self._sweeping and self._leases:
            self._sweeping = True
            timer = threading.Timer(self._idle / 2, self._sweep)
            timer.daemon, timer.name = True, SWEEP
            timer.start()

    def _sweep(self) -> None:
        with self._lock:
            self._sweeping = False
            gone = self._pop(self._idle or 0.0, len(self._leases))
            self._sweep_later()
        for value in gone:
            self._on_return(value)
