"""Selecting a skill as the published code does: guidance over a transformers model."""

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

NEEDED = ("guidance", "gguf", "torch", "transformers")


def missing() -> str:
    """Return in one sentence what keeps the published way from being measured, or nothing."""
    absent = [name for name in NEEDED if find_spec(name) is None]
    if not absent:
        return ""
    return (
        f"The published way was not measured: {', '.join(absent)} cannot be imported here; install"
        " it with 'pip install -r tests/requirements.txt'."
    )


def versions() -> str:
    """Return what the published way was measured with."""
    return ", ".join(f"{name} {version(name)}" for name in NEEDED if name != "gguf") + ", float32"


@dataclass(frozen=True)
class Chosen:
    """A skill selected, and what it cost."""

    text: str
    seconds: float
    processor_seconds: float
    """Seconds of processor time, all threads together."""
    evaluated: int
    """Tokens evaluated."""


class Rewinding:
    """A transformers model as guidance calls it, whose evaluated tokens can be taken back.

    guidance 0.3.1 tells a cache how many tokens to keep, transformers 5 expects how many to
    remove, and windowed layers remove none at all; so each new prompt would be an error. The state
    given here keeps all tokens in all layers, which attend to the same ones as ever.
    """

    def __init__(self, model: Any) -> None:
        self.config, self.device = model.config, model.device
        self.evaluated = 0
        """Tokens evaluated in all."""
        self._model = model
        self._state = _state_by_length()

    def __call__(self, *, past_key_values: Any, input_ids: Any, **arguments: Any) -> Any:
        """Evaluate `input_ids`, of shape (1, tokens)."""
        state = self._state() if past_key_values is None else past_key_values
        self.evaluated += input_ids.shape[1]
        return self._model(input_ids=input_ids, past_key_values=state, **arguments)


class Published:
    """A loop over `guidance.select`, which keeps the last prompt evaluated."""

    def __init__(self, model: Any, tokenizer: Any) -> None:
        """Ask a transformers model; `load` gives both."""
        from guidance import models

        self._model = Rewinding(model)
        as_model: Any = self._model
        self._start = models.Transformers(as_model, tokenizer, echo=False, enable_monitoring=False)

    def choose(self, text: str, options: Sequence[str]) -> Chosen:
        """Return the option that guidance selects after `text`."""
        from guidance import select

        before, started, used = self._model.evaluated, perf_counter(), process_time()
        answer = self._start + text + select(list(options), name="step")
        chosen: str = answer["step"]
        seconds, used = perf_counter() - started, process_time() - used
        return Chosen(chosen, seconds, used, self._model.evaluated - before)


def load(path: Path, threads: int) -> Published:
    """Load the GGUF file `path`, which is taken out of its quantisation: a minute or so."""
    import torch
    import transformers

    torch.set_num_threads(threads)
    library: Any = transformers
    library.utils.logging.disable_progress_bar()
    where: Any = {"pretrained_model_name_or_path": path.parent, "gguf_file": path.name}
    tokenizer = library.AutoTokenizer.from_pretrained(**where)
    model = library.AutoModelForCausalLM.from_pretrained(**where, dtype=torch.float32)
    return Published(model.eval(), tokenizer)


def _state_by_length() -> Any:
    """Return the kind of state whose `crop` is told how many tokens to keep."""
    from transformers import DynamicCache

    class State(DynamicCache):  # type: ignore[misc]
        def crop(self, length: int) -> None:
            super().crop(min(0, length - self.get_seq_length()))

    return State
