"""Evaluating tokens with a causal model, keeping the last prompts evaluated for those to come."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from inspect import signature
from itertools import takewhile
from typing import Any

from reibench.errors import ReibenchError

CUTTABLE = {"full_attention", "sliding_attention", "chunked_attention"}
"""Layers whose state can be cut back to any length; that of recurrent ones cannot."""


@dataclass
class Kept:
    """A sequence of tokens and the model's state after it."""

    tokens: tuple[int, ...] = ()
    state: Any = None
    used: int = 0
    """When it was last used, in calls."""


@dataclass
class Evaluator:
    """A causal model that evaluates only what is new against the sequences it keeps."""

    model: Any
    slots: int
    evaluated: int = 0
    """Tokens evaluated in all."""
    _kept: list[Kept] = field(default_factory=list)
    _calls: int = 0

    @property
    def longest(self) -> int:
        """Tokens the model was made for, at most; 0 where it does not say."""
        return int(getattr(self._config, "max_position_embeddings", 0) or 0)

    @property
    def _config(self) -> Any:
        return self.model.config.get_text_config()

    def scores(self, tokens: Sequence[int]) -> Any:
        """Return the logits of what follows `tokens`, in one pass over those that are new.

        Returns:
            float32, one for each token of the vocabulary, on the model's device.

        Raises:
            ReibenchError: when there are more than the model was made for.
        """
        import torch

        if self.longest and len(tokens) > self.longest:
            raise ReibenchError(
                f"A prompt of {len(tokens)} tokens exceeds the available context of this model,"
                f" which is {self.longest} tokens."
            )
        kept = self._nearest(tuple(tokens))
        new = list(tokens[len(kept.tokens) :])
        # recurrent layers go on from a state one token at a time
        passes = [new] if self._cuttable or not kept.tokens else [[token] for token in new]
        kept.tokens = ()  # until it has gone well
        state = {self._state_is_called: kept.state} if self._state_is_called else {}
        with torch.inference_mode():
            for part in passes:
                fresh = torch.tensor([part], device=self.model.device)
                answer = self.model(fresh, **state, use_cache=bool(state), logits_to_keep=1)
        kept.tokens = tuple(tokens) if state else ()
        self.evaluated += len(new)
        return answer.logits[0, -1].float()

    def _nearest(self, tokens: tuple[int, ...]) -> Kept:
        """Return a kept sequence that is cut back to a beginning of `tokens`, leaving one to do."""
        self._calls += 1
        shared = [min(_common(kept.tokens, tokens), len(tokens) - 1) for kept in self._kept]
        best = max(range(len(shared)), key=lambda n: shared[n], default=-1)
        # a sequence most of which would be lost stays, and what is shared is copied from it
        if best >= 0 and 2 * shared[best] >= len(self._kept[best].tokens):
            kept, length = self._kept[best], shared[best]
        else:
            kept, length = self._copy(best, shared[best] if shared else 0)
        self._cut(kept, length)
        kept.used = self._calls
        return kept

    def _copy(self, number: int, length: int) -> tuple[Kept, int]:
        """Return a new sequence that starts as the kept one, in place of that unused longest."""
        copied = Kept()
        if length and self._cuttable:
            source = self._kept[number]
            copied = Kept(source.tokens[:length], self._fresh())
            for layer, kept in enumerate(source.state.layers):
                keys, values = kept.keys[..., :length, :], kept.values[..., :length, :]
                copied.state.update(keys.clone(), values.clone(), layer)
        if len(self._kept) >= self.slots:
            self._kept.remove(min(self._kept, key=lambda kept: kept.used))
        self._kept.append(copied)
        return copied, len(copied.tokens)

    def _cut(self, kept: Kept, length: int) -> None:
        extra = len(kept.tokens) - length
        if not length or (extra and not self._cuttable):
            kept.tokens, kept.state = (), self._fresh()
        elif extra:
            kept.state.crop(-extra)
            kept.tokens = kept.tokens[:length]

    @cached_property
    def _state_is_called(self) -> str:
        """What the model calls its state among its arguments; nothing if it takes none."""
        taken = signature(self.model.forward).parameters
        return next((name for name in ("past_key_values", "cache_params") if name in taken), "")

    @cached_property
    def _cuttable(self) -> bool:
        layers = set(getattr(self._config, "layer_types", None) or CUTTABLE)
        stateful = getattr(self.model, "_is_stateful", False)
        return layers <= CUTTABLE and not stateful and self._state_is_called == "past_key_values"

    def _fresh(self) -> Any:
        from transformers import DynamicCache

        # told of sliding windows it would forget what lies before them, and could not be cut
        return DynamicCache() if self._cuttable else DynamicCache(config=self._config)


def _common(one: Sequence[int], other: Sequence[int]) -> int:
    """Return how many tokens both begin with."""
    pairs = zip(one, other, strict=False)
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))
