"""Runs of a case stand beside each other, step by step."""

import pytest

from reibench.cases.case import Cases
from reibench.errors import ReibenchError, UnknownName
from reibench.planners import Decision
from reibench.rollout import Rollout
from reibench.skill import parse_skill
from reibench.view.alignment import align, align_many, divides
from tests.cases.conftest import SPEC


def skills(*texts):
    return [parse_skill(text) for text in texts]


def test_two_runs_are_aligned_alike_by_both_ways():
    left = skills("find an apple", "pick up the apple", "find a microwave")
    right = skills("find a tomato", "open the fridge", "pick up the tomato", "find a microwave")
    assert list(align_many([left, right])) == [(r.left, r.right) for r in align(left, right)]


def test_an_extra_step_of_one_of_three_does_not_shift_the_others():
    person = skills("find a tomato", "pick up the tomato", "open the fridge", "pick up the tomato")
    plain = skills("find an apple", "pick up the apple")
    told = skills("find a tomato", "open the fridge", "pick up the tomato")
    rows = align_many([person, plain, told])
    for number, run in enumerate((person, plain, told)):
        assert [row[number] for row in rows if row[number] is not None] == list(range(len(run)))
    assert rows[0] == (0, 0, 0)
    last = rows[-1]
    assert (last[0], last[2]) == (3, 2)
    assert divides(rows[0], [person, plain, told])
    assert not divides((0, None, 0)[:1], [person])


def test_no_run_and_an_empty_one_can_be_aligned():
    assert align_many([]) == ()
    assert align_many([[], skills("find an apple")]) == ((None, 0),)


def test_a_case_knows_where_its_runs_part_and_what_is_done_at_each_row(store, helped):
    case = Cases(store).open([helped["told"].id, helped["plain"].id])
    assert [run.lane for run in case.runs] == ["plain", "told"]
    assert case.split == 0
    assert case.reached(-1, 0) == 0
    assert case.reached(len(case.rows) - 1, 1) == len(helped["told"].steps)
    for lane, run in enumerate(case.runs):
        for step in run.steps:
            assert case.reached(case.row_of(lane, step.number), lane) == step.number
    decisive = case.decisive()
    assert (0, len(helped["plain"].steps)) in decisive
    assert (1, len(helped["told"].steps)) in decisive


def test_what_makes_up_no_case_is_refused_in_a_sentence(store, helped, play, episodes):
    cases = Cases(store)
    other = play(episodes["pick_keys.mixed-short"], SPEC, "find a sofa")
    for ids, words in (
        ([], "one to 3 runs"),
        ([record.id for record in helped.values()] + [other.id], "one to 3 runs"),
        ([helped["plain"].id, other.id], "different episodes"),
    ):
        with pytest.raises(ReibenchError, match=words):
            cases.open(ids)
    with pytest.raises(UnknownName, match="no run 'nonsense'"):
        cases.open(["nonsense"])
    begun = store.begin(SPEC, episodes["pick_keys.implicit-short"])
    with pytest.raises(ReibenchError, match="not over yet"):
        cases.open([begun])


def test_a_run_that_is_tried_again_shows_what_it_did_last(store, episode, world):
    cases, lengths = Cases(store), []
    for skills, error in ((["find an apple"], "the server died"), (["find an apple"] * 3, "")):
        record_id = store.begin(SPEC, episode)
        rollout = Rollout(episode, world)
        store.started(record_id, rollout.start())
        for skill in skills:
            store.add_step(record_id, rollout, rollout.step(Decision(parse_skill(skill))))
        store.finish(record_id, rollout, SPEC.actor, error=error)
        [run] = cases.open([record_id]).runs
        lengths.append((run.record.status == "error", len(run.steps)))
    assert lengths == [(True, 1), (False, 3)]
