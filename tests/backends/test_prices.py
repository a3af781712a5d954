"""What calls of paid models cost."""

from datetime import date

import pytest

from reibench.backends import Usage
from reibench.backends.prices import price_list, price_of


def test_a_call_costs_its_new_cached_and_written_tokens():
    usage = Usage(prompt_tokens=3_000_000, cached_tokens=1_000_000, completion_tokens=500_000)
    assert price_of("gpt-4o-mini").of(usage) == pytest.approx(2 * 0.15 + 0.075 + 0.5 * 0.60)


def test_a_dated_release_costs_what_its_model_does():
    assert price_of("gpt-4o-mini-2024-07-18") == price_of("gpt-4o-mini")


def test_what_is_not_listed_has_no_price():
    assert price_of("gpt-4o-mini-tts") is None
    assert price_of("llama3.2:1b") is None


def test_every_price_is_dated_and_caching_never_makes_it_dearer():
    for price in price_list():
        assert date(2023, 1, 1) < price.date
        assert 0 < price.cached <= price.input <= price.output
