"""The participant's way, from the invitation to the code."""

import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from reibench.errors import ReibenchError, StaleStep, UnknownName, UnknownSkill
from reibench.store import Store
from study import people, view
from study.enrolment import Closed, Enrolment
from study.flow import Flow
from tests.study.conftest import go_to, right

ROOT = Path(__file__).parents[2]


def everything(flow):
    """Return all that is recorded, for comparing before and after."""
    tables = ("participants", "assignments", "answers", "records", "steps")
    return {name: flow.enrolment.store.query(f"select * from {name}") for name in tables}


def test_the_whole_way(flow, someone, short):
    stages = []
    page = flow.page(someone)
    while page.stage != "over":
        stages.append((page.stage, page.place))
        page = flow.page(someone)
        if page.stage == "consent":
            page = flow.consent(someone, agreed=True)
        elif page.stage == "tutorial":
            page = flow.read(someone)
        elif page.sitting:
            page = flow.step(someone, page.stage, page.place, "find a fridge", 1, 0.5)
            page = flow.done(someone, page.stage, page.place, 2)
        else:
            page = flow.answer(someone, page.stage, page.place, right(page.questions))
    assert stages == [
        ("consent", 0), ("tutorial", 0), ("practice", 0), ("quiz", 0), ("trial", 0), ("after", 0),
        ("trial", 1), ("after", 1), ("end", 0),
    ]  # fmt: skip
    assert page.ending == "completed"
    assert page.code == short.codes["completed"]


def test_what_is_played_is_what_was_assigned_and_kept_as_a_person_s_record(flow, someone):
    page = go_to(flow, someone, "trial")
    given = flow.enrolment.assignments(page.participant.code)
    assert page.sitting.episode.id == given[0].episode
    page = flow.step(someone, "trial", 0, "find a fridge", 1, 1.25)
    [record] = flow.enrolment.store.query("select * from records where id = ?", [page.sitting.id])
    assert (record["origin"], record["actor"]) == ("study", "person")
    assert record["visitor"] == page.participant.code
    assert page.sitting.steps[0].seconds == 1.25


def test_any_reload_or_another_server_returns_to_the_same_place(flow, someone, tmp_path):
    for stage, place in (("practice", 0), ("quiz", 0), ("trial", 0), ("after", 1), ("end", 0)):
        page = go_to(flow, someone, stage, place)
        if page.sitting:
            page = flow.step(someone, stage, place, "find a fridge", len(page.sitting.steps) + 1, 1)
        flow = Flow(Enrolment(Store(tmp_path / "study.db")))  # the server is restarted
        again = flow.page(someone)
        assert (again.stage, again.place) == (stage, place)
        if page.sitting:
            assert again.sitting.id == page.sitting.id
            assert again.sitting.steps == page.sitting.steps
            later = flow.step(someone, stage, place, "find a sink", 2, 1)
            assert [str(step.decision.skill) for step in later.sitting.steps] == [
                "find a fridge", "find a sink",
            ]  # fmt: skip


def test_a_doubled_click_or_an_older_tab_changes_nothing(flow, someone):
    go_to(flow, someone, "trial")
    flow.step(someone, "trial", 0, "find a fridge", 1, 1)
    before = everything(flow)
    with pytest.raises(StaleStep):
        flow.step(someone, "trial", 0, "find a fridge", 1, 1)
    with pytest.raises(StaleStep):
        flow.done(someone, "trial", 0, 1)
    with pytest.raises(StaleStep):
        flow.step(someone, "practice", 0, "find a fridge", 2, 1)
    with pytest.raises(UnknownSkill):
        flow.step(someone, "trial", 0, "<script>alert(1)</script>", 2, 1)
    assert everything(flow) == before


@pytest.mark.parametrize("stage", ["tutorial", "practice", "quiz", "trial", "after", "end"])
def test_no_stage_can_be_skipped(flow, someone, stage):
    before = everything(flow)
    attempts = {
        "tutorial": lambda: flow.read(someone),
        "practice": lambda: flow.done(someone, "practice", 0, 1),
        "trial": lambda: flow.done(someone, "trial", 0, 1),
    }
    attempt = attempts.get(stage, lambda: flow.answer(someone, stage, 0, {}))
    with pytest.raises(StaleStep):
        attempt()
    assert everything(flow) == before
    with pytest.raises(ReibenchError):
        flow.answer(someone, "consent", 0, {})


