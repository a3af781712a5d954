"""Where the server listens."""

import socket

from reibench.errors import ReibenchError


def listen(host: str, port: int) -> socket.socket:
    """Return a socket bound to the address; raises ReibenchError if that cannot be had."""
    try:
        return socket.create_server((host, port))
    except (OSError, OverflowError) as problem:
        why = getattr(problem, "strerror", "") or problem
        raise ReibenchError(
            f"Cannot serve on {host}, port {port}: {why}. Stop what uses it, or choose another port"
            " with --port."
        ) from problem
