"""A filter shows what it says, and beside every choice how many there would be."""

from urllib.parse import parse_qsl

import pytest

from reibench.cases.filtering import CaseFilter, Kept, find
from tests.cases.conftest import SPEC, TOLD


@pytest.fixture
def some(table, helped, play, episodes):
    """Return a table with cases at several levels."""
    for level in ("implicit-short", "implicit-noised", "explicit-standard"):
        episode = episodes[f"pick_keys.{level}"]
        play(episode, SPEC, "find a sofa")
        play(episode, TOLD, "find a key chain", "pick up the key chain")
    return table.now()


def found(table, tags=None, **wanted):
    return find(table.cases, CaseFilter(**wanted), Kept(table.words, tags or {}))


def test_every_count_is_what_choosing_it_would_leave(some):
    for wanted in ({}, {"kind": "same"}, {"level": "implicit-short"}, {"words": "keys"}):
        for name, counts in found(some, **wanted).counts.items():
            for value, count in counts.items():
                chosen = found(some, **{**wanted, name: value})
                assert len(chosen.cases) == count, (wanted, name, value)


def test_people_are_counted_among_the_actors(some):
    assert found(some).counts["planner"] == {"saycan": 4, "person": 1}
    assert found(some, planner="saycan").counts["planner"]["person"] == 1


def test_filters_are_and_levels_are_or(some):
    both = found(some, level="implicit-short,implicit-noised")
    assert set(both.cases["level"]) == {"implicit-short", "implicit-noised"}
    assert len(found(some, level="implicit-short", task_type="look_at_obj_in_light").cases) == 0


def test_words_are_looked_for_in_what_is_said_objects_and_tags(some):
    assert len(found(some, words="POTATO").cases) == 1
    assert len(found(some, words="key chain").cases) == 3
    digest = some.cases["episode_digest"].iloc[0]
    for wanted in ({"words": "odd"}, {"tag": "odd one"}):
        tagged = found(some, {digest: ("odd one",)}, **wanted)
        assert list(tagged.cases["episode_digest"]) == [digest]


def test_a_tag_is_found_however_it_is_written(some):
    digest = some.cases["episode_digest"].iloc[0]
    for words in ("Zebra", "zebra 3", "ZEB"):
        tagged = found(some, {digest: ("Zebra 3",)}, words=words)
        assert list(tagged.cases["episode_digest"]) == [digest], words


def test_what_was_taken_is_looked_for_in_the_run_that_is_asked_about(some):
    for taken, number in (
        ("Potato/Apple", 1), ("Potato/Apple/plain", 1), ("Potato/Apple/told", 0),
        ("Potato/Potato/told", 1), ("Potato/Potato/person", 1), ("Potato/Potato", 0),
        ("KeyChain/", 3), ("KeyChain//told", 0), ("Potato/Apple/nobody", 0),
    ):  # fmt: skip
        assert len(found(some, taken=taken).cases) == number, taken


def test_a_kind_of_failure_of_either_run_is_found(some):
    assert len(found(some, error="object-omission").cases) == 4
    assert len(found(some, error="execution-error").cases) == 3
    assert len(found(some, taken="Potato/Apple").cases) == 1
    assert len(found(some, taken="Potato/Egg").cases) == 0


def test_an_empty_list_says_which_filter_empties_it(some):
    assert found(some, kind="same", words="zebra").emptied_by == "words 0"
    assert found(some, kind="hurts", task_type="").emptied_by == "kind"


def test_the_address_of_a_filter_reads_as_that_filter():
    wanted = CaseFilter(words="a & b", level="implicit-short", kind="helps")
    assert CaseFilter.read(dict(pair.split("=") for pair in ["kind=helps"])) == CaseFilter(
        kind="helps"
    )
    assert CaseFilter.read(dict(parse_qsl(wanted.query()))) == wanted
    assert CaseFilter.read({"nonsense": "x", "words": "y" * 999}).words == "y" * 200


def test_a_level_is_added_and_taken_out_in_the_papers_order():
    one = CaseFilter(level="implicit-short")
    assert one.toggled("explicit-standard") == "explicit-standard,implicit-short"
    assert one.toggled("implicit-short") == ""
