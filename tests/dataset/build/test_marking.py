"""Marking: where names stand, and what another text says in their place."""

import pytest

from reibench.dataset.build.asking import Unfit
from reibench.dataset.build.marking import named_mentions, replaced, stray_pronoun

POTATO = [("object", "Potato"), ("destination", "DiningTable")]
PAIR = [("object", "Pencil"), ("movable", "Mug"), ("destination", "Shelf")]


def spans(text, things=POTATO):
    return [(mark.text, mark.of) for mark in named_mentions(text, things)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Heat the potato.", [("the potato", "object")]),
        ("A nice hot potato on the dining table", [
            ("A nice hot potato", "object"),
            ("the dining table", "destination"),
        ]),
        ("Potatoes are cheap.", [("Potatoes", "object")]),
        ("I put the butter on my spud.", [("my spud", "object")]),
        ("A couch potato-like man", []),
        ("The one with potato", [("potato", "object")]),
    ],
)  # fmt: skip
def test_a_mention_takes_its_article_and_adjectives_along(text, expected):
    assert spans(text) == expected


def test_two_task_objects_are_told_apart():
    text = "Stand the pencil in my coffee mug and put the mug on the shelf."
    assert [of for _, of in spans(text, PAIR)] == ["object", "movable", "movable", "destination"]


def test_what_stands_in_place_of_each_mention_is_found():
    text = "Heat the potato, and put the potato on the dining table."
    marks = named_mentions(text, POTATO)
    vague = "Heat that lumpy thing, and put it on the dining table."
    assert replaced(text, marks, vague, POTATO) == ["that lumpy thing", "it"]


def test_an_article_that_stays_belongs_to_the_new_words():
    text = "Heat the potato on the dining table."
    marks = named_mentions(text, POTATO)
    vague = "Heat the starchy one on the dining table."
    assert replaced(text, marks, vague, POTATO) == ["the starchy one"]


@pytest.mark.parametrize(
    ("vague", "reason"),
    [
        ("Warm it on the dining table.", "changes more than the expressions"),
        ("Heat my potato on the dining table.", "still named"),
    ],
)
def test_anything_else_that_changes_is_refused(vague, reason):
    text = "Heat the potato on the dining table."
    with pytest.raises(Unfit) as caught:
        replaced(text, named_mentions(text, POTATO), vague, POTATO)
    assert caught.value.reason == reason


@pytest.mark.parametrize(
    ("text", "pronoun"),
    [
        ("The potato is big, and it is hot.", "it"),
        ("The potatoes are big, so heat them.", "them"),
        ("It is raining, and the potato is hot.", ""),
        ("The potato stays hot by itself.", ""),
        ("The potato is hot, and they are late.", ""),
    ],
)
def test_pronouns_that_may_stand_for_the_thing_are_seen(text, pronoun):
    assert stray_pronoun(text, named_mentions(text, POTATO), POTATO) == pronoun
