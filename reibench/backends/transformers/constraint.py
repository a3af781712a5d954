"""Keeping a continuation within a GBNF grammar, by llguidance."""

from typing import Any

from reibench.errors import ReibenchError

ALLOWED = 200
"""What llguidance gives a token that may follow."""


class Constraint:
    """One continuation within a grammar, token by token."""

    def __init__(self, grammar: str, tokenizer: Any) -> None:
        """Read `grammar`; `tokenizer` is llguidance's.

        Raises:
            ReibenchError: when it is no GBNF grammar.
        """
        import llguidance

        try:
            read = llguidance.grammar_from("gbnf", grammar)
        except ValueError as error:
            raise _refused(grammar, str(error)) from error
        self._matcher = llguidance.LLMatcher(tokenizer, read, log_level=0)
        if self._matcher.is_error():
            raise _refused(grammar, self._matcher.get_error())

    @property
    def over(self) -> bool:
        """Whether nothing can follow any more."""
        return bool(self._matcher.is_stopped())

    def allow(self, scores: Any) -> Any:
        """Return `scores` with those of tokens that may not follow at minus infinity."""
        import torch

        bias = torch.frombuffer(bytearray(self._matcher.compute_logit_bias()), dtype=torch.uint8)
        allowed = torch.zeros(len(scores), dtype=torch.bool)
        allowed[: len(bias)] = bias[: len(scores)] == ALLOWED
        return scores.masked_fill(~allowed.to(scores.device), float("-inf"))

    def take(self, token: int) -> None:
        """Go on with `token`."""
        self._matcher.consume_token(token)


def _refused(grammar: str, reason: str) -> ReibenchError:
    first = (reason.strip().splitlines() or ["no reason given"])[0]
    return ReibenchError(
        f"{grammar[:60]!r} is no grammar ({first}); it should be GBNF, like"
        """ 'root ::= " yes" | " no"'."""
    )


def guidance_tokenizer(tokenizer: Any, vocabulary: int) -> Any:
    """Return llguidance's view of a transformers tokenizer; takes about a second.

    Raises:
        ReibenchError: when it is of a kind llguidance cannot read.
    """
    from llguidance.hf import from_tokenizer

    try:
        return from_tokenizer(tokenizer, n_vocab=max(vocabulary, len(tokenizer)))
    except ValueError as error:
        raise ReibenchError(
            f"A grammar cannot be kept with a tokenizer of the kind {type(tokenizer).__name__}"
            " (llguidance reads those of the tokenizers library); ask without one, or use a"
            " llama-cpp: model."
        ) from error
