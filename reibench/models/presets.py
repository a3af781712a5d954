"""Presets: the paper's models by the names it gives them."""

import tomllib
from dataclasses import dataclass
from difflib import get_close_matches

from reibench.errors import UnknownName
from reibench.models import ROOT, shelf

PRESETS = ROOT / "assets" / "presets.toml"


@dataclass(frozen=True)
class Preset:
    """A model of the paper, and what it is here."""

    name: str
    model: str
    """`KIND:SOURCE`, as on the command line."""
    parameters: str
    """As the paper lists them, e.g. `8B`."""
    download: float
    """Gigabytes fetched when it is first used; 0 for a model behind an API."""
    licence: str
    instruct: bool
    """Whether it was tuned to follow instructions in a chat."""
    note: str


def presets() -> tuple[Preset, ...]:
    """Return the paper's models, in its order."""
    entries = tomllib.loads(PRESETS.read_text(encoding="utf-8"))["preset"]
    return tuple(Preset(**entry) for entry in entries)


def full_name(model: str) -> str:
    """Return what a preset stands for, e.g. `openai:gpt-4o-mini`, and `KIND:NAME` as it is.

    Raises:
        UnknownName: when it is neither.
    """
    if not model or ":" in model:
        return model
    named = {preset.name: preset.model for preset in presets()}
    if model.lower() not in named:
        near = get_close_matches(model.lower(), named, n=1)
        hint = f" Did you mean {near[0]!r}?" if near else ""
        raise UnknownName(
            f"{model!r} names no language model; it should read KIND:NAME, for example"
            f" 'llama-cpp:gemma-3-270m', or be one of {', '.join(named)}.{hint}"
        )
    return named[model.lower()]


@dataclass(frozen=True)
class Known:
    """A model that has a name of its own."""

    name: str
    """What `--model` takes."""
    model: str
    """`KIND:SOURCE`."""
    size: str
    kind: str
    """`chat` or `base`."""
    licence: str


def known() -> tuple[Known, ...]:
    """Return the presets and the models on the shelf."""
    listed = [
        Known(
            preset.name,
            preset.model,
            f"{preset.parameters}, {preset.download:g} GB" if preset.download else "behind an API",
            _kind(preset.instruct),
            preset.licence,
        )
        for preset in presets()
    ]
    for model in shelf():
        name = f"llama-cpp:{model.name}"
        size = f"{model.size / 1e9:.1f} GB"
        listed.append(Known(name, name, size, _kind(model.instruct), model.licence))
    return tuple(listed)


def _kind(instruct: bool) -> str:
    return "chat" if instruct else "base"


def table() -> str:
    """Return the presets as text, one a paragraph."""
    width = max(len(preset.name) for preset in presets())
    lines = ["Models of the paper, by name; what each stands for is fetched when it is first used:"]
    for preset in presets():
        size = f", {preset.download:g} GB" if preset.download else ""
        kind = _kind(preset.instruct)
        lines.append(f"  {preset.name:<{width}}  {preset.model}{size}, {kind}, {preset.licence}")
        lines.append(f"  {'':<{width}}  {preset.note}")
    return "\n".join(lines)
