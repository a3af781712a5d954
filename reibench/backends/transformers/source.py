"""What `hf:` names: a checkpoint and how to load it, e.g. `ORG/NAME?dtype=bfloat16`."""

from dataclasses import dataclass, fields
from pathlib import Path
from urllib.parse import parse_qsl

from reibench import models
from reibench.errors import ModelUnavailable, ReibenchError, unknown

DTYPES = ("auto", "float32", "float16", "bfloat16")
QUANTIZATIONS = ("none", "8bit", "4bit")


@dataclass(frozen=True)
class Source:
    """A checkpoint and how to load it."""

    name: str
    """`ORG/NAME` on the hub, a folder, a GGUF file, or the name of a model on the shelf."""
    device: str = "auto"
    """`auto` takes an accelerator if there is one; else as torch calls it: `cpu`, `cuda:1`."""
    dtype: str = "auto"
    """`auto` is what the checkpoint is kept in, but `float32` on the processor, which is slow or
    inexact in anything shorter."""
    quantization: str = "none"
    """`8bit` or `4bit` (NF4), by bitsandbytes, while loading."""
    revision: str = "main"
    """Branch, tag or commit of a repository on the hub."""
    slots: int = 8
    """Prompts kept evaluated side by side."""

    @property
    def file(self) -> Path | None:
        """The GGUF file, where it is one; raises ModelUnavailable if it is not on this machine."""
        if "+" in self.name:
            raise ModelUnavailable(
                f"hf:{self.name} cannot be had, for adapters are llama.cpp's; take"
                f" llama-cpp:{self.name}, or hf:{self.name.partition('+')[0]} without."
            )
        if self.name.lower().endswith(".gguf"):
            return Path(self.name).expanduser()
        if self.name in (model.name for model in models.shelf()):
            return models.path_of(self.name)
        return None


def parse_source(text: str) -> Source:
    """Read `NAME?OPTION=VALUE&OPTION=VALUE`.

    Raises:
        UnknownName: when there is no such option, or an option has no such value.
        ReibenchError: when the options cannot be read.
    """
    name, _, query = text.partition("?")
    try:
        pairs = parse_qsl(query, strict_parsing=True, keep_blank_values=True) if query else []
    except ValueError:
        raise ReibenchError(
            f"The options {query!r} of the model {name!r} cannot be read; they should read like"
            " 'dtype=bfloat16&quantization=4bit'."
        ) from None
    options = dict(pairs)
    known = [field.name for field in fields(Source) if field.name != "name"]
    for option, value in options.items():
        if option not in known:
            raise unknown("option of hf models", option, known)
        _check(option, value)
    slots = int(options.pop("slots", Source.slots))
    return Source(name, slots=slots, **options)


def _check(option: str, value: str) -> None:
    allowed = {"dtype": DTYPES, "quantization": QUANTIZATIONS}
    if option in allowed and value not in allowed[option]:
        raise unknown(option, value, allowed[option])
    if option == "slots" and not (value.isdecimal() and int(value)):
        raise ReibenchError(f"slots={value!r} is no number of prompts to keep; it is 1 or more.")
    if not value:
        raise ReibenchError(f"The option {option!r} has no value; leave it out or give one.")
