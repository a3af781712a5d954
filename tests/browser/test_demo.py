"""A visitor acts in the demo: by the room, by the picker, by the keyboard, on a phone."""

from playwright.sync_api import expect

EPISODE = "heat_potato.mixed-noised"
HERE = f"?episode={EPISODE}&actor=me"


def test_an_episode_is_solved_by_clicking_in_the_room_and_by_the_picker(visit, solution):
    demo = visit(HERE)
    for number, skill in enumerate(solution):
        thing = {"find a microwave": "Microwave", "open the microwave": "Microwave"}.get(skill)
        if thing and number % 2:
            demo.click_thing(thing, skill)
        else:
            demo.do(skill)
    expect(demo.page.locator(".goals .box.y")).to_have_count(3)
    demo.page.click("[data-do=done]")
    expect(demo.page.locator(".verdict strong")).to_have_text(
        "Done: the instruction is carried out."
    )
    assert "closed" in (demo.page.get_attribute("html", "class") or "")


def test_a_refused_action_shows_its_reason(visit):
    demo = visit(HERE)
    demo.do("pick up the potato")
    row = demo.page.locator(".step.fail")
    expect(row).to_contain_text("pick up the potato")
    assert len(row.locator("small").inner_text()) > 10
    assert "refused" in demo.page.inner_text("#live")


def test_two_visitors_do_not_see_each_other(visit):
    ann, ben = visit(HERE), visit(HERE)
    ann.do("find a fridge")
    ben.open(HERE)
    assert (ann.steps, ben.steps) == (1, 0)


def test_a_reload_continues_where_one_was(visit):
    demo = visit(HERE)
    demo.do("find a fridge")
    demo.do("open the fridge")
    demo.page.reload()
    demo.settled()
    assert demo.steps == 2
    expect(demo.page.locator(".steps li")).to_have_count(2)
    demo.open()
    assert EPISODE in demo.page.url


def test_a_tab_that_was_behind_catches_up_and_says_so(visit):
    demo = visit(HERE)
    other = demo.page.context.new_page()
    other.goto(demo.page.url)
    other.wait_for_selector("#act[data-expected='1']")
    demo.do("find a fridge")
    other.fill("#skill", "find an apple")
    other.press("#skill", "Enter")
    expect(other.locator(".notice")).to_have_text("This tab was behind. It now shows step 1.")
    expect(other.locator(".steps li")).to_have_count(1)


def test_everything_can_be_done_with_the_keyboard_alone(visit):
    demo = visit(HERE)
    keys = demo.page.keyboard
    keys.press("/")
    keys.type("fi frid")
    expect(demo.page.locator(".opts li.on")).to_have_text("find a fridge")
    keys.press("Enter")
    demo.wait_for_step(1)
    demo.page.locator(".wide-plan [tabindex='0']").focus()
    keys.press("ArrowRight")
    expect(demo.page.locator(".wide-plan [data-oid]:focus")).to_have_count(1)
    keys.press("Enter")
    expect(demo.page.locator(".menu")).to_be_visible()
    expect(demo.page.locator(".menu [data-skill]:focus")).to_have_count(1)
    keys.press("Escape")
    expect(demo.page.locator(".menu")).to_have_count(0)
    expect(demo.page.locator(".wide-plan [data-oid]:focus")).to_have_count(1)
    keys.press("Enter")
    keys.press("Enter")
    demo.wait_for_step(2)
    expect(demo.page.locator(".wide-plan [data-oid]:focus")).to_have_count(1)
    keys.press("Control+Enter")
    expect(demo.page.locator(".verdict strong")).to_have_text("Not carried out.")


def test_the_picker_finds_any_part_of_any_word(visit):
    demo = visit(HERE)
    page = demo.page
    page.fill("#skill", "pd tom")
    expect(page.locator(".opts [role=option]")).to_have_text(["put down the tomato"])
    page.fill("#skill", "tomatoe")
    expect(page.locator(".nomatch")).to_contain_text("Did you mean tomato?")
    page.click("[data-suggest]")
    expect(page.locator(".opts [role=option]").first).to_contain_text("tomato")
    page.press("#skill", "Escape")
    page.press("#skill", "Alt+6")
    expect(page.locator(".opts [role=option]")).to_have_count(5)
    expect(page.locator("[data-verb=slice]")).to_have_attribute("aria-pressed", "true")
    page.press("#skill", "Escape")
    assert page.locator(".opts [role=option]").count() == 214
    expect(page.locator(".opts .group").first).to_be_visible()


def test_typing_dims_what_does_not_match(visit):
    demo = visit(HERE)
    demo.page.fill("#skill", "apple")
    expect(demo.page.locator(".wide-plan .thing.match[data-type=Apple]").first).to_be_visible()
    assert demo.page.locator("section.room.dimmed").count() == 1