@pytest.mark.parametrize("token", ["", "x", "' or 1=1 --", "../../etc/passwd"])
def test_a_token_nobody_has_is_refused_by_everything(flow, token):
    for attempt in (
        lambda: flow.page(token),
        lambda: flow.consent(token, agreed=True),
        lambda: flow.read(token),
        lambda: flow.step(token, "trial", 0, "find a fridge", 1, 1),
        lambda: flow.done(token, "trial", 0, 1),
        lambda: flow.answer(token, "quiz", 0, {}),
        lambda: flow.withdraw(token),
        lambda: flow.timed(token, "trial", 0, 0, (1, 2, 3)),
    ):
        with pytest.raises(UnknownName):
            attempt()


def test_a_wrong_quiz_is_explained_and_may_be_tried_once_more(flow, someone):
    page = go_to(flow, someone, "quiz")
    answers = right(page.questions) | {"shut": page.questions[0].options[0]}
    page = flow.answer(someone, "quiz", 0, answers)
    assert page.stage == "quiz"
    assert [question.name for question in page.wrong] == ["shut"]
    assert flow.answer(someone, "quiz", 0, right(page.questions), 1).stage == "trial"


def test_a_doubled_click_at_the_quiz_is_one_try(flow, someone):
    page = go_to(flow, someone, "quiz")
    answers = right(page.questions) | {"shut": page.questions[0].options[0]}
    flow.answer(someone, "quiz", 0, answers)
    before = everything(flow)
    with pytest.raises(StaleStep, match="answered already"):
        flow.answer(someone, "quiz", 0, answers)
    assert everything(flow) == before
    assert flow.page(someone).stage == "quiz"


def test_a_second_wrong_quiz_ends_with_its_own_code(flow, someone, short):
    page = go_to(flow, someone, "quiz")
    answers = right(page.questions) | {"shut": page.questions[0].options[0]}
    for tries in range(2):
        page = flow.answer(someone, "quiz", 0, answers, tries)
    assert (page.stage, page.ending) == ("over", "failed_check")
    assert page.code == short.codes["failed_check"]
    with pytest.raises(StaleStep):
        flow.answer(someone, "quiz", 0, right(short.quiz))


def test_who_does_not_agree_is_let_go(flow, someone, short):
    page = flow.consent(someone, agreed=False)
    assert (page.ending, page.code) == ("no_consent", short.codes["no_consent"])
    assert not flow.enrolment.store.query("select * from records")


def test_nothing_is_kept_about_who_does_not_agree(flow, someone):
    flow.consent(someone, agreed=False)
    flow.timed(someone, "consent", 0, 0, (1000.0, 2000.0, 0.0))
    [row] = flow.enrolment.store.query("select * from participants")
    assert row["parameters"] == "{}"
    assert not flow.enrolment.store.query("select * from page_times")
    assert flow.enrolment.arrive(row["study"], {"SESSION_ID": "s"}).token == someone


@pytest.mark.parametrize(
    "answers",
    [
        {},
        {"confidence": "9", "meant": "Mug"},
        {"confidence": "4", "meant": "<b>Mug</b>"},
        {"confidence": "4; drop table answers", "meant": "Mug"},
        {"confidence": ["4"], "meant": "Mug"},
    ],
)
def test_an_answer_that_is_none_is_refused_and_nothing_is_kept(flow, someone, answers):
    go_to(flow, someone, "after")
    before = everything(flow)
    with pytest.raises(ReibenchError):
        flow.answer(someone, "after", 0, answers)
    assert everything(flow) == before


def test_free_words_are_kept_as_they_are(flow, someone):
    page = go_to(flow, someone, "end")
    said = "<img src=x onerror=alert(1)>'; drop table answers; --"
    flow.answer(someone, "end", 0, right(page.questions) | {"remarks": said})
    [row] = flow.enrolment.store.query("select answer from answers where question = 'remarks'")
    assert row["answer"] == said


