"""Arriving at a study: who is taken in, and what they are given to play."""

from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from types import SimpleNamespace

import pytest

from reibench.errors import ReibenchError, UnknownName
from study.designs import designs
from study.enrolment import Closed
from study.pages import TakingPart


def levels_of(enrolment, participant):
    return [one.episode.rpartition(".")[2] for one in enrolment.assignments(participant.code)]


def test_everybody_gets_the_trials_the_study_says_each_of_another_task(enrolment, example):
    enrolment.create(example)
    someone = enrolment.arrive(example.name, {})
    trials = enrolment.assignments(someone.code)
    assert len({one.episode.partition(".")[0] for one in trials}) == example.trials == len(trials)
    assert [one.episode for one in enrolment.assignments(someone.code, "practice")] == list(
        example.practice
    )
    assert someone.stage == "consent"


@pytest.mark.parametrize("design", designs.names())
def test_fifty_who_arrive_at_once_leave_the_levels_even(enrolment, example, design):
    study = replace(example, design=design, trials=5, people=0)
    enrolment.create(study)
    with ThreadPoolExecutor(50) as pool:
        people = list(pool.map(lambda _: enrolment.arrive(study.name, {}), range(50)))
    assert len({one.code for one in people}) == 50
    filled = Counter(level for one in people for level in levels_of(enrolment, one))
    assert filled.total() == 250
    assert len(filled) == 9
    if design != "random":
        assert max(filled.values()) - min(filled.values()) <= 1
        assert sorted(one.slot for one in people) == list(range(50))


def test_a_latin_square_plays_every_task_at_every_level_once(enrolment, example):
    study = replace(example, tasks=12, trials=9, people=0)
    enrolment.create(study)
    people = [enrolment.arrive(study.name, {}) for _ in range(12)]
    played = [one.episode for each in people for one in enrolment.assignments(each.code)]
    assert Counter(played) == {episode.id: 1 for episode in study.chosen()}


def test_a_design_that_needs_whole_tasks_says_so(example):
    pool = replace(example, episodes="explicit", tasks=9).chosen()
    with pytest.raises(ReibenchError, match="needs every task at every level"):
        designs.create("latin-square").check(pool[1:])


def test_another_person_s_link_in_the_same_browser_is_another_person(enrolment, example):
    enrolment.create(example)
    page = TakingPart(enrolment)
    first, second = enrolment.invite(example.name, 2)

    def visit(known, **link):
        request = SimpleNamespace(query_params={"study": example.name, **link})
        return page.arrive(known, request)[0]

    one = visit({}, invite=first)
    assert visit(one) == one  # a reload, when the invitation is gone from the address
    assert visit(one, invite=first) == one
    other = visit(one, invite=second)
    assert other != one
    assert visit(other, invite=first) == one
    prolific = visit(other, SESSION_ID="s1", PROLIFIC_PID="p")
    assert prolific not in (one, other)
    assert visit(prolific, SESSION_ID="s1") == visit(prolific) == prolific
    assert visit(prolific, SESSION_ID="s2") != prolific


def test_the_same_invitation_or_submission_is_the_same_person(enrolment, example):
    enrolment.create(example)
    [code] = enrolment.invite(example.name, 1)
    first = enrolment.arrive(example.name, {}, invite=code)
    assert enrolment.arrive(example.name, {}, invite=code) == first
    sent = {"SESSION_ID": "s1", "PROLIFIC_PID": "p1", "utm_source": "mail"}
    second = enrolment.arrive(example.name, sent)
    assert enrolment.arrive(example.name, sent).code == second.code != first.code
    [row] = enrolment.store.query(
        "select parameters from participants where code = ?", [second.code]
    )
    assert "mail" not in row["parameters"]
    assert "p1" in row["parameters"]


def test_nobody_is_taken_in_while_a_study_is_paused_but_who_has_begun_is_known(enrolment, example):
    enrolment.create(example)
    sent = {"SESSION_ID": "s1"}
    first = enrolment.arrive(example.name, sent)
    enrolment.set_state(example.name, "paused", "lunch")
    with pytest.raises(Closed, match="at the moment"):
        enrolment.arrive(example.name, {})
    assert enrolment.arrive(example.name, sent).code == first.code


def test_an_invitation_that_was_never_made_is_refused(enrolment, example):
    enrolment.create(replace(example, invited_only=True))
    for invite in ("", "BBBBBBBB", "' or 1=1 --", "../../etc/passwd", "<b>x</b>"):
        with pytest.raises(Closed):
            enrolment.arrive(example.name, {}, invite=invite)
    assert not enrolment.store.query("select * from participants")


def test_a_full_study_says_so(enrolment, example):
    enrolment.create(replace(example, people=2))
    for _ in range(2):
        enrolment.arrive(example.name, {})
    with pytest.raises(Closed, match="all the people it needs"):
        enrolment.arrive(example.name, {})


def test_who_leaves_gives_the_place_to_the_next(enrolment, example):
    enrolment.create(replace(example, people=2))
    first, second = (enrolment.arrive(example.name, {}) for _ in range(2))
    with enrolment.store.writing() as database:
        database.execute("update participants set state = 'withdrawn' where code = ?", [first.code])
        database.execute(
            "update participants set seen = '2020-01-01' where code = ?", [second.code]
        )
    third = enrolment.arrive(example.name, {})
    assert third.slot == first.slot
    assert {one.episode for one in enrolment.assignments(third.code)} == {
        one.episode for one in enrolment.assignments(first.code)
    }


def test_a_changed_study_is_a_new_version_and_people_stay_with_theirs(enrolment, example):
    assert enrolment.create(example)
    assert not enrolment.create(example)
    before = enrolment.arrive(example.name, {})
    changed = replace(example, texts={**example.texts, "consent": "Something else."})
    assert enrolment.create(changed)
    after = enrolment.arrive(example.name, {})
    assert before.version == example.version != after.version
    assert enrolment.study(example.name, before.version) == example
    assert enrolment.study(example.name) == changed


def test_a_study_or_a_token_nobody_has_is_unknown(enrolment, example):
    enrolment.create(example)
    with pytest.raises(UnknownName, match="Did you mean 'household'"):
        enrolment.arrive("houshold", {})
    with pytest.raises(UnknownName):
        enrolment.participant("x' or '1'='1")
