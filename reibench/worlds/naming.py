"""World names: a kind, and for some kinds after a colon which variant, e.g. `ai2thor:stand-in`."""

from typing import Any

from reibench.errors import UnknownName
from reibench.worlds import Announce, World, silently, worlds
from reibench.worlds.ai2thor.settings import VARIABLES
from reibench.worlds.rules import STRICT, Rules

PROTOCOL_VERIFIED = frozenset(("ai2thor:stand-in",))
"""Worlds where AI2-THOR's client really runs, but Unity does not."""


def create_world(
    name: str,
    rules: Rules = STRICT,
    *,
    frames: bool = False,
    announce: Announce = silently,
) -> World:
    """Make the world of that name; raises UnknownName or WorldUnavailable."""
    kind, _, variant = resolve_world(name).partition(":")
    return worlds.create(kind, rules=rules, variant=variant, frames=frames, announce=announce)


def resolve_world(name: str) -> str:
    """Return the name that means the same wherever it is read; raises UnknownName."""
    kind, colon, variant = name.partition(":")
    factory: Any = worlds.get(kind)
    if hasattr(factory, "resolve"):
        return f"{kind}:{factory.resolve(variant)}"
    if colon:
        raise UnknownName(f"The world {kind!r} has no variants such as {variant!r}.")
    return kind


def check_world(name: str) -> None:
    """Raise WorldUnavailable if the world of that name cannot be had here, or UnknownName."""
    kind, _, variant = resolve_world(name).partition(":")
    factory: Any = worlds.get(kind)
    if hasattr(factory, "check"):
        factory.check(variant)


def world_settings() -> dict[str, str]:
    """Return the environment variables that set worlds up, each with what it says."""
    return {"REIBENCH_WORLD": "the world used unless --world names one", **VARIABLES}


def renders(name: str) -> bool:
    """Whether worlds of that name have cameras."""
    return name.partition(":")[0] == "ai2thor"


def verified(name: str) -> str:
    """Return `protocol-verified` for worlds whose outcomes are the stand-in's, else nothing."""
    return "protocol-verified" if name in PROTOCOL_VERIFIED else ""
