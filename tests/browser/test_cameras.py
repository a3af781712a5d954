"""The demo in a world that renders: AI2-THOR's client over the wire stand-in."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import expect

from tests.browser import serving

HERE = "?episode=heat_potato.mixed-noised&actor=me"


@pytest.fixture(scope="module")
def rendering(chromium, tmp_path_factory) -> Iterator[str]:
    """Serve the demo over the stand-in."""
    database = tmp_path_factory.mktemp("cameras") / "demo.db"
    with serving.app(database, world="ai2thor:stand-in") as address:
        yield address


def shown(demo) -> list[str]:
    """Return the addresses of the pictures, once they are loaded."""
    images = demo.page.locator(".cameras img")
    expect(images).to_have_count(2)
    demo.page.wait_for_function(
        "[...document.querySelectorAll('.cameras img')].every(i => i.naturalWidth >= 300)"
    )
    return [image.get_attribute("src") for image in images.all()]


def test_an_episode_is_solved_with_frames_of_every_step(visit, rendering, solution):
    demo = visit(HERE, address=rendering)
    seen = [shown(demo)]
    for skill in solution:
        demo.do(skill)
        seen.append(shown(demo))
    expect(demo.page.locator(".goals .box.y")).to_have_count(3)
    assert len({tuple(pair) for pair in seen}) == len(solution) + 1
    expect(demo.page.locator(".cameras .chip")).to_have_text("protocol-verified stand-in")
    words = demo.page.locator(".cameras img").first.get_attribute("alt")
    assert words.startswith(f"What the robot sees after step {len(solution)}: ")
    demo.page.reload()
    demo.settled()
    assert shown(demo) == seen[-1]
    demo.page.click("[data-do=done]")
    expect(demo.page.locator(".verdict strong")).to_have_text(
        "Done: the instruction is carried out."
    )
    assert shown(demo) == seen[-1]


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_pictures_fit_the_page_and_can_fill_the_rooms_place(visit, rendering, scheme):
    demo = visit(HERE, address=rendering, color_scheme=scheme)
    shown(demo)
    height = "document.documentElement.scrollHeight"
    assert demo.page.evaluate(height) == 800
    small = demo.page.locator(".cameras img").first.bounding_box()["height"]
    demo.page.click("button[data-room=camera]")
    expect(demo.page.locator(".wide-plan")).to_be_hidden()
    assert demo.page.locator(".cameras img").first.bounding_box()["height"] > small
    assert demo.page.evaluate(height) == 800


def test_on_a_phone_the_pictures_are_under_the_plan(visit, rendering):
    demo = visit(
        HERE, address=rendering, viewport={"width": 390, "height": 844}, is_mobile=True,
        has_touch=True,
    )  # fmt: skip
    shown(demo)
    plan = demo.page.locator(".phone-plan").bounding_box()
    eye = demo.page.locator(".cameras figure").first.bounding_box()
    assert eye["y"] >= plan["y"] + plan["height"] - 1
    assert demo.page.evaluate("document.documentElement.scrollWidth") == 390


def test_only_frames_of_records_are_served(visit, rendering):
    demo = visit(HERE, address=rendering)
    [eye, _] = shown(demo)
    get = demo.page.request.get
    assert get(f"{rendering}{eye}").headers["content-type"] == "image/png"
    record = eye.split("/")[2]
    for address in (
        f"/frames/{record}/99-robot.png",
        f"/frames/{record}/0-below.png",
        f"/frames/{record}/-1-robot.png",
        "/frames/000000000000/0-robot.png",
        f"/frames/..%2F{record}/0-robot.png",
        f"/frames/%2e%2e/demo.db-frames/{record}/0-robot.png",
        f"/frames/{record}/..%2f..%2fdemo.db",
        "/frames/../demo.db",
    ):
        answer = get(f"{rendering}{address}")
        assert not answer.headers["content-type"].startswith("image/"), address
        assert b"SQLite" not in answer.body(), address


def test_the_embedded_world_shows_no_camera(visit):
    demo = visit(HERE)
    expect(demo.page.locator(".cameras")).to_have_count(0)
    expect(demo.page.locator("button[data-room]")).to_have_count(2)
