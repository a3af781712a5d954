"""Cases in a real browser: found, walked through by keyboard, linked, exported, kept."""

import re
from urllib.parse import parse_qs, urlparse

import pytest
from playwright.sync_api import expect


class Cases:
    """A browser with the case pages open."""

    def __init__(self, page, address):
        self.page = page
        self.address = address
        self.trouble = []
        page.on("pageerror", lambda error: self.trouble.append(str(error)))

    def open(self, path="/cases"):
        self.page.goto(self.address + path)
        return self

    @property
    def row(self):
        return int(self.page.get_attribute("#case", "data-row"))

    def at(self, row):
        """Wait until the panel shows a row."""
        words = f"Row {row + 1} of" if row >= 0 else "Start"
        expect(self.page.locator("#where")).to_contain_text(words)
        return self


@pytest.fixture
def look(chromium, app):
    contexts, looks = [], []

    def look(path="/cases", **options):
        options.setdefault("viewport", {"width": 1280, "height": 800})
        context = chromium.new_context(**options)
        contexts.append(context)
        looks.append(Cases(context.new_page(), app))
        return looks[-1].open(path)

    yield look
    for context in contexts:
        context.close()
    assert [trouble for one in looks for trouble in one.trouble] == []


def test_a_first_visitor_sees_a_recorded_case_and_gets_to_more_in_two_clicks(visit, app):
    demo = visit()
    expect(demo.page.locator(".verdict.good")).to_be_visible()
    expect(demo.page.locator(".verdict.bad")).to_contain_text("was taken for")
    expect(demo.page.locator(".lead")).to_contain_text("recordings")
    demo.page.click("text=More cases")
    demo.page.locator("#list .case").nth(1).click()
    expect(demo.page.locator("#case .vd .g")).to_have_text("Success")
    expect(demo.page.locator("#case .vd .b")).not_to_be_empty()


def test_a_first_visitor_can_act_at_once(visit):
    demo = visit()
    demo.page.click("text=Act yourself")
    demo.settled()
    demo.do("find a fridge")
    assert demo.steps == 1


def test_recorded_runs_are_walked_through_and_presented(visit):
    demo = visit()
    demo.page.keyboard.press("Home")
    expect(demo.page.locator("#sbs")).to_have_attribute("data-row", "0")
    demo.page.keyboard.press("p")
    expect(demo.page.locator("html")).to_have_attribute("data-present", "on")
    expect(demo.page.locator(".verd")).to_be_hidden()
    demo.page.keyboard.press("End")
    expect(demo.page.locator(".verd")).to_be_visible()
    demo.page.keyboard.press("p")
    expect(demo.page.locator("#bar")).to_be_visible()


def test_keys_pressed_faster_than_the_server_answers_are_not_lost(visit):
    demo = visit()
    demo.page.keyboard.press("Home")
    expect(demo.page.locator("#sbs")).to_have_attribute("data-row", "0")
    for key in ("ArrowRight", "ArrowRight", "ArrowRight", "ArrowLeft"):
        demo.page.keyboard.press(key)
    expect(demo.page.locator("html")).not_to_have_class(re.compile("busy"))
    expect(demo.page.locator("#sbs .ln.here").first).to_have_attribute("data-row", "2")
    expect(demo.page.locator("#sbs")).to_have_attribute("data-row", "2")
    expect(demo.page.locator("#sbs .rooms, #sbs figure").first).to_contain_text("Step 3")


def test_the_keyboard_alone_walks_through_a_case(look):
    cases = look("/cases?kind=helps")
    page = cases.page
    first = page.get_attribute("#case", "data-runs")
    page.keyboard.press("Home")
    cases.at(-1)
    page.keyboard.press("ArrowRight")
    cases.at(0)
    page.keyboard.press("2")
    expect(page.locator("#at [role=tab]").nth(1)).to_have_attribute("aria-selected", "true")
    page.keyboard.press("End")
    cases.at(int(page.get_attribute("#case", "data-rows")) - 1)
    page.keyboard.press("v")
    cases.at(int(page.get_attribute("#case", "data-split")))
    page.keyboard.press("j")
    expect(page.locator("#case")).not_to_have_attribute("data-runs", first)
    page.keyboard.press("k")
    expect(page.locator("#case")).to_have_attribute("data-runs", first)
    page.keyboard.press("/")
    page.keyboard.type("egg")
    expect(page).to_have_url(re.compile("words=egg"))
    expect(page.locator("#words")).to_be_focused()


