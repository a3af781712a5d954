"""Backends: language models, behind the two calls planners and methods make of them."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from reibench.errors import ModelUnavailable
from reibench.registry import Registry


@dataclass(frozen=True)
class Prompt:
    """What a model is asked to continue."""

    text: str
    fixed: int = 0
    """How many leading characters stay the same from call to call (examples, usually): a backend
    may keep them evaluated."""
    chat: bool = False
    """Whether to ask in the model's chat template, as one user turn, if it has one."""
    begun: str = ""
    """How the answer begins: what is asked for goes on from here."""
    adapter: str = ""
    """Which of the backend's adapters it is written for; nothing is the model as it comes."""


@dataclass(frozen=True)
class Usage:
    """What a call cost."""

    prompt_tokens: int = 0
    cached_tokens: int = 0
    """Those of `prompt_tokens` that did not have to be evaluated."""
    completion_tokens: int = 0
    seconds: float = 0.0
    dollars: float = 0.0
    """Estimate from the price list of a paid model; 0 for those that run here."""

    def __add__(self, other: "Usage") -> "Usage":
        return Usage(
            self.prompt_tokens + other.prompt_tokens,
            self.cached_tokens + other.cached_tokens,
            self.completion_tokens + other.completion_tokens,
            self.seconds + other.seconds,
            self.dollars + other.dollars,
        )


@dataclass(frozen=True)
class Generation:
    """A free continuation."""

    text: str
    usage: Usage = Usage()
    prompt: str = ""
    """What the model was really sent, in its chat template if it was asked in one."""


@dataclass(frozen=True)
class Alternative:
    """An option and how probable the model found it, among the options."""

    text: str
    probability: float


@dataclass(frozen=True)
class Selection:
    """One option chosen."""

    text: str
    usage: Usage = Usage()
    alternatives: tuple[Alternative, ...] = ()
    """The likeliest options with their probabilities, likeliest first, and the chosen one."""
    prompt: str = ""
    """What the model was really sent, in its chat template if it was asked in one."""


class Backend(Protocol):
    """A language model.

    A class whose objects serve several threads at the same time, so that more workers make a run
    faster, says so by `concurrent: ClassVar[bool] = True`; ask with `is_concurrent`. One that does
    not say so may still be asked from any thread, one question after another.
    """

    @property
    def name(self) -> str:
        """What it is called on the command line, e.g. `llama-cpp:gemma-3-270m`."""
        ...

    def generate(
        self, prompt: Prompt, *, max_tokens: int = 128, stop: Sequence[str] = (), grammar: str = ""
    ) -> Generation:
        """Continue `prompt` greedily up to the first of `stop`, within a GBNF `grammar`."""
        ...

    def choose(self, prompt: Prompt, options: Sequence[str]) -> Selection:
        """Return the option that a greedy walk over `options`' tokens takes after `prompt`.

        The options are continuations: each begins where the prompt ends, with its leading space.
        """
        ...

    def close(self) -> None:
        """Free the model."""
        ...


def adapters_of(backend: Backend) -> frozenset[str]:
    """Return the names of the adapters that prompts for `backend` may ask for.

    A class whose objects have some says so by `adapters`; an adapter changes a model for one task,
    which it then does without being shown how.
    """
    return frozenset(getattr(backend, "adapters", ()))


def check_adapter(adapter: str, backend: Backend) -> None:
    """Raise ModelUnavailable if a prompt for `adapter` cannot be put to `backend`."""
    if adapter and adapter not in adapters_of(backend):
        raise ModelUnavailable(
            f"{backend.name} has no adapter {adapter!r}, which this method asks; take a model that"
            " has, for example llama-cpp:gemma-3-270m+planner, or another method."
        )


def is_concurrent(backend: Backend) -> bool:
    """Whether `backend` answers several threads at the same time."""
    return bool(getattr(backend, "concurrent", False))


backends: Registry[Backend] = Registry("backend", __name__)
