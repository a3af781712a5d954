"""A visitor watches planners act: one alone, and two side by side."""

from itertools import chain, zip_longest

import pytest
from playwright.sync_api import expect

from reibench.methods import methods
from reibench.view.choices import offered_methods
from tests.browser import serving

EPISODE = "heat_potato.mixed-noised"


def test_a_real_model_acts_and_is_stopped_after_the_step_it_is_at(visit):
    demo = visit(f"?episode={EPISODE}&actor=tocc")
    page = demo.page
    page.click("[data-do=watch]")
    expect(page.locator(".act .stop")).to_be_visible(timeout=60_000)
    page.wait_for_selector(".steps .step b", timeout=90_000)
    expect(page.locator(".told")).to_contain_text("Rewritten by TOCC")
    if page.locator(".act .stop").count():
        page.click(".act .stop")
    expect(page.locator(".act .verdict")).to_be_visible(timeout=60_000)
    expect(page.locator("[data-do=compare]")).to_be_visible()
    assert "ready" in page.inner_text(".pill")


def test_choosing_something_else_ends_what_one_watches(visit):
    demo = visit(f"?episode={EPISODE}&actor=model")
    page = demo.page
    page.click("[data-do=watch]")
    expect(page.locator(".act .stop")).to_be_visible(timeout=60_000)
    page.click(".seg [data-actor=me]")
    expect(page.locator("#skill")).to_be_visible()
    demo.settled()
    page.wait_for_timeout(2500)
    expect(page.locator("#skill")).to_be_visible()
    assert page.get_attribute("#choice", "data-actor") == "me"
    demo.do("find a fridge")


@pytest.fixture(scope="module")
def scripted(chromium, solution, tmp_path_factory):
    """Serve with a script in place of a model: a run that fails beside one that succeeds."""
    folder = tmp_path_factory.mktemp("scripted")
    plain = ["find an apple", "pick up the apple", "done"]
    told = [*solution, "done"]
    pairs = chain.from_iterable(zip_longest(plain, told))
    script = folder / "script.txt"
    script.write_text("\n".join(["Heat the potato.", *filter(None, pairs)]))
    with serving.app(folder / "demo.db", model=f"scripted:{script}") as address:
        yield address


def rewrite_freely(demo):
    """Choose the paper's TOCC on the shelf."""
    demo.page.click(".pill")
    demo.page.locator("#shelf input[value='tocc']").check()
    demo.settled()
    demo.page.keyboard.press("Escape")
    expect(demo.page.locator("#shelf")).to_be_hidden()


def test_two_runs_are_shown_side_by_side_and_played(visit, scripted, solution):
    demo = visit(f"?episode={EPISODE}&actor=side", address=scripted)
    rewrite_freely(demo)
    page = demo.page
    page.click("#sbs [data-do=watch]")
    expect(page.locator("#sbs.over")).to_be_visible()
    demo.settled()
    verdicts = page.locator(".verd .verdict strong")
    expect(verdicts).to_have_text(
        ["Failed: object omission", f"Succeeded in {len(solution)} of 30 steps"]
    )
    expect(page.locator(".instr ins").first).to_be_visible()
    expect(page.locator(".mid .div")).to_have_text("firstdifference")
    page.keyboard.press("v")
    expect(page.locator("#sbs[data-row='0'] .ln.here").first).to_be_visible()
    demo.settled()
    expect(page.locator(".pic figcaption").first).to_contain_text("Step 1.")
    page.keyboard.press("ArrowRight")
    page.wait_for_selector("#sbs[data-row='1']")
    demo.settled()
    page.keyboard.press("End")
    expect(page.locator(".pic figcaption").last).to_contain_text("End.")
    demo.settled()
    page.reload()
    demo.settled()
    expect(page.locator("#sbs.over")).to_be_visible()
    page.keyboard.press("Escape")
    expect(page.locator("#skill")).to_be_visible()