def test_leaving_deletes_what_was_done_and_keeps_that_somebody_was_here(flow, someone, short):
    go_to(flow, someone, "trial", 1)
    flow.step(someone, "trial", 1, "find a fridge", 1, 1)
    flow.timed(someone, "trial", 1, 1, (1000.0, 2000.0, 0.0))
    page = flow.withdraw(someone)
    assert (page.ending, page.code) == ("withdrawn", short.codes["withdrawn"])
    kept = everything(flow)
    assert not kept["answers"]
    assert not kept["records"]
    assert not kept["steps"]
    [row] = kept["participants"]
    assert (row["state"], row["parameters"]) == ("withdrawn", "{}")
    assert not flow.enrolment.store.query("select * from page_times")
    flow.timed(someone, "trial", 1, 1, (1000.0, 2000.0, 0.0))
    assert not flow.enrolment.store.query("select * from page_times")
    again = flow.enrolment.arrive(short.name, {"SESSION_ID": "s"})
    assert again.state == "withdrawn"
    assert flow.withdraw(someone).ending == "withdrawn"


def test_nothing_of_anyone_but_what_the_study_declares_is_kept(flow, short):
    sent = {"SESSION_ID": "secret-session", "PROLIFIC_PID": "pid", "email": "a@b.c"}
    flow.enrolment.arrive(short.name, sent)
    [row] = flow.enrolment.store.query("select * from participants")
    assert "a@b.c" not in str(row)
    assert row["submission"] != "secret-session"


def test_a_trial_whose_time_is_up_ends_by_itself(enrolment, short):
    enrolment.create(replace(short, name="timed", trial_minutes=5))
    flow = Flow(enrolment)
    token = enrolment.arrive("timed", {}).token
    page = go_to(flow, token, "trial")
    with enrolment.store.writing() as database:
        database.execute(
            "update records set started = '2020-01-01T00:00:00.000+00:00' where id = ?",
            [page.sitting.id],
        )
    with pytest.raises(StaleStep, match="over"):
        flow.step(token, "trial", 0, "find a fridge", 1, 1)
    assert flow.page(token).stage == "after"
    assert "The time was up" in view.card(flow.page(token))
    record = enrolment.store.record(page.sitting.id)
    assert (record.status, record.said_done, record.expired) == ("truncated", False, True)


def test_a_spent_budget_ends_a_trial(enrolment, short):
    enrolment.create(replace(short, name="brief", max_steps=2))
    flow = Flow(enrolment)
    token = enrolment.arrive("brief", {}).token
    go_to(flow, token, "trial")
    flow.step(token, "trial", 0, "find a fridge", 1, 1)
    page = flow.step(token, "trial", 0, "find a sink", 2, 1)
    assert (page.stage, page.spent) == ("after", "steps")
    assert "All 2 actions were used" in view.card(page)


def test_people_learn_how_it_came_out_only_where_the_study_says_so_and_after_they_answered(
    enrolment, short, flow, someone
):
    page = go_to(flow, someone, "after")
    assert flow.answer(someone, "after", 0, right(page.questions)).stage == "trial"
    enrolment.create(replace(short, name="told", reveal_success=True))
    token = enrolment.arrive("told", {}).token
    page = go_to(flow, token, "after")
    assert page.solved is None
    assert "has not been done" not in view.card(page)
    page = flow.answer(token, "after", 0, right(page.questions))
    assert (page.stage, page.solved) == ("outcome", False)
    assert "has not been done" in view.card(page)
    with pytest.raises(StaleStep):
        flow.read(token, "outcome", 1)
    assert flow.read(token, "outcome", 0).stage == "trial"


def test_what_was_asked_for_is_said_again_with_the_questions_about_it(flow, someone):
    request = go_to(flow, someone, "trial").sitting.episode.dialogue.instruction.text
    page = go_to(flow, someone, "after")
    assert page.request == request
    assert '<blockquote class="asked">' in view.card(page)
    assert "has ended" not in view.card(page)


def test_numbers_in_the_texts_are_the_study_s_own(flow, someone, short):
    page = go_to(flow, someone, "tutorial")
    said = view.card(page)
    assert "you have 30 actions, and as long as you like" in said
    assert "First there is a task to practise" in said
    changed = replace(short, max_steps=12, trial_minutes=5, practice=())
    said = view.card(replace(page, study=changed))
    assert "you have 12 actions, and 5 minutes" in said
    assert "to practise" not in said


