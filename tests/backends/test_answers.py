"""Reading answers, and what else was likely."""

from math import log

import pytest

from reibench.backends.answers import alternatives, read_answer

THINGS = {"a cat": " a cat", "a car": " a car", "the cat": " the cat", "the dog": " the dog"}


def answered(*places):
    """Make the body of a chat answer; each place is its likely tokens, the taken one first."""
    content = [
        {
            "token": next(iter(place)),
            "logprob": log(next(iter(place.values()))),
            "top_logprobs": [{"token": text, "logprob": log(p)} for text, p in place.items()],
        }
        for place in places
    ]
    text = "".join(one["token"] for one in content)
    return {"choices": [{"message": {"content": text}, "logprobs": {"content": content}}]}


def listed(body, chosen):
    found = alternatives(read_answer(body, 0.0), chosen, THINGS)
    return {one.text: pytest.approx(one.probability) for one in found}


def test_options_share_the_probability_of_the_tokens_that_lead_to_them():
    body = answered({"a": 0.3, "the": 0.1, "Hello": 0.6}, {" cat": 0.2, " car": 0.2, " cow": 0.6})
    assert listed(body, "a cat") == {" a cat": 0.375, " a car": 0.375}


def test_a_token_that_leads_to_one_option_only_stands_for_it():
    body = answered({"the": 0.4, "a": 0.4, "a car": 0.2}, {" dog": 0.9, " cat": 0.1})
    assert listed(body, "the dog") == {" the dog": 0.36, " a car": 0.2, " the cat": 0.04}


def test_options_are_found_inside_json():
    body = answered({'{"choice': 1.0}, {'": "': 1.0}, {"a": 1.0}, {" cat": 0.5, " car": 0.5})
    body["choices"][0]["message"]["content"] += '"}'
    content = body["choices"][0]["logprobs"]["content"]
    content.append({"token": '"}', "logprob": 0.0, "top_logprobs": []})
    assert listed(body, "a cat") == {" a cat": 0.5, " a car": 0.5}


def test_the_completions_endpoints_own_form_is_read_too():
    logprobs = {
        "tokens": ["a", " cat"],
        "token_logprobs": [log(0.5), log(0.25)],
        "top_logprobs": [{"the": log(0.5)}, {" car": log(0.75)}],
    }
    body = {"choices": [{"text": "a cat", "logprobs": logprobs}]}
    assert listed(body, "a cat") == {" a car": 0.375, " a cat": 0.125}


def test_without_probabilities_there_are_no_alternatives():
    assert listed({"choices": [{"text": "a cat", "logprobs": None}]}, "a cat") == {}


def test_tokens_and_those_cached_are_counted():
    usage = {
        "prompt_tokens": 90,
        "completion_tokens": 4,
        "prompt_tokens_details": {"cached_tokens": 64},
    }
    read = read_answer({"choices": [{"text": "x"}], "usage": usage}, 1.5).usage
    assert (read.prompt_tokens, read.cached_tokens, read.completion_tokens) == (90, 64, 4)
    assert read.seconds == 1.5


@pytest.mark.parametrize("body", [None, [], {}, {"choices": []}, {"choices": [{}]}, "text"])
def test_half_an_answer_is_none(body):
    with pytest.raises(ValueError, match="no whole answer"):
        read_answer(body, 0.0)
