"""A running app, a browser, and a page to click through."""

import os
from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser import serving

expect.set_options(timeout=20_000)


@pytest.fixture(scope="session")
def chromium() -> Iterator[Browser]:
    if not serving.chromium():
        if os.environ.get("CI"):
            pytest.fail("CI needs Chromium (Debian's package chromium)")
        pytest.skip("Chromium is not installed (Debian's package chromium)")
    with serving.browser() as running:
        yield running


@pytest.fixture(scope="session")
def app(chromium, tmp_path_factory) -> Iterator[str]:
    """Serve with the packaged language model."""
    with serving.app(tmp_path_factory.mktemp("app") / "demo.db") as address:
        yield address


class Demo:
    """One browser with the demo open."""

    def __init__(self, page: Page, address: str) -> None:
        self.page = page
        self.address = address
        self.trouble: list[str] = []
        page.on("pageerror", lambda error: self.trouble.append(str(error)))
        page.on("request", self._note_stranger)

    def _note_stranger(self, request) -> None:
        if not request.url.startswith((self.address, "data:", "blob:")):
            self.trouble.append(f"asked a stranger: {request.url}")

    def open(self, query: str = "") -> "Demo":
        self.page.goto(f"{self.address}/{query}")
        return self.settled()

    def settled(self) -> "Demo":
        """Wait until the page shows an answer to everything that was asked."""
        self.page.wait_for_selector("#act, #sbs", state="attached")
        self.page.wait_for_function(
            "!document.documentElement.classList.contains('busy')"
            " && document.querySelector('#choice')"
        )
        return self

    @property
    def steps(self) -> int:
        return int(self.page.get_attribute("#act", "data-expected") or 0) - 1

    def do(self, text: str) -> None:
        """Carry out a skill by the picker."""
        before = self.steps
        self.page.fill("#skill", text)
        self.page.press("#skill", "Enter")
        self.wait_for_step(before + 1)

    def wait_for_step(self, number: int) -> None:
        self.page.wait_for_selector(f"#act[data-expected='{number + 1}']")
        self.settled()

    def click_thing(self, object_type: str, skill: str) -> None:
        """Choose a thing in the room, and a skill from its menu."""
        before = self.steps
        self.page.locator(f".wide-plan [data-type={object_type}]").first.click()
        self.page.locator(f".menu [data-skill='{skill}']").click()
        self.wait_for_step(before + 1)


Visit = Callable[..., Demo]


@pytest.fixture
def visit(chromium, app) -> Iterator[Visit]:
    """Open the demo in a browser of its own, that is, as another visitor."""
    contexts = []
    demos = []

    def open_one(query: str = "", *, address: str = app, **options) -> Demo:
        options.setdefault("viewport", {"width": 1280, "height": 800})
        context = chromium.new_context(**options)
        contexts.append(context)
        demo = Demo(context.new_page(), address)
        demos.append(demo)
        return demo.open(query)

    yield open_one
    for context in contexts:
        context.close()
    assert [trouble for demo in demos for trouble in demo.trouble] == []
