"""Opening llama.cpp on a GGUF file, and on the adapters that go with it."""

import hashlib
import logging
import os
from collections.abc import Collection, Mapping
from importlib.metadata import version
from pathlib import Path
from time import perf_counter
from typing import Any

from reibench import models
from reibench.backends.slots import Variant
from reibench.errors import ModelUnavailable

CONTEXT = 3072
"""Tokens a prompt and its answer may have together."""

log = logging.getLogger(__name__)


def _check_file(path: Path) -> None:
    if not path.is_file():
        raise ModelUnavailable(
            f"There is no model file {path}; give the path of a GGUF file, or the name of a model"
            f" on the shelf ({', '.join(model.name for model in models.shelf())})."
        )
    with path.open("rb") as file:
        if file.read(4) != b"GGUF":
            raise ModelUnavailable(
                f"{path} is no GGUF file (it does not begin with 'GGUF'); download it again, or"
                " give another file."
            )


def open_server(
    path: Path, threads: int, slots: int, kept: Path | None, adapters: Collection[Path]
) -> Any:
    """Return a running server with `adapters` at hand, none of them in use.

    Prefixes are kept in `kept`, unless that is None. Raises ModelUnavailable.
    """
    for file in (path, *adapters):
        _check_file(file)
    # heavy: only when a model is really opened
    from xllamacpp import CommonAdapterLoraInfo, CommonParams, Server

    loras = []
    for file in adapters:
        lora = CommonAdapterLoraInfo()
        lora.path, lora.scale = str(file), 1.0
        loras.append(lora)
    params = CommonParams()
    params.model.path = str(path)
    params.lora_adapters = loras
    params.lora_init_without_apply = True  # each request says which of them it wants
    params.n_parallel = slots
    params.n_ctx = slots * CONTEXT
    params.cpuparams.n_threads = threads
    params.warmup = False
    params.swa_full = True  # a sliding window forgets prefixes, which are then evaluated again
    params.cache_ram_mib = 0  # the slots hold all we reuse
    params.slot_save_path = f"{kept}{os.sep}" if kept else ""
    params.verbosity = -1
    started = perf_counter()
    try:
        server = Server(params)
    except RuntimeError as error:
        raise ModelUnavailable(
            f"llama.cpp cannot open {path} ({path.stat().st_size:,} bytes){_with(adapters)}: the"
            " file is damaged or cut off, of an unknown kind, or too big for the memory; download"
            " it again."
        ) from error
    # A server that is let go before its loop has begun waits for ever; an answer proves it runs.
    server.handle_completions({"prompt": "a", "n_predict": 1, "cache_prompt": False})
    log.info("opened %s in %.1f s", path, perf_counter() - started)
    return server


def _with(adapters: Collection[Path]) -> str:
    return f", or with it {' or '.join(map(str, adapters))}" if adapters else ""


def variants_of(adapters: Mapping[str, Path]) -> dict[str, Variant]:
    """Return the model as it comes and with each of its adapters, none of which is mixed."""
    if not adapters:
        return {"": Variant()}
    names = list(adapters)

    def request(chosen: str) -> dict[str, object]:
        scales = [1.0 if name == chosen else 0.0 for name in names]
        return {"lora": [{"id": place, "scale": scale} for place, scale in enumerate(scales)]}

    taught = {name: Variant(f"{name} {_digest(adapters[name])}", request(name)) for name in names}
    return {"": Variant("", request("")), **taught}


def _digest(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()[:16]


def server_version() -> str:
    """Return what evaluates prompts here, and which version of it."""
    return f"xllamacpp {version('xllamacpp')}"


def has_chat_template(path: Path) -> bool:
    """Whether a GGUF file says how a chat with its model is written."""
    # asked for a template, llama.cpp gives a default where the file has none
    if not path.is_file():
        return False
    with path.open("rb") as file:
        return b"tokenizer.chat_template" in file.read(1 << 25)


def processors() -> int:
    """Return how many threads a model uses here unless told otherwise."""
    usable = getattr(os, "sched_getaffinity", None)
    return min(8, len(usable(0)) if usable else os.cpu_count() or 1)
