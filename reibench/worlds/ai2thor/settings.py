"""Settings of the `ai2thor` world, from the environment."""

import os
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

from reibench.errors import ReibenchError

PREFIX = "REIBENCH_UNITY_"
SERVERS = ("fifo", "wsgi")
PLATFORMS = ("", "CloudRendering", "Linux64", "OSXIntel64")

VARIABLES = {
    "REIBENCH_UNITY": "which Unity `ai2thor` means: stand-in, a path, a build's id",
    f"{PREFIX}SERVER": "fifo (default) or wsgi",
    f"{PREFIX}PLATFORM": "CloudRendering (default without display), Linux64, OSXIntel64",
    f"{PREFIX}DISPLAY": "X display (default: DISPLAY)",
    f"{PREFIX}WIDTH, _HEIGHT": "pixels of a frame (400, 300)",
    f"{PREFIX}START_SECONDS": "allowed for a start or a room, once the process runs (12)",
    f"{PREFIX}STEP_SECONDS": "allowed for one action (10)",
    f"{PREFIX}ARGUMENTS": "more arguments for a local executable or the stand-in",
}
"""For people: environment variables and what they say."""


@dataclass(frozen=True)
class UnitySettings:
    """How Unity is started and how long it may take; none of it decides an outcome."""

    server: str = "fifo"
    """fifo or wsgi: how the client talks to Unity."""
    platform: str = ""
    """CloudRendering, Linux64 or OSXIntel64; by default CloudRendering on Linux without a
    display, and else the client's own choice."""
    display: str = ""
    """X display, e.g. `:0`; by default DISPLAY."""
    width: int = 400
    """Pixels of a frame."""
    height: int = 300
    start_seconds: float = 12.0
    """From when the process runs until a room is there; also for each later room."""
    step_seconds: float = 10.0
    """For one AI2-THOR action."""
    arguments: str = ""
    """More arguments for a local executable or the stand-in."""

    @classmethod
    def from_environment(cls, environment: Mapping[str, str] = os.environ) -> "UnitySettings":
        """Read `REIBENCH_UNITY_SERVER` and so on; raises ReibenchError for a value of no use."""
        given: dict[str, Any] = {}
        for field in fields(cls):
            text = environment.get(PREFIX + field.name.upper(), "").strip()
            if text:
                given[field.name] = _read(field.name, text)
        return cls(**given)


def _read(name: str, text: str) -> str | int | float:
    if name in ("width", "height"):
        return _positive(name, text, int)
    if name.endswith("_seconds"):
        return _positive(name, text, float)
    for choices in (SERVERS if name == "server" else (), PLATFORMS if name == "platform" else ()):
        if choices and text not in choices:
            raise ReibenchError(
                f"{PREFIX}{name.upper()} is {text!r}; it can be {', '.join(filter(None, choices))}."
            )
    return text


def _positive(name: str, text: str, kind: type[int] | type[float]) -> float:
    try:
        value = kind(text)
    except ValueError:
        value = 0
    if not 0 < value < 100_000:
        raise ReibenchError(f"{PREFIX}{name.upper()} is {text!r}; it must be a positive number.")
    return value
