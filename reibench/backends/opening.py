"""Backends by their names on the command line, e.g. `llama-cpp:gemma-3-270m`."""

from reibench.backends import Backend, backends
from reibench.errors import UnknownName


def open_backend(name: str) -> Backend:
    """Open the language model called `KIND:SOURCE`; takes a few seconds for a real one.

    Raises:
        UnknownName: when there is no such kind, or no such model.
        ModelUnavailable: when its file is missing or broken, or it cannot be reached.
    """
    kind, colon, source = name.partition(":")
    factory = backends.get(kind)
    if not colon or not source:
        raise UnknownName(
            f"{name!r} names no language model; it should read KIND:NAME, for example"
            f" {kind + ':gemma-3-270m' if kind == 'llama-cpp' else kind + ':NAME'!r}."
        )
    return factory(source=source)