def test_playing_walks_to_the_end_and_stops(look):
    cases = look("/cases?kind=helps&words=ledger")
    last = int(cases.page.get_attribute("#case", "data-rows")) - 1
    cases.page.keyboard.press("Home")
    cases.at(-1)
    cases.page.keyboard.press(" ")
    cases.at(last)
    expect(cases.page.locator("#at .play")).to_have_text("Play")


def test_a_copied_link_opens_the_same_state_elsewhere(look):
    cases = look("/cases?kind=helps")
    for key in ("Home", "ArrowRight", "ArrowRight", "2"):
        cases.page.keyboard.press(key)
    cases.at(1)
    expect(cases.page).to_have_url(re.compile("lane=2"))
    there = look(cases.page.url.removeprefix(cases.address))
    for selector in ("#case", "#lanes", "#count"):
        here = cases.page.locator(selector).inner_text()
        assert there.page.locator(selector).inner_text() == here
    assert there.row == cases.row
    assert there.page.get_attribute("#case", "data-lane") == "1"


def test_filters_change_the_list_and_the_address_and_back_undoes_it(look):
    cases = look("/cases")
    page = cases.page
    before = page.inner_text("#count")
    page.click(".fs .chip:has-text('hurts')")
    expect(page).to_have_url(re.compile("kind=hurts"))
    expect(page.locator("#count")).not_to_have_text(before)
    page.locator("select[name=task_type]").select_option("look_at_obj_in_light")
    expect(page).to_have_url(re.compile("task_type=look"))
    page.go_back()
    page.go_back()
    expect(page.locator("#count")).to_have_text(before)


def test_back_shows_the_case_that_was_there_before(look):
    page = look("/cases").page
    first = page.get_attribute("#case", "data-runs")
    page.locator("#list .case").nth(3).click()
    expect(page.locator("#case")).not_to_have_attribute("data-runs", first)
    fourth = page.get_attribute("#case", "data-runs")
    page.go_back()
    expect(page.locator("#case")).to_have_attribute("data-runs", first)
    expect(page.locator("#list .case").first).to_have_class(re.compile(r"\bon\b"))
    page.go_forward()
    expect(page.locator("#case")).to_have_attribute("data-runs", fourth)


def test_keys_pressed_faster_than_cases_come_all_count(look):
    page = look("/cases").page
    runs = [
        parse_qs(urlparse(link.get_attribute("href")).query)["runs"][0]
        for link in page.locator("#list .case").all()
    ]
    for key in "jjjkj":
        page.keyboard.press(key)
    expect(page.locator("#case")).to_have_attribute("data-runs", runs[3])
    for key in ("j", "Home", "ArrowRight"):
        page.keyboard.press(key)
    expect(page.locator("#case")).to_have_attribute("data-runs", runs[4])
    expect(page.locator("#where")).to_contain_text("Row 1 of")


def test_a_late_answer_does_not_replace_a_newer_one(look):
    page = look("/cases").page
    second, third = (page.locator("#list .case").nth(n).get_attribute("href") for n in (1, 2))
    late = []
    page.route(
        "**/*part=case*", lambda route: late.append(route) if not late else route.continue_()
    )
    page.locator("#list .case").nth(1).click()
    page.locator("#list .case").nth(2).click()
    runs = parse_qs(urlparse(third).query)["runs"][0]
    expect(page.locator("#case")).to_have_attribute("data-runs", runs)
    with page.expect_response(lambda answer: "part=case" in answer.url):
        late[0].continue_()
    page.wait_for_timeout(200)
    assert second != third
    assert page.get_attribute("#case", "data-runs") == runs
    assert parse_qs(urlparse(page.url).query)["runs"][0] == runs


def test_steps_are_walked_as_fast_as_keys_are_pressed_while_the_list_changes(look):
    cases = look("/cases")
    page = cases.page
    page.keyboard.press("Home")
    cases.at(-1)
    page.evaluate(
        """() => {
            const press = (key) => document.body.dispatchEvent(
                new KeyboardEvent("keydown", { key, bubbles: true })
            );
            document.querySelector(".fs .chip").click();
            for (const key of ["ArrowRight", "ArrowRight", "ArrowRight", "ArrowLeft"]) press(key);
        }"""
    )
    cases.at(1)
    expect(page).to_have_url(re.compile("kind="))


