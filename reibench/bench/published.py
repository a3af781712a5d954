"""Selecting a skill as the published code does: guidance over a transformers model."""

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from importlib.util import find_spec
from time import perf_counter, process_time
from typing import Any

from reibench.backends.transformers.loading import load as load_checkpoint
from reibench.backends.transformers.source import parse_source

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

    As they come, guidance 0.3.1 fails at the second prompt: it tells a state how many tokens to
    keep, transformers 5 expects how many to remove, and a windowed layer that is full removes none
    at all. The state given here keeps all tokens in all layers, which attend to the same as ever.
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
    """A loop over `guidance.select`."""

    def __init__(self, model: Any, tokenizer: Any) -> None:
        """Ask a transformers model; `load` gives both."""
        self._model, self._tokenizer = model, tokenizer
        self._kept = self._opened()

    def choose(self, text: str, options: Sequence[str]) -> Chosen:
        """Return the option selected after `text`, what the last prompt shares with it kept."""
        return _select(*self._kept, text, options)

    def choose_afresh(self, text: str, options: Sequence[str]) -> Chosen:
        """Return the option selected after `text`, nothing kept; opening is not counted."""
        return _select(*self._opened(), text, options)

    def _opened(self) -> tuple[Rewinding, Any]:
        from guidance import models

        model: Any = Rewinding(self._model)
        tokenizer = self._tokenizer
        return model, models.Transformers(model, tokenizer, echo=False, enable_monitoring=False)


def _select(model: Rewinding, start: Any, text: str, options: Sequence[str]) -> Chosen:
    from guidance import select

    before, started, used = model.evaluated, perf_counter(), process_time()
    answer = start + text + select(list(options), name="step")
    chosen: str = answer["step"]
    seconds, used = perf_counter() - started, process_time() - used
    return Chosen(chosen, seconds, used, model.evaluated - before)


def load(name: str, threads: int) -> Published:
    """Load a model of the shelf, taken out of its quantisation: a minute or so."""
    import torch

    torch.set_num_threads(threads)
    loaded = load_checkpoint(parse_source(f"{name}?device=cpu&dtype=float32"))
    return Published(loaded.model, loaded.tokenizer)


def _state_by_length() -> Any:
    """Return the kind of state whose `crop` is told how many tokens to keep."""
    from transformers import DynamicCache

    class State(DynamicCache):  # type: ignore[misc]
        def crop(self, length: int) -> None:
            super().crop(min(0, length - self.get_seq_length()))

    return State
