"""Records make up cases, and the table follows the database."""

import sqlite3
from time import monotonic, sleep

from reibench.cases import table as tables
from reibench.cases.table import CaseTable, cases_of
from tests.cases.conftest import PERSON, SPEC, TOLD


def kinds(table):
    return list(table.now().cases["kind"])


def test_a_plain_run_a_told_one_and_a_person_make_one_case(table, helped):
    cases = table.now().cases
    assert len(cases) == 1
    case = cases.iloc[0]
    assert case["kind"] == "helps"
    assert {case[f"{lane}_id"] for lane in helped} == {record.id for record in helped.values()}
    assert case["title"].startswith("Put a heated potato")
    assert (case["meant"], case["plain_taken"], case["told_taken"]) == ("Potato", "Apple", "Potato")
    assert "was taken for an apple" in case["plain_reason"]


def test_the_most_telling_cases_come_first(table, helped, play, episodes):
    other = episodes["pick_keys.mixed-short"]
    play(other, SPEC, "find a sofa")
    play(other, TOLD, "find a sofa")
    alone = episodes["pick_keys.implicit-short"]
    play(alone, SPEC, "find a sofa")
    play(alone, PERSON, "find a sofa", origin="demo", visitor="ben")
    assert kinds(table) == ["helps", "same", "single"]


def test_a_method_that_breaks_what_worked_hurts_and_people_may_do_what_no_planner_did(
    table, play, episode, episodes, solution
):
    play(episode, SPEC, *solution)
    play(episode, TOLD, "find an apple")
    keys = episodes["heat_potato.implicit-short"]
    play(keys, SPEC, "find an apple")
    play(keys, PERSON, *solution, origin="demo", visitor="ann")
    assert sorted(kinds(table)) == ["hurts", "people"]


def test_the_latest_of_several_runs_counts(table, play, episode, solution):
    play(episode, PERSON, "find a sofa", origin="demo", visitor="ann")
    last = play(episode, PERSON, *solution, origin="demo", visitor="ben")
    assert list(table.now().cases["person_id"]) == [last.id]


def test_the_table_takes_up_what_is_new_and_drops_what_is_gone(
    table, store, helped, play, episodes
):
    assert len(table.now().records) == 3
    record = play(episodes["pick_keys.mixed-short"], SPEC, "find a sofa")
    assert len(table.now().records) == 4
    with store.writing() as database:
        store.forget(database, [record.id])
    assert len(table.now().records) == 3
    assert len(table.now().cases) == 1


def test_what_is_made_little_by_little_is_what_is_made_at_once(
    table, store, helped, play, episodes
):
    table.now()
    play(episodes["pick_keys.mixed-short"], SPEC, "find a sofa")
    bit_by_bit, at_once = table.now(), CaseTable(store).now()
    assert bit_by_bit.cases.equals(at_once.cases)


def test_participants_are_only_for_researchers_and_practice_for_nobody(
    store, helped, play, episodes
):
    trial = play(
        episodes["pick_keys.mixed-short"], PERSON, "find a sofa", origin="study", visitor="P1"
    )
    practice = play(
        episodes["pick_keys.implicit-short"], PERSON, "find a sofa", origin="study", visitor="P1"
    )
    table = CaseTable(store, lambda: {practice.id}).now()
    assert trial.id in set(table.cases["person_id"])
    assert practice.id not in set(table.cases["person_id"])
    assert set(table.public["person_id"]) == {helped["person"].id}


def test_who_is_rejected_or_restored_leaves_and_returns_at_the_next_request(store, play, episodes):
    trial = play(
        episodes["pick_keys.mixed-short"], PERSON, "find a sofa", origin="study", visitor="P1"
    )
    rejected = set()
    table = CaseTable(store, lambda: rejected)
    assert list(table.now().cases["person_id"]) == [trial.id]
    rejected.add(trial.id)
    assert len(table.now().cases) == 0
    assert table.now().hidden == {trial.id}
    rejected.clear()
    assert list(table.now().cases["person_id"]) == [trial.id]


def test_a_rejection_is_not_waited_for_even_in_a_large_table(store, play, episodes, monkeypatch):
    monkeypatch.setattr(tables, "LARGE", 0)
    trial = play(
        episodes["pick_keys.mixed-short"], PERSON, "find a sofa", origin="study", visitor="P1"
    )
    rejected = set()
    table = CaseTable(store, lambda: rejected)
    table.now()
    rejected.add(trial.id)
    assert len(table.now().cases) == 0


def test_what_is_hidden_but_not_finished_gives_nobody_anything_to_wait_for(table, store, helped):
    hidden = set()
    table = CaseTable(store, lambda: hidden)
    before = table.now()
    hidden.add("begun a moment ago")
    assert table.now() is before


def test_old_records_are_judged_when_they_are_first_listed(table, store, helped):
    with sqlite3.connect(store.path) as database:
        database.execute("update records set reason = null, taken = null")
    [case] = table.now().cases.to_dict("records")
    assert "was taken for an apple" in case["plain_reason"]


def test_nobody_waits_for_a_large_table_to_be_brought_up_to_date(
    table, helped, play, episodes, monkeypatch
):
    monkeypatch.setattr(tables, "LARGE", 0)
    before = table.now()
    play(episodes["pick_keys.mixed-short"], SPEC, "find a sofa")
    assert table.now() is before
    deadline = monotonic() + 20
    while table.now() is before and monotonic() < deadline:
        sleep(0.02)
    assert len(table.now().cases) == 2


def test_an_empty_database_has_no_cases(table):
    empty = table.now()
    assert len(empty.cases) == 0
    assert list(cases_of(empty.records, empty.episodes).columns) == list(empty.cases.columns)
