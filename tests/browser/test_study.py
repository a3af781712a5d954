"""A person takes part in a study, in a real browser, whatever happens on the way."""

import subprocess
import sys
from dataclasses import replace

import pytest
from playwright.sync_api import expect

from reibench.store import Store
from study.enrolment import Enrolment
from study.reading import read_study
from tests.browser import serving
from tests.study.conftest import EXAMPLE


class Participant:
    """A browser with the study open, and its own log of what the server acknowledged."""

    def __init__(self, page, address):
        self.page, self.address = page, address
        self.acknowledged = []
        self.trouble = []
        page.on("pageerror", lambda error: self.trouble.append(str(error)))

    def arrive(self, query=""):
        self.page.goto(f"{self.address}/s/household{query}")
        self.page.wait_for_selector("#where", state="attached")
        return self

    def at(self, stage, place=0):
        here = f"#where[data-stage='{stage}'][data-place='{place}']"
        self.page.wait_for_selector(here, state="attached")

    def press(self, what):
        self.page.click(f"[data-do={what}]")

    def go_to_practice(self):
        self.page.check("#agree")
        self.press("agree")
        self.at("tutorial")
        self.press("read")
        self.at("practice")

    def reload(self, stage, place=0):
        self.page.reload()
        self.at(stage, place)

    def do(self, skill):
        number = int(self.page.get_attribute("#act", "data-expected"))
        self.page.fill("#skill", skill)
        self.page.keyboard.press("Enter")
        self.page.wait_for_selector(f"#act[data-expected='{number + 1}']")
        said = self.page.locator(".steps li b").all_inner_texts()
        assert said[-1] == skill
        self.acknowledged.append(skill)

    def answer_quiz(self):
        for fieldset in self.page.locator("#questions fieldset").all():
            fieldset.locator("input").nth(1).check()
        self.press("answer")

    def answer_after(self):
        self.page.check("input[name=confidence][value='4']")
        self.page.select_option("select[name=meant]", index=1)
        self.press("answer")


@pytest.fixture
def study(tmp_path):
    """A study of three trials, in a database that is served later."""
    enrolment = Enrolment(Store(tmp_path / "study.db"))
    enrolment.create(replace(read_study(EXAMPLE), trials=3, people=0))
    return enrolment


def steps_of(enrolment):
    rows = enrolment.store.query(
        "select skill from steps join records on id = record where origin = 'study'"
        " order by steps.created, number"
    )
    return [row["skill"] for row in rows]


def test_the_whole_way_with_reloads_and_a_killed_server(chromium, study, tmp_path):
    port = serving.free_port()
    page = chromium.new_context(viewport={"width": 1280, "height": 800}).new_page()
    person = Participant(page, f"http://127.0.0.1:{port}")
    with serving.app(tmp_path / "study.db", port=port, kill=True):
        person.arrive("?PROLIFIC_PID=p1&SESSION_ID=s1&STUDY_ID=x")
        person.at("consent")
        assert "p1" not in page.url
        assert "s1" not in page.url
        person.reload("consent")
        page.check("#agree")
        person.press("agree")
        person.at("tutorial")
        person.reload("tutorial")
        person.press("read")
        person.at("practice")
        person.do("find a key chain")
        person.reload("practice")
        person.do("pick up the key chain")
        person.press("done")
        person.at("quiz")
        person.reload("quiz")
        person.answer_quiz()
        person.at("trial")
        person.do("find a drawer")
    # killed in the middle of a trial; the page waits and goes on by itself
    with serving.app(tmp_path / "study.db", port=port):
        expect(page.locator(".steps li")).to_have_count(1)
        person.reload("trial")
        person.do("open the drawer")
        person.press("done")
        person.at("after")
        person.reload("after")
        person.answer_after()
        for place in (1, 2):
            person.at("trial", place)
            person.do("find a sink")
            person.reload("trial", place)
            person.do("find a drawer")
            person.press("done")
            person.at("after", place)
            person.answer_after()
        person.at("end")
        person.reload("end")
        page.check("input[value=sometimes]")
        person.press("answer")
        person.at("over")
        expect(page.locator("#code")).to_have_text("REI-DONE")
        person.reload("over")
        expect(page.locator("#code")).to_have_text("REI-DONE")
    assert steps_of(study) == person.acknowledged
    assert not person.trouble
    [row] = study.store.query("select state from participants")
    assert row["state"] == "finished"
    times = study.store.query("select * from page_times where stage = 'trial'")
    assert len(times) >= 9
    assert all(row["left"] >= row["shown"] for row in times)


@pytest.fixture
def served(chromium, study, tmp_path):
    """Serve the study, and open it for as many people as are asked for."""
    with serving.app(tmp_path / "study.db") as address:

        def join(**how):
            context = chromium.new_context(**how)
            return Participant(context.new_page(), address).arrive()

        yield join


