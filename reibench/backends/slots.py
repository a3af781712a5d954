"""llama.cpp's slots: each keeps one prompt prefix evaluated, taken from disk if it is there."""

import logging
from collections import OrderedDict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any
from urllib.error import HTTPError

from reibench.backends.prefixes import Prefixes

WORTH = 64
"""Tokens from which on a prefix is evaluated apart and kept on disk."""

Ask = Callable[[Mapping[str, object]], Mapping[str, Any]]
"""A completion by llama.cpp."""
Post = Callable[[str, Mapping[str, object]], Mapping[str, Any]]
"""A call over llama.cpp's HTTP API: path and content."""


@dataclass(frozen=True)
class Variant:
    """A model with or without one of its adapters."""

    name: str = ""
    """What tells its adapter from any other, contents included; nothing without."""
    request: Mapping[str, object] = field(default_factory=dict)
    """What a request to llama.cpp says of it."""


PLAIN = Variant()

log = logging.getLogger(__name__)


class Slots:
    """Which slot keeps which prefix; the one unused longest makes room for another."""

    def __init__(self, count: int, ask: Ask, post: Post, prefixes: Prefixes | None) -> None:
        """Start with `count` empty slots; without `prefixes` nothing is kept on disk."""
        self._slot_of: OrderedDict[str, int] = OrderedDict((f"\0{n}", n) for n in range(count))
        self._ask, self._post, self._prefixes = ask, post, prefixes

    def place(
        self, prefix: str, tokens: Callable[[], Sequence[int]], *, variant: Variant = PLAIN
    ) -> tuple[int, int]:
        """Return the slot that has `prefix` and how many tokens had to be evaluated for it now.

        Args:
            prefix: what many prompts begin with.
            tokens: gives those that `prefix` has in a prompt; asked only where they are needed.
            variant: which of the models it is evaluated by; the same text by another is another.
        """
        evaluated = 0
        name = f"{variant.name}\0{prefix}" if variant.name else prefix
        if name not in self._slot_of:
            _, slot = self._slot_of.popitem(last=False)
            evaluated = self._bring(name, tokens(), slot, variant) if prefix else 0
            self._slot_of[name] = slot
        self._slot_of.move_to_end(name)
        return self._slot_of[name], evaluated

    def _bring(self, prefix: str, tokens: Sequence[int], slot: int, variant: Variant) -> int:
        """Have `prefix` evaluated in `slot`, by itself, so that what is kept holds nothing else."""
        if self._prefixes is None or len(tokens) < WORTH:
            return 0
        request: dict[str, object] = {**variant.request, "id_slot": slot, "cache_prompt": True}
        if variant.request:
            # a slot whose adapter changes forgets what it has, so it changes before that is there
            self._ask(request | {"prompt": list(tokens[:1]), "n_predict": 0})
        if self._restored(self._prefixes, prefix, slot):
            return 0
        usage = self._ask(request | {"prompt": list(tokens), "n_predict": 0})["usage"]
        self._save(self._prefixes, prefix, slot)
        cached: int = usage["prompt_tokens_details"]["cached_tokens"]
        return int(usage["prompt_tokens"]) - cached

    def _restored(self, prefixes: Prefixes, prefix: str, slot: int) -> bool:
        name = ""
        try:
            if name := prefixes.find(prefix):
                self._post(f"/slots/{slot}?action=restore", {"filename": name})
        except HTTPError as error:
            log.warning("llama.cpp cannot use %s and it is made anew: %s", name, _reason(error))
            prefixes.drop(name)
            return False
        except OSError as error:
            log.warning("a prefix kept in %s cannot be read: %s", prefixes.where, error)
            return False
        return bool(name)

    def _save(self, prefixes: Prefixes, prefix: str, slot: int) -> None:
        try:
            written = self._post(f"/slots/{slot}?action=save", {"filename": prefixes.part(prefix)})
            prefixes.keep(prefix, written["n_written"])
        except HTTPError as error:
            log.warning("a prefix cannot be kept in %s: %s", prefixes.where, _reason(error))
        except OSError as error:
            log.warning("a prefix cannot be kept in %s: %s", prefixes.where, error)


def _reason(error: HTTPError) -> str:
    return error.read().decode(errors="replace")
