"""Holding servers to options, and reading what they took."""

import pytest

from reibench.backends.constraints import Way, closest, same
from reibench.skill import DONE, SKILLS

OPTIONS = [f"{skill}" for skill in SKILLS] + [DONE]


@pytest.mark.parametrize("way", list(Way), ids=lambda way: way.name)
def test_every_option_is_read_as_itself(way):
    for option in OPTIONS:
        answer = f'{{"choice": "{option}"}}' if way is Way.SCHEMA else option
        assert same(way.said(answer), OPTIONS) == option


@pytest.mark.parametrize(
    ("answer", "option"),
    [
        ("  'Find a Pan.' ", "find a pan"),
        ("DONE", "done"),
        ("find a pan, pick up the pan", ""),
        ("", ""),
        ("…", ""),
    ],
)
def test_case_quotes_and_marks_do_not_matter(answer, option):
    assert same(answer, OPTIONS) == option


@pytest.mark.parametrize(
    ("answer", "option"),
    [
        ("The robot should find a potato now.", "find a potato"),
        ("I'd pick up the soap bar", "pick up the soap bar"),
        ("find a potatoe", "find a potato"),
        ("find a pan or find a pot", ""),
        ("find a pun", ""),
        ("I cannot help with that.", ""),
        ("{}", ""),
    ],
)
def test_only_what_can_mean_one_option_is_taken_for_it(answer, option):
    assert closest(answer, OPTIONS) == option


def test_a_longer_name_is_meant_before_the_shorter_one_in_it():
    assert closest("I take the soap bar", ["soap", "soap bar"]) == "soap bar"
    assert closest("I take the soap", ["soap", "soap bar"]) == "soap"


def test_an_answer_that_is_no_json_or_another_is_left_as_it_is():
    assert Way.SCHEMA.said("find a pan") == "find a pan"
    assert Way.SCHEMA.said('{"option": 1}') == '{"option": 1}'


def test_options_with_quotes_stay_literals_of_the_grammar():
    [rule] = Way.GRAMMAR.holding_to(['say "a\\b"', "b"]).values()
    assert rule == r'root ::= "say \"a\\b\"" | "b"'
