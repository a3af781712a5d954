"""The researchers' page: closed without the password, and what it shows and decides with it."""

import io
import zipfile

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from reibench.errors import ReibenchError
from study.admin import PASSWORD, build
from study.flow import Flow
from study.people import judge, people_of, trials_of
from study.simulating import Character, Simulation
from tests.study.conftest import go_to, right

SECRET = "correct horse battery"
PATHS = (
    "/admin/", "/admin/household", "/admin/household/export.zip", "/admin/household/people/XXXXXX",
    "/admin/household/people/XXXXXX/abc", "/admin/household/analysis",
)  # fmt: skip
BAD = ["../../etc/passwd", "' or 1=1 --", "<script>alert(1)</script>", "%00"]


@pytest.fixture
def played(enrolment, short):
    enrolment.create(short)
    Simulation(enrolment, short.name, Character(quiz=1.0), 1).run(
        2, together=1, tell=lambda line: None
    )
    return enrolment


@pytest.fixture
def client(played, monkeypatch):
    monkeypatch.setenv(PASSWORD, SECRET)
    app = FastAPI()
    app.mount("/admin", build(played))
    return TestClient(app, follow_redirects=False)


@pytest.fixture
def researcher(client):
    client.auth = ("anyone", SECRET)
    return client


def token_of(page):
    return page.text.partition('name="token" value="')[2].partition('"')[0]


@pytest.mark.parametrize("path", PATHS)
def test_without_the_password_everything_is_closed(client, path):
    assert client.get(path).status_code == 401
    assert client.get(path, auth=("admin", "wrong")).status_code == 401
    for method in ("post", "put", "delete"):
        assert getattr(client, method)(path).status_code in (401, 405)


@pytest.mark.parametrize("password", ["", "short"])
def test_there_is_no_default_password(client, monkeypatch, password):
    monkeypatch.setenv(PASSWORD, password)
    for path in PATHS:
        answer = client.get(path, auth=("admin", password))
        assert answer.status_code == 403
        assert PASSWORD in answer.text


def test_it_shows_who_is_where_and_how_full_the_cells_are(researcher, played, short):
    flow = Flow(played)
    token = played.arrive(short.name, {}).token
    go_to(flow, token, "trial", 1)
    page = researcher.get("/admin/household").text
    code = flow.page(token).participant.code
    assert code in page
    assert "Task 2" in page
    assert "<b>1</b><span>taking part now" in page
    assert "finished of 36 planned" in page
    assert page.count(": 1 held") == short.trials
    assert page.count(": 0 held") == 9 - short.trials
    simulated = researcher.get("/admin/household?who=simulated").text
    assert code not in simulated
    assert "<b>2</b><span>finished of 36 planned" in simulated
    assert '<td class="n">2</td>' in researcher.get("/admin/").text


def test_where_a_study_is_only_tried_its_simulated_people_are_shown(researcher, played, short):
    page = researcher.get("/admin/household").text
    assert all(one.code in page for one in people_of(played, short.name))


def test_what_somebody_answered_and_what_was_decided_is_shown_as_text(researcher, played, short):
    flow = Flow(played)
    token = played.arrive(short.name, {}).token
    page = go_to(flow, token, "end")
    said = right(page.questions) | {"remarks": "<img src=x onerror=alert(1)>"}
    code = flow.answer(token, "end", 0, said).participant.code
    judge(played, short.name, code, "accept", "<b>good</b>")
    shown = researcher.get(f"/admin/household/people/{code}").text
    assert "&lt;img src=x" in shown
    assert "<img src=x" not in shown
    assert "&lt;b&gt;good" in shown
    assert "Which thing was to be brought" in shown
    assert ">accepted<" in shown
    assert ">accepted<" in researcher.get("/admin/household?who=real").text


def test_a_task_that_is_being_played_is_followed(researcher, played, short):
    flow = Flow(played)
    token = played.arrive(short.name, {}).token
    page = go_to(flow, token, "trial")
    address = f"/admin/household/people/{page.participant.code}/{page.sitting.id}"
    assert "After step 0 of 0" in researcher.get(address).text
    flow.step(token, "trial", 0, "find a fridge", 1, 1)
    latest = researcher.get(address).text
    assert "After step 1 of 1" in latest
    assert "data-live" in latest
    assert "data-live" not in researcher.get(f"{address}?step=0").text