def test_who_is_asked_for_consent_reads_what_of_the_link_is_kept(flow, someone, short):
    page = flow.page(someone)
    assert "PROLIFIC_PID, STUDY_ID, SESSION_ID" in view.card(page)
    assert "PROLIFIC_PID" not in view.card(replace(page, study=replace(short, parameters=())))


def test_a_time_limit_is_shown_and_counted_by_the_server(enrolment, short):
    enrolment.create(replace(short, name="timed", trial_minutes=5))
    flow = Flow(enrolment)
    token = enrolment.arrive("timed", {}).token
    page = go_to(flow, token, "trial")
    assert 290 < page.seconds_left <= 300
    assert 'id="time"' in view.actions(page, page.sitting)
    assert 'data-limit="300"' in view.where(page)
    assert go_to(flow, token, "after").seconds_left is None


def test_a_stopped_study_goes_on_for_nobody_and_a_paused_one_does(enrolment, flow, someone, short):
    go_to(flow, someone, "trial")
    enrolment.set_state(short.name, "paused")
    flow.step(someone, "trial", 0, "find a fridge", 1, 1)
    enrolment.set_state(short.name, "stopped", "enough")
    before = everything(flow)
    for attempt in (
        lambda: flow.step(someone, "trial", 0, "find a sink", 2, 1),
        lambda: flow.done(someone, "trial", 0, 2),
    ):
        with pytest.raises(Closed, match="stopped"):
            attempt()
    assert everything(flow) == before
    page = flow.page(someone)
    assert (page.stage, page.stopped, page.code) == ("over", True, "")
    assert "has been stopped" in view.card(page)
    assert "Leave the study" in view.header(page)  # what was done can still be deleted
    enrolment.set_state(short.name, "open")
    assert flow.page(someone).stage == "trial"
    enrolment.set_state(short.name, "stopped", "enough")
    assert flow.withdraw(someone).ending == "withdrawn"


def test_whoever_does_something_keeps_their_place(flow, someone, enrolment):
    go_to(flow, someone, "trial")
    with enrolment.store.writing() as database:
        database.execute("update participants set seen = '2020-01-01'")
    flow.step(someone, "trial", 0, "find a fridge", 1, 1)
    [row] = enrolment.store.query("select seen from participants")
    assert row["seen"] > "2021"


def killed(path, moment):
    """Kill a server of its own, as it comes to `moment` of a participant's first practice task."""
    program = f"""
import os, signal, sys
from reibench.store import Store
from study.enrolment import Enrolment
from study.flow import Flow
from tests.study.conftest import go_to
store = Store({str(path)!r})
flow = Flow(Enrolment(store))
[row] = store.query("select token from participants")
Store.{moment} = lambda *arguments: os.kill(os.getpid(), signal.SIGKILL)
go_to(flow, row["token"], "practice")
"""
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, timeout=60, check=False)
    assert done.returncode == -signal.SIGKILL


@pytest.mark.parametrize("moment", ["_note_start", "entries", "steps_done"])
def test_a_server_killed_as_a_task_begins_leaves_nobody_locked_out(flow, someone, tmp_path, moment):
    killed(tmp_path / "study.db", moment)
    page = go_to(flow, someone, "practice")
    assert page.sitting.steps == ()
    flow.step(someone, "practice", 0, "find a fridge", 1, 1)
    flow.withdraw(someone)
    assert not flow.enrolment.store.query("select * from records")


def test_who_is_turned_away_meanwhile_stays_so(flow, someone, enrolment, short):
    page = go_to(flow, someone, "after", 1)
    people.judge(enrolment, short.name, page.participant.code, "reject", "a bot")
    with pytest.raises(StaleStep):
        flow.answer(someone, "after", 1, right(page.questions))
    assert flow.page(someone).participant.state == "rejected"


@pytest.mark.parametrize("number", ["9" * 5000, "0", "08", "-1", "\u0663"])
def test_a_number_that_is_no_point_of_a_scale_is_refused(flow, someone, number):
    go_to(flow, someone, "after")
    with pytest.raises(ReibenchError):
        flow.answer(someone, "after", 0, {"confidence": number, "meant": "Mug"})