def test_a_model_that_breaks_leaves_a_message_and_the_page_goes_on(visit, scripted):
    demo = visit("?episode=cool_apple.mixed-noised&actor=model", address=scripted)
    page = demo.page
    page.click("[data-do=watch]")
    expect(page.locator(".act .verdict, .act .notice.bad").first).to_be_visible()
    expect(page.locator(".act")).to_contain_text("no answer left")
    page.click(".seg [data-actor=me]")
    expect(page.locator("#skill")).to_be_visible()


def test_the_shelf_tells_which_models_are_here(visit):
    demo = visit()
    demo.page.click(".pill")
    shelf = demo.page.locator("#shelf")
    expect(shelf).to_be_visible()
    expect(shelf).to_contain_text("gemma-3-270m")
    expect(demo.page.locator("#shelf input[value='tocc-taught']")).to_be_checked()
    demo.page.locator("#shelf input[value='tocc']").check()
    demo.settled()
    expect(demo.page.locator("#shelf input[value='tocc']")).to_be_checked()
    demo.page.keyboard.press("Escape")
    expect(shelf).to_be_hidden()


def test_an_address_chooses_the_method_and_the_page_explains_all_of_them(visit):
    demo = visit(f"?episode={EPISODE}&actor=tocc&method=gated-ap")
    expect(demo.page.locator(".seg [data-actor=tocc]")).to_have_text("Model + Gated AP")
    demo.page.click(".pill")
    shelf = demo.page.locator("#shelf")
    expect(shelf.locator("input[value='gated-ap']")).to_be_checked()
    expect(shelf.locator("input[name=method]")).to_have_count(len(offered_methods()))
    expect(shelf).to_contain_text(methods.create("gated-ap").summary)
    assert "method=gated-ap" in demo.page.url


def test_a_restarted_server_finds_the_visitor_where_they_were(visit, tmp_path):
    port = serving.free_port()
    with serving.app(tmp_path / "demo.db", port=port) as address:
        demo = visit(f"?episode={EPISODE}&actor=me", address=address)
        demo.do("find a fridge")
    with serving.app(tmp_path / "demo.db", port=port):
        expect(demo.page.locator(".steps li")).to_have_count(1)
        demo.page.reload()
        demo.settled()
        assert demo.steps == 1
        demo.do("open the fridge")
        assert demo.steps == 2


GRAPH = (
    "1: find a potato\\n2: pick up the potato after 1\\n3: find a microwave\\n"
    "4: put down the potato after 2, 3\\ndone"
)
REST = "1: open the microwave\\n2: put down the potato after 1\\ndone"


def test_a_planner_s_graph_is_seen_as_it_grows_and_why_a_step_was_taken(visit, tmp_path):
    script = tmp_path / "graphs.txt"
    script.write_text(f"1: find a potato after 2\\n2: find a mug after 1\n{GRAPH}\n{REST}\n")
    with serving.app(tmp_path / "demo.db", model=f"scripted:{script}") as address:
        demo = visit(f"?episode={EPISODE}&actor=model&planner=dag-plan", address=address)
        page = demo.page
        expect(page.locator(".act h2")).to_have_text("DAG-Plan")
        page.click("[data-do=watch]")
        expect(page.locator(".act .verdict")).to_be_visible(timeout=60_000)
        expect(page.locator(".made .graph .node.done")).to_have_count(2)
        page.locator(".thoughts summary").first.click()
        expect(page.locator(".thoughts").first).to_contain_text("in a circle: 1 → 2 → 1")
        page.reload()
        demo.settled()
        expect(page.locator(".made .graph .node.done")).to_have_count(2)
        page.click(".pill")
        expect(page.locator("#shelf input[value='dag-plan']")).to_be_checked()
        page.locator("#shelf input[value='hpe']").check()
        demo.settled()
        expect(page.locator(".act h2")).to_have_text("HPE")
        assert "planner=hpe" in page.url
