"""What paid models cost: the price list, and an estimate for a call."""

import re
import tomllib
from dataclasses import dataclass
from datetime import date
from functools import lru_cache
from pathlib import Path

from reibench.backends import Usage

LIST = Path(__file__).parents[2] / "assets" / "prices.toml"


@dataclass(frozen=True)
class Price:
    """Dollars per million tokens."""

    model: str
    input: float
    cached: float
    """Of those of the input that the provider had evaluated before."""
    output: float
    date: date
    """When it was last seen stated."""

    def of(self, usage: Usage) -> float:
        """Return the dollars of a call, estimated from its tokens."""
        new = usage.prompt_tokens - usage.cached_tokens
        dollars = new * self.input + usage.cached_tokens * self.cached
        return (dollars + usage.completion_tokens * self.output) / 1e6


@lru_cache(maxsize=1)
def price_list() -> tuple[Price, ...]:
    """Return every known price."""
    entries = tomllib.loads(LIST.read_text(encoding="utf-8"))["price"]
    return tuple(Price(**entry) for entry in entries)


def price_of(model: str) -> Price | None:
    """Return the price of `model`; a dated release costs what its model does, unless listed."""
    known = {price.model: price for price in price_list()}
    return known.get(model) or known.get(re.sub(r"-\d{4}-\d{2}-\d{2}$", "", model))