def test_a_note_that_is_being_written_is_not_lost_unasked(look):
    page = look("/cases").page
    asked = []
    page.on("dialog", lambda dialog: (asked.append(dialog.message), dialog.dismiss()))
    first = page.get_attribute("#case", "data-runs")
    page.click(".kept summary")
    page.fill("[name=note]", "Half a thought")
    page.locator("#list .case").nth(2).click()
    expect(page.locator("[name=note]")).to_have_value("Half a thought")
    assert page.get_attribute("#case", "data-runs") == first
    assert "not kept yet" in asked[0]


def test_tags_are_kept_by_whoever_sits_at_the_server(look):
    cases = look("/cases?kind=helps")
    page = cases.page
    page.click("summary:has-text('Add a tag')")
    page.fill("[name=tags]", "for the talk")
    page.click("button:has-text('Keep')")
    expect(page.locator(".chip.tag").first).to_have_text("for the talk")
    cases.open("/cases?words=for+the+talk")
    expect(page.locator("#list .case")).not_to_have_count(0)


def test_the_exported_page_opens_offline_and_shows_the_same_steps(look, tmp_path):
    cases = look("/cases?kind=helps")
    runs = cases.page.get_attribute("#case", "data-runs")
    file = tmp_path / "case.html"
    answer = cases.page.request.get(f"{cases.address}/cases/case.html?runs={runs}")
    file.write_bytes(answer.body())
    alone = look()
    alone.page.context.set_offline(True)
    alone.page.goto(file.as_uri())
    for page in (cases.page, alone.page):
        page.keyboard.press("Home")
    total = int(cases.page.get_attribute("#case", "data-rows"))
    for row in range(total):
        for one in (cases, alone):
            one.page.keyboard.press("ArrowRight")
            one.at(row)
        for selector in ("#at .changed", "#at .gt", "#lanes"):
            here = cases.page.locator(selector).inner_text()
            expect(alone.page.locator(selector)).to_have_text(here, use_inner_text=True)
    alone.page.keyboard.press("2")
    expect(alone.page.locator("#at [role=tab]").nth(1)).to_have_attribute("aria-selected", "true")


def test_a_phone_shows_everything_one_below_the_other(look):
    cases = look("/cases?kind=helps", viewport={"width": 390, "height": 844})
    page = cases.page
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    page.locator("#list .case").nth(2).click()
    expect(page.locator("#list .case").nth(2)).to_have_class(re.compile("on"))
    page.click("#at [data-do=forward]")
    expect(page).to_have_url(re.compile("step="))
    for path in ("/comparison", "/own", "/"):
        page.goto(cases.address + path)
        page.wait_for_timeout(300)
        assert page.evaluate("document.documentElement.scrollWidth") <= 390, path
        expect(page.locator(".nav a.tab").nth(1)).to_be_visible()


def test_on_a_phone_what_is_wrong_with_own_words_is_seen_first(look):
    page = look("/own?room=kitchen-6", viewport={"width": 390, "height": 844}).page
    page.click("text=See both planners try")
    expect(page.locator(".notice.bad")).to_contain_text("is not chosen yet")
    assert page.locator(".notice.bad").bounding_box()["y"] < 400


def test_a_lamp_is_asked_for_where_something_is_looked_at(look):
    page = look("/own?room=bedroom-1").page
    place = page.locator(".field:has([name=destination]) .label")
    expect(place).to_have_text("Where it should end")
    page.select_option("[name=task_type]", "look_at_obj_in_light")
    expect(place).to_have_text("Lamp it is looked at under")


def test_own_words_are_guessed_watched_and_shared(visit, chromium, app):
    page = chromium.new_page()
    page.goto(f"{app}/own?room=kitchen-6")
    page.fill("#before", "Human: I am hungry.\nRobot: There is an apple and bread.")
    page.fill("#request", "Put the round red thing in the fridge.")
    page.locator("select[name=object]").select_option("Apple")
    page.locator("select[name=destination]").select_option("Fridge")
    page.fill("[name=vague]", "the round red thing")
    page.click("text=See both planners try")
    page.wait_for_selector(".guess")
    address = page.url
    assert "apple" not in page.inner_text(".sbs")
    page.click("[data-guess=Apple]")
    page.click("[data-guess=Bread]")
    page.click("[data-do=watch]")
    expect(page.locator(".guess.over")).to_have_text(
        re.compile("Meant was the apple.*1 of 2 guessed it"), timeout=90_000
    )
    expect(page.locator(".verdict strong")).to_have_count(2)
    page.close()
    other = visit(address.removeprefix(app + "/"))
    expect(other.page.locator(".sbs")).to_contain_text("the round red thing")
