"""Ctrl-C during an evaluation: the first ends it in order, the second at once."""

import os
import signal
import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager

from reibench.worlds import Announce

AT_ONCE = 130
"""Exit status of a process ended by SIGINT, as shells report it."""


@contextmanager
def ending_at_the_second(announce: Announce) -> Iterator[None]:
    """Say that the first Ctrl-C was heard, and end the process at the second.

    A model that is thinking in foreign code keeps Python from its signal handlers. What the system
    writes to the wakeup socket is read by a thread of its own, which is not kept.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    heard, told = socket.socketpair()
    told.setblocking(False)
    before = signal.set_wakeup_fd(told.fileno(), warn_on_full_buffer=False)
    listener = threading.Thread(target=_listen, args=(heard, announce), daemon=True)
    listener.start()
    try:
        yield
    finally:
        signal.set_wakeup_fd(before)
        told.close()
        listener.join(1)  # so that what it has to say comes before what is said of the end


def _listen(heard: socket.socket, announce: Announce) -> None:
    times = 0
    with heard:
        for signals in iter(lambda: heard.recv(64), b""):
            times += signals.count(signal.SIGINT)
            if times > 1:
                os._exit(AT_ONCE)
            if times:
                announce("Stopping; Ctrl-C once more stops at once.")