def test_a_finished_task_leads_to_its_case(researcher, played, short):
    one = people_of(played, short.name)[0]
    [trial, *_] = [row for row in trials_of(played, short.name, one.code) if row["status"]]
    address = f"/admin/-/cases?runs={trial['record']}"
    assert address in researcher.get(
        f"/admin/household/people/{one.code}/{trial['record']}"
    ).text.replace("&amp;", "&")
    assert researcher.get(address).headers["location"] == f"/cases?runs={trial['record']}"
    assert researcher.get("/admin/-/cases?runs=//evil.example").status_code == 422


def test_a_trial_is_replayed_step_by_step(researcher, played, short):
    one = people_of(played, short.name)[0]
    page = researcher.get(f"/admin/household/people/{one.code}").text
    record = page.partition(f"/admin/household/people/{one.code}/")[2].partition('"')[0]
    first = researcher.get(f"/admin/household/people/{one.code}/{record}?step=0").text
    last = researcher.get(f"/admin/household/people/{one.code}/{record}?step=99").text
    assert "Nothing done yet" in first
    assert 'class="plan' in first
    assert last.count('class="step') > first.count('class="step')


def test_rejecting_needs_a_reason_gives_the_place_back_and_can_be_undone(researcher, played, short):
    token = played.arrive(short.name, {}).token
    code = played.participant(token).code
    address = f"/admin/household/people/{code}"
    form = {"judgement": "reject", "token": token_of(researcher.get(address)), "reason": ""}
    assert researcher.post(address, data=form).status_code == 400
    assert played.participant(token).state == "active"
    done = researcher.post(address, data=form | {"reason": "was not there"})
    assert done.status_code == 303
    assert played.participant(token).state == "rejected"
    assert Flow(played).page(token).stage == "over"
    assert played.arrive(short.name, {}).slot == 0
    assert "was not there" in researcher.get(address).text
    again = form | {"judgement": "restore", "reason": "a mistake"}
    assert researcher.post(address, data=again).status_code == 303
    assert played.participant(token).state == "active"
    assert researcher.post(address, data=again).status_code == 400


def test_who_failed_the_quiz_is_given_no_other_code_by_being_turned_away(played, short):
    flow = Flow(played)
    token = played.arrive(short.name, {}).token
    page = go_to(flow, token, "quiz")
    for tries in range(2):
        wrong = {one.name: one.options[-1] for one in page.questions}
        page = flow.answer(token, "quiz", 0, wrong, tries)
    code = page.participant.code
    assert page.ending == "failed_check"
    judge(played, short.name, code, "reject", "a bot")
    assert flow.page(token).ending == "failed_check"
    judge(played, short.name, code, "restore", "no bot")
    assert played.participant(token).state == "failed_check"


def test_of_who_did_not_agree_there_is_nothing_to_judge(played, short):
    token = played.arrive(short.name, {}).token
    code = Flow(played).consent(token, agreed=False).participant.code
    for judgement in ("accept", "reject"):
        with pytest.raises(ReibenchError, match="has not agreed"):
            judge(played, short.name, code, judgement, "why not")


def test_a_study_is_paused_and_opened(researcher, played, short):
    form = {"state": "paused", "token": token_of(researcher.get("/admin/household")), "reason": ""}
    assert researcher.post("/admin/household/state", data=form).status_code == 303
    assert played.studies()[0]["state"] == "paused"
    assert researcher.post("/admin/household/state", data=form | {"state": "x"}).status_code == 400


def test_a_form_from_elsewhere_changes_nothing(researcher, played):
    for token in ("", "0" * 64, "é"):
        form = {"state": "stopped", "token": token}
        assert researcher.post("/admin/household/state", data=form).status_code in (403, 422)
    assert played.studies()[0]["state"] == "open"


@pytest.mark.parametrize("name", BAD)
def test_a_name_that_is_none_is_refused_and_shown_as_text(researcher, played, name):
    before = played.store.query("select * from participants")
    for path in (f"/admin/{name}", f"/admin/{name}/export.zip", f"/admin/household/people/{name}"):
        answer = researcher.get(path)
        assert answer.status_code in (400, 404)
        assert "<script>alert" not in answer.text
    assert played.store.query("select * from participants") == before


def test_an_analysis_is_shown_with_its_figure(researcher):
    assert "Nobody has finished" in researcher.get("/admin/household/analysis").text
    page = researcher.get("/admin/household/analysis?everybody=true").text
    assert "Success by level" in page
    assert "<svg" in page


def test_everything_can_be_downloaded(researcher):
    answer = researcher.get("/admin/household/export.zip?everybody=true")
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        assert "codebook.md" in archive.namelist()
        assert archive.read("trials.csv").count(b"\n") == 5
