"""Backends by their names on the command line, e.g. `llama-cpp:gemma-3-270m`."""

from reibench.backends import Backend, backends
from reibench.errors import UnknownName
from reibench.models.presets import full_name


def open_backend(name: str) -> Backend:
    """Open the language model called `KIND:SOURCE`, or a preset; a real one takes a few seconds.

    Raises:
        UnknownName: when there is no such kind, or no such model.
        ModelUnavailable: when its file is missing or broken, or it cannot be reached.
    """
    kind, _, source = (name if name in backends.names() else full_name(name)).partition(":")
    factory = backends.get(kind)
    if not source:
        raise UnknownName(
            f"{name!r} names no language model; it should read KIND:NAME, for example"
            f" {kind + ':gemma-3-270m' if kind == 'llama-cpp' else kind + ':NAME'!r}."
        )
    return factory(source=source)
