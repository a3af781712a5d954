"""The paper's numbers as data."""

import pytest

from reibench.dialogue import LEVELS
from reibench.published import (
    ERRORS,
    published_costs,
    published_errors,
    published_numbers,
    published_success,
)


def test_every_cell_of_the_tables_is_there():
    counts: dict[str, int] = {}
    for number in published_numbers():
        counts[number.table] = counts.get(number.table, 0) + 1
    assert counts == {
        "error_rate_on_different_models": 3 * 3 * 3,
        "error_rate_on_prompting_methods": 6 * 3 * 3,
        "appendix_error_rate_on_different_models": 3 * 9 * 3,
        "appendix_error_rate_on_prompting_methods": 6 * 9 * 3,
        "token_latency": 8 * 4,
        "text": 9,
    }


@pytest.mark.parametrize("method", ["none", "ap", "cot", "icl", "tocc", "no-context"])
def test_the_two_kinds_add_up_to_the_overall_error_in_every_row(method):
    for level in LEVELS:
        rows: dict[tuple[str, str], dict[str, float]] = {}
        for number in published_errors(method, *level):
            rows.setdefault((number.table, number.row), {})[number.metric] = number.value
        assert rows
        for row in rows.values():
            assert set(row) == set(ERRORS)
            total = row["object_omission"] + row["execution_error"]
            assert total == pytest.approx(row["overall_error"], abs=0.1001)


def test_success_follows_from_the_overall_error_and_contradictions_are_kept():
    assert published_success("tocc", "explicit", "standard") == {"LLaMA3.1-8B": (59.0,)}
    assert published_success("ap", "explicit", "standard") == {"LLaMA3.1-8B": (46.8, 40.0)}
    assert set(published_success("none", "mixed", "short")) == {
        "GPT-4o-mini", "LLaMA3.1-8B", "Deepseek-8B",
    }  # fmt: skip


def test_the_text_s_success_rates_agree_with_the_tables():
    said = {n.method: n.value for n in published_numbers() if n.metric == "success"}
    for method, value in said.items():
        assert published_success(method, "explicit", "standard")["LLaMA3.1-8B"] == (value,)
    assert set(said) == {"none", "no-context"}


def test_costs_are_those_of_the_token_table():
    assert published_costs("short-cot") == {
        "input_tokens": 3464, "output_tokens": 82, "total_tokens": 3546, "latency_ms": 705.64,
    }  # fmt: skip
    assert published_costs("tocc-span") == {}


def test_a_row_keeps_its_table_and_label():
    [first, *_] = published_errors("no-context", "mixed", "noised")
    assert (first.row, first.place) == ("- Context", "appendix, methods")