def test_with_the_keyboard_alone_and_nothing_told_that_should_not_be(served):
    person = served(viewport={"width": 390, "height": 844})
    page = person.page
    page.wait_for_selector("#agree")
    page.focus("#agree")
    page.keyboard.press("Space")
    page.keyboard.press("Tab")
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    person.at("tutorial")
    page.focus("[data-do=read]")
    page.keyboard.press("Enter")
    person.at("practice")
    page.focus("#skill")
    page.keyboard.type("find a key")
    page.keyboard.press("Enter")
    page.wait_for_selector(".steps li")
    person.press("done")
    person.at("quiz")
    person.answer_quiz()
    person.at("trial")
    html = page.content().lower()
    for word in ("vague", "explicit", "implicit", "mixed-", "goal", "tocc", "planner", "seed"):
        assert word not in html, word
    assert "solution" not in html
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_an_older_tab_catches_up_and_another_browser_is_another_person(served):
    person = served()
    page = person.page
    page.wait_for_selector("#agree")
    other = Participant(page.context.new_page(), person.address).arrive()
    other.at("consent")
    page.check("#agree")
    person.press("agree")
    person.at("tutorial")
    other.page.check("#agree")
    other.press("agree")
    other.at("tutorial")
    expect(other.page.locator(".card .notice")).to_contain_text("behind")
    stranger = served()
    stranger.at("consent")


def test_leaving_asks_once_more_and_deletes(served, study):
    person = served()
    person.page.check("#agree")
    person.press("agree")
    person.at("tutorial")
    person.press("leave-study")
    person.press("stay")
    person.press("leave-study")
    person.press("withdraw")
    person.at("over")
    expect(person.page.locator("#code")).to_have_text("REI-LEFT")
    [row] = study.store.query("select state from participants")
    assert row["state"] == "withdrawn"


def test_a_study_there_is_none_of_is_said_in_a_sentence(served):
    person = served()
    person.page.goto(f"{person.address}/s/%3Cimg%20src=x%20onerror=alert(1)%3E")
    expect(person.page.locator("#card")).to_contain_text("There is no such study")
    assert "household" not in person.page.locator("#card").inner_text()  # nor are others named
    expect(person.page.locator("#cols")).to_be_hidden()
    assert not person.trouble


def test_a_simulated_person_takes_part_in_a_real_browser(chromium, study):
    # Playwright runs once a process
    command = [sys.executable, "-m", "study", "simulate", "household", "--n", "1", "--browser"]
    command += ["--seed", "3", "--db", str(study.store.path)]
    run = subprocess.run(command, cwd=serving.ROOT, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert "finished" in run.stdout
    [row] = study.store.query("select simulated, state from participants")
    assert (row["simulated"], row["state"]) == (1, "finished")
    assert study.store.query("select count(*) as n from page_times")[0]["n"] > 10


def test_a_doubled_click_is_one_answer(served, study):
    person = served()
    page = person.page
    page.check("#agree")
    page.dblclick("[data-do=agree]")
    person.at("tutorial")
    person.press("read")
    person.at("practice")
    person.press("done")
    person.at("quiz")
    for fieldset in page.locator("#questions fieldset").all():
        fieldset.locator("input").nth(0).check()
    page.dblclick("[data-do=answer]")
    expect(page.locator("#where")).to_have_attribute("data-attempt", "1")
    person.answer_quiz()
    person.at("trial")
    left = study.store.query("select stage, place, step from page_times")
    assert len(left) == len({tuple(row.values()) for row in left}) + 1  # the quiz, twice
    [row] = study.store.query("select quiz_tries from participants")
    assert row["quiz_tries"] == 2


def test_on_a_phone_what_was_said_is_seen_before_anything_is_done(served):
    person = served(viewport={"width": 390, "height": 844})
    page = person.page
    person.go_to_practice()
    expect(page.locator(".talk")).to_be_visible()
    page.fill("#skill", "slice the bread")
    page.keyboard.press("Enter")
    page.evaluate("scrollTo(0, 0)")
    expect(page.locator(".refusal")).to_contain_text("bread")
    expect(page.locator(".refusal")).to_be_in_viewport()
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_enter_does_nothing_while_nothing_is_typed_and_early_typing_is_kept(served, study):
    person = served()
    page = person.page
    person.go_to_practice()
    page.focus("#skill")
    page.keyboard.press("Enter")
    person.do("find a key chain")
    page.keyboard.press("Enter")
    page.fill("#skill", "pick up the key chain")
    page.keyboard.press("Enter")
    page.keyboard.type("drawer")
    page.wait_for_selector("#act[data-expected='3']")
    expect(page.locator("#skill")).to_have_value("drawer")
    assert steps_of(study) == ["find a key chain", "pick up the key chain"]
