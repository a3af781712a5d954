"""Failures of a real model, labelled by reading before it was looked up what the program says."""

import json
from pathlib import Path

import pytest

from reibench.explanation import explain
from reibench.faults import fault_kind
from reibench.verdict import error_kind

LABELLED = Path(__file__).with_name("labelled.jsonl")
"""Each with its skills, and what the reader says of it and why."""
BUDGET = 30


@pytest.fixture(scope="module")
def labelled():
    return [json.loads(line) for line in LABELLED.read_text(encoding="utf-8").splitlines()]


@pytest.fixture
def judged(labelled, shipped, click):
    """Play each again, and return it with what the program says."""
    known = {episode.id: episode for episode in shipped}
    found = []
    for one in labelled:
        rollout = click(known[one["episode"]], *one["skills"], max_steps=BUDGET)
        if one["done"]:
            rollout.finish()
        record = rollout.record("again", "person")
        assert record.status in ("failure", "truncated"), one
        found.append((one, error_kind(record), fault_kind(record), explain(record)))
    return found


def test_there_are_enough_of_them_and_of_each_kind(labelled):
    assert len(labelled) >= 30
    assert len({(one["episode"], *one["skills"]) for one in labelled}) == len(labelled)
    assert len({one["kind"] for one in labelled}) >= 5


def test_the_program_agrees_with_the_reader_on_the_papers_two_kinds(judged):
    apart = [one for one, error, *_ in judged if one["error"] != error]
    assert len(apart) <= 0.05 * len(judged), apart


def test_the_program_agrees_with_the_reader_on_the_finer_kind(judged):
    apart = [(one["episode"], kind) for one, _, kind, _ in judged if one["kind"] != kind]
    assert len(apart) <= 0.05 * len(judged), apart


def test_the_sentence_about_each_is_the_one_that_was_read_and_found_right(judged):
    apart = [(one["sentence"], said) for one, _, _, said in judged if one["sentence"] != said]
    assert len(judged) >= 30
    assert not apart
