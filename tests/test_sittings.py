"""Sittings: the database is the truth, and nobody sees another's."""

import threading

import pytest

from reibench.errors import ReibenchError, StaleStep, StoreUnavailable, UnknownName, UnknownSkill
from reibench.sittings import Sittings


@pytest.fixture
def sittings(episodes, store, script, solution):
    def open_model(name):
        return script("Heat the potato.", *(f" {skill}" for skill in solution), " done")

    return Sittings(list(episodes.values()), store, open_model)


def test_a_visitor_solves_an_episode_and_finds_it_recorded(sittings, store, solution):
    sitting = sittings.open("ann", "heat_potato.mixed-noised")
    for number, skill in enumerate(solution, start=1):
        sitting = sittings.step(sitting.id, "ann", skill, number, 1.5)
    assert sitting.event.solved
    assert sitting.status is None
    sitting = sittings.done(sitting.id, "ann", len(solution) + 1)
    assert (sitting.status, sitting.phase) == ("success", "over")
    record = store.record(sitting.id)
    assert record.actor == "person"
    assert record.steps[0].seconds == 1.5


def test_a_reload_and_a_restarted_server_continue_where_one_was(
    sittings, episodes, store, solution
):
    sitting = sittings.open("ann", "heat_potato.mixed-noised")
    for number, skill in enumerate(solution[:5], start=1):
        sitting = sittings.step(sitting.id, "ann", skill, number)
    restarted = Sittings(list(episodes.values()), store, lambda name: None)
    again = restarted.current("ann")
    assert again == sitting
    for number, skill in enumerate(solution[5:], start=6):
        again = restarted.step(again.id, "ann", skill, number)
    assert again.event.solved


def test_another_visitors_sitting_is_unknown(sittings):
    sitting = sittings.open("ann", "heat_potato.mixed-noised")
    assert sittings.current("bob") is None
    with pytest.raises(UnknownName, match="No sitting"):
        sittings.step(sitting.id, "bob", "find a potato", 1)
    other = sittings.open("bob", "heat_potato.mixed-noised")
    assert other.id != sitting.id


def test_a_doubled_click_is_applied_once(sittings):
    sitting = sittings.open("ann", "heat_potato.mixed-noised")
    refused = []

    def click():
        try:
            sittings.step(sitting.id, "ann", "find a potato", 1)
        except StaleStep as problem:
            refused.append(problem)

    threads = [threading.Thread(target=click) for _ in range(5)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(sittings.current("ann").steps) == 1
    assert len(refused) == 4


def test_a_wrong_action_shows_its_reason_and_loses_nothing(sittings):
    sitting = sittings.open("ann", "heat_potato.mixed-noised")
    sitting = sittings.step(sitting.id, "ann", "find a potato", 1)
    sitting = sittings.step(sitting.id, "ann", "put down the potato", 2)
    assert sitting.event.message == "the robot is not holding anything"
    assert len(sitting.steps) == 2
    with pytest.raises(UnknownSkill):
        sittings.step(sitting.id, "ann", "dance", 3)
    assert sittings.step(sitting.id, "ann", "pick up the potato", 3).event.success


def test_a_step_that_cannot_be_saved_did_not_happen(sittings, store):
    sitting = sittings.open("ann", "heat_potato.mixed-noised")
    sitting = sittings.step(sitting.id, "ann", "find a potato", 1)
    [pages] = store.query("pragma page_count")
    store.query(f"pragma max_page_count = {pages['page_count']}")
    problem = None
    while problem is None:
        try:
            sitting = sittings.step(sitting.id, "ann", "find a fridge", len(sitting.steps) + 1)
        except StoreUnavailable as refused:
            problem = refused
    assert "full" in str(problem)
    store.query("pragma max_page_count = 1000000")
    kept = sittings.current("ann")
    assert kept == sitting
    after = sittings.step(kept.id, "ann", "find a potato", len(kept.steps) + 1)
    assert after.event.success


def test_the_last_step_of_the_budget_ends_the_episode(sittings):
    sitting = sittings.open("ann", "pick_keys.mixed-short")
    for number in range(1, 31):
        sitting = sittings.step(sitting.id, "ann", "find a sofa", number)
    assert sitting.status == "truncated"
    with pytest.raises(StaleStep):
        sittings.step(sitting.id, "ann", "find a sofa", 31)


def test_starting_afresh_keeps_the_old_record(sittings, store):
    first = sittings.open("ann", "pick_keys.mixed-short")
    sittings.step(first.id, "ann", "find a sofa", 1)
    assert sittings.open("ann", "pick_keys.mixed-short").id == first.id
    second = sittings.open("ann", "pick_keys.mixed-short", afresh=True)
    assert second.id != first.id
    assert second.steps == ()
    assert len(store.entries()) == 2


def test_a_planner_is_watched_step_by_step_and_recorded(sittings, store, solution):
    seen = list(sittings.watch("ann", "heat_potato.mixed-noised", "tocc", "scripted:x"))
    assert [sitting.phase for sitting in seen[:3]] == ["loading model", "restating", "planning"]
    assert [len(sitting.steps) for sitting in seen[2:-1]] == list(range(len(solution) + 1))
    assert (seen[-1].status, seen[-1].phase) == ("success", "over")
    assert seen[-1].instruction.text == "Heat the potato."
    assert store.record(seen[-1].id).status == "success"
    assert sittings.current("ann") is None


def test_watching_stops_when_asked_and_keeps_what_was_seen(sittings, store):
    watching = sittings.watch("ann", "heat_potato.mixed-noised", "tocc", "scripted:x")
    for sitting in watching:
        if len(sitting.steps) == 3:
            sittings.stop("ann")
    assert sitting.phase == "stopped"
    assert store.record(sitting.id).error == "stopped by the visitor"


def test_a_page_that_is_left_closes_its_record(sittings, store):
    watching = sittings.watch("ann", "heat_potato.mixed-noised", "tocc", "scripted:x")
    while len(next(watching).steps) < 2:
        pass
    watching.close()
    [entry] = store.entries()
    assert entry.status == "error"


def test_a_model_that_breaks_is_an_error_in_one_sentence(episodes, store, script):
    sittings = Sittings(list(episodes.values()), store, lambda name: script("ok", " fly"))
    last = list(sittings.watch("ann", "heat_potato.mixed-noised", "tocc", "scripted:x"))[-1]
    assert last.status == "error"
    assert "fly" in last.error


def test_the_solution_solves(sittings):
    skills = sittings.solution("heat_potato.mixed-noised")
    sitting = sittings.open("ann", "heat_potato.mixed-noised")
    for number, skill in enumerate(skills, start=1):
        sitting = sittings.step(sitting.id, "ann", skill.text, number)
    assert sitting.event.solved


def test_an_unknown_episode_is_named(sittings):
    with pytest.raises(ReibenchError, match=r"Did you mean 'pick_keys\.mixed-short'"):
        sittings.open("ann", "pick_keys.mixed-shrt")
