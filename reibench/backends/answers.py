"""Answers of OpenAI-compatible servers: their text, tokens and cost, and what else was likely."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import exp
from typing import Any

from reibench.backends import Alternative, Usage

MOST = 5
"""Alternatives listed."""


@dataclass(frozen=True)
class Token:
    """A token of an answer and what could have stood in its place."""

    text: str
    logprobs: Mapping[str, float] = field(default_factory=dict)
    """Of the likeliest tokens there and of itself; before or after a constraint, as it may be."""


@dataclass(frozen=True)
class Answer:
    """What a server answered."""

    text: str
    usage: Usage = Usage()
    """Without dollars."""
    tokens: tuple[Token, ...] = ()
    """Empty where the server gives no probabilities."""


def read_answer(content: Any, seconds: float) -> Answer:
    """Read the body of an answer of either endpoint; raises ValueError when it is incomplete."""
    try:
        choice = content["choices"][0]
        text = choice["message"]["content"] if "message" in choice else choice["text"]
        usage = content.get("usage") or {}
        details = usage.get("prompt_tokens_details") or {}
        cost = Usage(
            prompt_tokens=usage.get("prompt_tokens") or 0,
            cached_tokens=details.get("cached_tokens") or 0,
            completion_tokens=usage.get("completion_tokens") or 0,
            seconds=seconds,
        )
        return Answer(text or "", cost, _tokens(choice.get("logprobs") or {}))
    except (KeyError, IndexError, TypeError, AttributeError) as error:
        raise ValueError(f"no whole answer: {error!r} is missing or of the wrong kind") from error


def _tokens(logprobs: Mapping[str, Any]) -> tuple[Token, ...]:
    if logprobs.get("content"):  # of the chat endpoint, and of llama.cpp's both
        return tuple(
            Token(one["token"], _likely(one) | {one["token"]: one["logprob"]})
            for one in logprobs["content"]
        )
    if not logprobs.get("tokens") or not logprobs.get("top_logprobs"):
        return ()
    columns = (logprobs["tokens"], logprobs["token_logprobs"], logprobs["top_logprobs"])
    return tuple(
        Token(token, dict(top or {}) | {token: own})
        for token, own, top in zip(*columns, strict=True)
    )


def _likely(token: Mapping[str, Any]) -> dict[str, float]:
    return {other["token"]: other["logprob"] for other in token.get("top_logprobs") or ()}


def alternatives(answer: Answer, written: str, options: Mapping[str, str]) -> list[Alternative]:
    """Return the likeliest options by the probabilities of the answer's tokens, likeliest first.

    At each token, those that lead on to an option share all of the probability; an option parted
    from is listed where one token decided for it. So the chosen one is always listed.

    Args:
        answer: the model's answer.
        written: how the chosen option stands in the answer's text.
        options: every option, by how it would stand there.
    """
    start = answer.text.find(written)
    if start < 0 or "".join(token.text for token in answer.tokens) != answer.text:
        return []
    head = answer.text[:start]
    wanted = {head + text: option for text, option in options.items()}
    found: dict[str, float] = {}
    done, share = "", 1.0
    for token in answer.tokens:
        shares = _shares(token, done, list(wanted))
        for text, part in shares.items():
            fits = [one for one in wanted if _leads(done + text, one)]
            if text != token.text and len(fits) == 1:
                found[wanted[fits[0]]] = found.get(wanted[fits[0]], 0.0) + share * part
        share *= shares.get(token.text, 1.0)
        done += token.text
        if len(done) >= len(head + written):
            break
    found[options[written]] = share
    ranked = sorted(found, key=lambda option: -found[option])
    kept = [one for one in ranked if one != options[written]][: MOST - 1]
    return [
        Alternative(one, found[one]) for one in ranked if one in kept or one == options[written]
    ]


def _shares(token: Token, done: str, wanted: Sequence[str]) -> dict[str, float]:
    """Return how probable each token is that leads on to something wanted."""
    weights = {
        text: exp(logprob)
        for text, logprob in token.logprobs.items()
        if text and any(_leads(done + text, one) for one in wanted)
    }
    total = sum(weights.values())
    return {text: weight / total for text, weight in weights.items()} if total else {}


def _leads(text: str, wanted: str) -> bool:
    return wanted.startswith(text) or text.startswith(wanted)
