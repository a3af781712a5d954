"""The researchers' pages in a real browser: kept up to date, and a task walked through by keys."""

import re

import pytest
from playwright.sync_api import expect

from reibench.store import Store
from study.access import PASSWORD
from study.enrolment import Enrolment
from study.flow import Flow
from study.reading import read_study
from tests.browser import serving
from tests.study.conftest import EXAMPLE, go_to

SECRET = "correct horse"


@pytest.fixture
def enrolment(tmp_path):
    enrolment = Enrolment(Store(tmp_path / "study.db"))
    enrolment.create(read_study(EXAMPLE))
    return enrolment


@pytest.fixture
def page(chromium, enrolment, tmp_path, monkeypatch):
    monkeypatch.setenv(PASSWORD, SECRET)
    trouble = []
    with serving.app(tmp_path / "study.db") as address:
        context = chromium.new_context(
            base_url=address, http_credentials={"username": "any", "password": SECRET}
        )
        page = context.new_page()
        page.on("pageerror", lambda error: trouble.append(str(error)))
        yield page
        context.close()
    assert trouble == []


def test_a_study_is_kept_up_to_date_while_a_reason_is_being_typed(page, enrolment):
    page.goto("/admin/household")
    expect(page.locator("main")).to_contain_text("Nobody has come yet.")
    page.fill("[name=reason]", "a longer thou")
    flow = Flow(enrolment)
    token = enrolment.arrive("household", {}).token
    code = go_to(flow, token, "practice").participant.code
    expect(page.locator("table")).to_contain_text(code)
    expect(page.locator("table")).to_contain_text("Practice")
    page.keyboard.type("ght")
    assert page.input_value("[name=reason]") == "a longer thought"
    page.click("text=Pause")
    expect(page.locator(".headline .pill")).to_have_text("paused")


def test_a_task_is_followed_and_walked_through_with_keys(page, enrolment):
    flow = Flow(enrolment)
    token = enrolment.arrive("household", {}).token
    trial = go_to(flow, token, "trial")
    page.goto(f"/admin/household/people/{trial.participant.code}/{trial.sitting.id}")
    where = page.locator(".walk > b")
    expect(where).to_have_text("After step 0 of 0")
    for number, skill in enumerate(("find a fridge", "open the fridge", "find a sink"), 1):
        flow.step(token, "trial", 0, skill, number, 1.0)
    expect(where).to_have_text("After step 3 of 3")
    page.keyboard.press("Home")
    expect(where).to_have_text("After step 0 of 3")
    page.keyboard.press("ArrowRight")
    expect(where).to_have_text("After step 1 of 3")
    expect(page).to_have_url(re.compile("step=1$"))
    page.keyboard.press("Space")
    expect(where).to_have_text("After step 3 of 3")
    expect(page.locator(".walk [data-do=play]")).to_have_text("Play")
    page.click(".marks a >> nth=1")
    expect(where).to_have_text("After step 2 of 3")
    flow.done(token, "trial", 0, 4)
    page.goto(page.url)
    page.click("text=Open as a case")
    expect(page.locator("#case")).to_have_attribute("data-runs", trial.sitting.id)
