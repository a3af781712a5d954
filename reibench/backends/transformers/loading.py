"""Opening a checkpoint: tokenizer and model, on the device and in the number format asked for."""

import logging
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from time import perf_counter
from typing import Any

from reibench import models
from reibench.backends.transformers.gguf_once import gguf_read_once
from reibench.backends.transformers.source import Source
from reibench.errors import ModelUnavailable, unknown

NEEDED = ("torch", "transformers", "accelerate", "gguf", "llguidance")
INSTALL = "pip install -r requirements-hf.txt"

log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Loaded:
    """A checkpoint in memory."""

    tokenizer: Any
    model: Any


def load(source: Source) -> Loaded:
    """Load `source`, downloading it if need be.

    Raises:
        UnknownName: when its name can be none.
        ModelUnavailable: when it cannot be had, is damaged, or too big.
    """
    _check_packages(source)
    _check_quantization(source)
    import safetensors
    import torch
    import transformers

    transformers.utils.logging.disable_progress_bar()
    device = _device(source)
    where, arguments = _where(source)
    started = perf_counter()
    try:
        quantized = None
        if not source.file:  # a GGUF file's weights are unpacked anyway
            config = transformers.AutoConfig.from_pretrained(where, **arguments)
            quantized = getattr(config, "quantization_config", None)
        with gguf_read_once():
            tokenizer = transformers.AutoTokenizer.from_pretrained(where, **arguments)
            arguments |= _how(source, device, quantized)
            model = transformers.AutoModelForCausalLM.from_pretrained(where, **arguments)
        if source.quantization == "none":
            model.to(device)
    except torch.OutOfMemoryError as error:
        raise ModelUnavailable(
            f"hf:{source.name} does not fit into the memory of {device}; add ?dtype=bfloat16 or"
            " ?quantization=4bit to its name, or take a smaller model."
        ) from error
    except (OSError, ValueError, KeyError, RuntimeError, safetensors.SafetensorError) as error:
        raise ModelUnavailable(_why(source, error)) from error
    log.info("opened %s on %s in %.1f s", source.name, device, perf_counter() - started)
    return Loaded(tokenizer, model.eval())


def _check_packages(source: Source) -> None:
    if missing := [name for name in NEEDED if find_spec(name) is None]:
        raise ModelUnavailable(
            f"hf:{source.name} needs what is not installed here ({', '.join(missing)}); install it"
            f" with '{INSTALL}'."
        )


def _device(source: Source) -> str:
    import torch

    if source.device == "auto":
        accelerator = torch.accelerator.current_accelerator()
        return accelerator.type if accelerator and torch.accelerator.is_available() else "cpu"
    try:
        torch.empty(0, device=source.device)
    except (RuntimeError, AssertionError) as error:
        # torch asserts where it was built without the device
        raise ModelUnavailable(
            f"There is no device {source.device!r} here for hf:{source.name}; leave the option out"
            " to take what there is, or give device=cpu."
        ) from error
    return source.device


def _check_quantization(source: Source) -> None:
    if source.quantization == "none":
        return
    if file := source.file:
        raise ModelUnavailable(
            f"quantization={source.quantization} cannot be had for {file.name}, which is quantized"
            " already; leave the option out, or name a checkpoint that is not GGUF."
        )
    if find_spec("bitsandbytes") is None:
        raise ModelUnavailable(
            f"quantization={source.quantization} needs bitsandbytes, which is not installed;"
            " install it with 'pip install bitsandbytes', or leave the option out."
        )


def _where(source: Source) -> tuple[str, dict[str, Any]]:
    """Return what to load from, and the arguments for every part of it; raises as `load`."""
    if (file := source.file) is None:
        if "/" not in source.name and not Path(source.name).is_dir():
            named = [model.name for model in models.shelf()]
            raise unknown("hf model", source.name, [*named, "ORG/NAME", "PATH", "PATH.gguf"])
        return str(Path(source.name).expanduser()), {"revision": source.revision}
    if not file.is_file():
        raise ModelUnavailable(
            f"There is no model file {file}; give the path of a GGUF file, a folder with a"
            " checkpoint, or ORG/NAME on the Hugging Face hub."
        )
    return str(file.parent), {"gguf_file": file.name}


def _how(source: Source, device: str, kept_quantized: object) -> dict[str, Any]:
    """Return the arguments that say in which numbers, and for those quantized, where."""
    import torch
    import transformers

    short = source.dtype == "auto" and (device != "cpu" or kept_quantized)
    dtype = "float32" if source.dtype == "auto" else source.dtype
    arguments: dict[str, Any] = {"dtype": "auto" if short else getattr(torch, dtype)}
    if source.quantization == "none":
        return arguments
    bits: dict[str, Any] = {"load_in_8bit": True}
    if source.quantization == "4bit":
        bits = {"load_in_4bit": True, "bnb_4bit_quant_type": "nf4"}
    quantized = transformers.BitsAndBytesConfig(**bits)
    return arguments | {"quantization_config": quantized, "device_map": {"": device}}


def _why(source: Source, error: BaseException) -> str:
    """Say in one sentence why it cannot be loaded, and what would help."""
    name = f"hf:{source.name}"
    causes = [error]
    while following := causes[-1].__cause__ or causes[-1].__context__:
        causes.append(following)
    kinds = {type(cause).__name__ for cause in causes}
    if "GatedRepoError" in kinds:
        return (
            f"{name} is only for those who accepted its licence: do so on its page on the hub, and"
            " set HF_TOKEN to a token of that account."
        )
    if kinds & {"RepositoryNotFoundError", "HFValidationError"}:
        return (
            f"There is no {name}: neither a folder here nor a repository on the hub (or a private"
            " one: set HF_TOKEN)."
        )
    if "RevisionNotFoundError" in kinds:
        return f"{name} has no revision {source.revision!r} on the hub; leave the option out."
    if kinds & {
        "LocalEntryNotFoundError",
        "ConnectionError",
        "ConnectError",
        "OfflineModeIsEnabled",
    }:
        return (
            f"{name} is not on this machine and the hub cannot be reached; check the connection,"
            " or give the path of a folder with the checkpoint."
        )
    first = str(error).strip().splitlines() or [type(error).__name__]
    return f"{name} cannot be loaded as a causal language model: {first[0].rstrip('.')}."
