"""The researchers' page: closed without the password, and what it shows and decides with it."""

import io
import zipfile

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from reibench.errors import ReibenchError
from study.admin import PASSWORD, build
from study.flow import Flow
from study.people import judge, people_of
from study.simulating import Character, Simulation
from tests.study.conftest import go_to

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
    assert "trial 2" in page
    assert "1 people take part or have finished of 36 planned" in page
    assert "2 simulated" in page
    assert "explicit-standard" in page


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
    assert "success by level" in page
    assert "<svg" in page


def test_everything_can_be_downloaded(researcher):
    answer = researcher.get("/admin/household/export.zip?everybody=true")
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        assert "codebook.md" in archive.namelist()
        assert archive.read("trials.csv").count(b"\n") == 5