def test_the_address_says_which_episode_and_actor_are_shown(visit):
    demo = visit(HERE)
    demo.page.click("[data-level='explicit-short']")
    demo.settled()
    demo.page.wait_for_url("**episode=heat_potato.explicit-short**")
    demo.page.locator("[data-level='explicit-short']").focus()
    demo.page.keyboard.press("ArrowLeft")
    demo.page.wait_for_url("**episode=heat_potato.explicit-noised**")
    expect(demo.page.locator("[data-level='explicit-noised']")).to_be_focused()
    demo.page.select_option("#task-type", label="Clean & Place")
    demo.page.wait_for_url(lambda url: "heat_potato" not in url)
    assert "explicit-noised" in demo.page.url


def test_expressions_and_names_can_be_shown_and_hidden(visit):
    demo = visit(HERE)
    page = demo.page
    vague = page.locator(".ask .re:not(.ex) sup").first
    expect(vague).to_be_hidden()
    page.keyboard.press("e")
    expect(vague).to_be_visible()
    page.keyboard.press("n")
    expect(page.locator(".wide-plan .names")).to_be_visible()
    page.keyboard.press("p")
    expect(page.locator(".tree")).to_be_visible()
    before = demo.steps
    page.locator(".tree button[data-type=Fridge]").click()
    page.locator(".menu [data-skill='find a fridge']").click()
    demo.wait_for_step(before + 1)
    expect(page.locator(".tree")).to_be_visible()


def test_the_expert_s_way_can_be_looked_up_and_one_can_start_over(visit, solution):
    demo = visit(HERE)
    demo.do("find a fridge")
    demo.page.click("[data-do=solution]")
    expect(demo.page.locator(".solution li")).to_have_count(len(solution))
    demo.page.click("[data-do=again]")
    demo.wait_for_step(0)
    expect(demo.page.locator(".solution")).to_have_count(0)


def test_the_desktop_page_needs_no_scrolling(visit):
    demo = visit(HERE)
    size = demo.page.evaluate(
        "[document.documentElement.scrollWidth, document.documentElement.scrollHeight]"
    )
    assert size == [1280, 800]
    for part in (".ask", ".wide-plan .plan", ".buttons .done", ".legend"):
        box = demo.page.locator(part).first.bounding_box()
        assert box
        assert box["y"] + box["height"] <= 800


def test_a_phone_shows_everything_without_scrolling_sideways(visit):
    phone = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True}
    demo = visit(HERE, **phone)
    page = demo.page
    assert page.evaluate("document.documentElement.scrollWidth") == 390
    expect(page.locator(".phone-plan .plan")).to_be_visible()
    box = page.locator(".phone-plan [data-type=Apple] .halo").first.bounding_box()
    assert box
    # a little beside the apple: the nearest thing within reach of a finger counts
    page.touchscreen.tap(box["x"] + box["width"] + 6, box["y"] + box["height"] / 2)
    expect(page.locator(".menu [data-skill='find an apple']")).to_be_visible()
    for target in page.locator(".menu [data-skill]").all():
        area = target.bounding_box()
        assert area
        assert area["height"] >= 44
    page.locator(".menu [data-skill='find an apple']").tap()
    demo.wait_for_step(1)
    expect(page.locator(".surface .btn").first).to_be_visible()
    page.tap("[data-do=setup]")
    expect(page.locator("#setup [data-level]").first).to_be_visible()
    assert page.evaluate("document.documentElement.scrollWidth") == 390


def test_dark_follows_the_system_until_one_chooses(visit):
    demo = visit(HERE, color_scheme="dark")
    page = demo.page
    expect(page.locator("html")).to_have_attribute("data-theme", "dark")
    background = "getComputedStyle(document.body).backgroundColor"
    assert page.evaluate(background) == "rgb(18, 20, 24)"
    page.click("[data-do=theme]")
    expect(page.locator("html")).to_have_attribute("data-theme", "light")
    page.reload()
    demo.settled()
    expect(page.locator("html")).to_have_attribute("data-theme", "light")


def test_what_is_closed_keeps_its_secrets_in_the_page_s_source(visit):
    demo = visit("?episode=cool_apple.implicit-standard&actor=me")
    html = demo.page.content()
    assert "|+0" not in html
    assert "Egg|" not in html


def test_an_episode_is_found_by_typing_and_opened_by_the_keyboard(visit):
    demo = visit(HERE)
    page = demo.page
    page.click("[data-do=find]")
    expect(page.locator("#found [data-open]").first).to_be_visible()
    page.keyboard.type("toddler chill counter")
    expect(page.locator("#found [role=status]")).to_contain_text("Nothing fits")
    page.fill("#finder [data-seek=words]", "chill bib")
    expect(page.locator("#found [data-open]")).to_have_count(1)
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    page.wait_for_url("**episode=cool_apple.mixed-noised**")
    expect(page.locator("#finder")).to_be_hidden()
    page.click("[data-do=find]")
    page.keyboard.press("Escape")
    expect(page.locator("#finder")).to_be_hidden()
