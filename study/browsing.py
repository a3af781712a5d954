"""Simulated participants in a real browser: the page as people get it, served here for them."""

import shutil
import socket
import threading
import time
from importlib.util import find_spec
from pathlib import Path
from types import TracebackType
from typing import Any

from reibench.errors import ReibenchError
from study.enrolment import Enrolment
from study.stages import Page

FLAGS = (
    "--no-sandbox", "--disable-gpu", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--no-first-run",
)  # fmt: skip
WEB = Path(__file__).parents[1] / "assets" / "web"
PATIENCE = 30_000
"""Milliseconds an answer may take."""


class Browsing:
    """A server of the participants' page that marks everybody, and a Chromium to visit it."""

    def __init__(self, enrolment: Enrolment, study: str) -> None:
        self._enrolment = enrolment
        self._study = study
        self._stack: list[Any] = []

    def __enter__(self) -> "Browsing":
        """Start both; raises ReibenchError when one of them is not installed."""
        chromium = shutil.which("chromium") or shutil.which("chromium-browser")
        if find_spec("playwright") is None or not chromium:
            raise ReibenchError(
                "--browser needs Chromium (Debian's package chromium) and Playwright"
                " ('pip install playwright'); leave it out to use the page's handlers."
            )
        from playwright.sync_api import sync_playwright

        self._address = self._serve()
        self._playwright = sync_playwright().start()
        self._browser = self._playwright.chromium.launch(executable_path=chromium, args=FLAGS)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        problem: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._browser.close()
        self._playwright.stop()
        self._server.should_exit = True

    def visitor(self) -> "BrowserVisitor":
        """Return somebody with a browser of their own."""
        page = self._browser.new_context(viewport={"width": 1280, "height": 800}).new_page()
        page.set_default_timeout(PATIENCE)
        return BrowserVisitor(
            page, f"{self._address}/study/?study={self._study}", self._study, self._enrolment
        )

    def _serve(self) -> str:
        import gradio as gr
        import uvicorn
        from fastapi import FastAPI
        from fastapi.staticfiles import StaticFiles

        from reibench.pages.head import head
        from reibench.pages.wiring import MOUNTED
        from study import pages

        app = FastAPI()
        app.mount("/web", StaticFiles(directory=WEB), name="web")
        blocks = pages.build(self._enrolment, simulated=True)
        gr.mount_gradio_app(app, blocks, path="/study", head=head("study", "study"), **MOUNTED)
        with socket.create_server(("127.0.0.1", 0)) as probe:
            port = int(probe.getsockname()[1])
        config = uvicorn.Config(app, port=port, log_level="warning")
        self._server = uvicorn.Server(config)
        threading.Thread(target=self._server.run, daemon=True).start()
        while not self._server.started:
            time.sleep(0.05)
        return f"http://127.0.0.1:{port}"


class BrowserVisitor:
    """A person at a browser, who does by mouse and keyboard what a simulation decides."""

    def __init__(self, page: Any, address: str, study: str, enrolment: Enrolment) -> None:
        self._page = page
        self._address = address
        self._study = study
        self._enrolment = enrolment
        self._token = ""

    @property
    def token(self) -> str:
        """What the server knows the browser by."""
        return self._token

    def load(self) -> None:
        """Load the page."""
        self._page.goto(self._address)
        self._page.wait_for_selector("#where", state="attached")
        if not self._token:  # browsers come one after another: the last to arrive is this one
            [row] = self._enrolment.store.query(
                "select token from participants where study = ? and simulated = 1"
                " order by rowid desc limit 1",
                [self._study],
            )
            self._token = str(row["token"])

    def send(self, name: str, page: Page, **data: Any) -> None:
        """Do on the page what sends this event, and wait for the answer."""
        before = self._page.locator("[data-reply]").get_attribute("data-reply")
        match name:
            case "consent":
                self._page.check("#agree")
                self._page.click("[data-do=agree]")
            case "step":
                self._page.fill("#skill", data["skill"])
                self._page.keyboard.press("Enter")
            case "answer":
                self._answer(data["answers"], page)
            case "withdraw":
                self._page.click("[data-do=leave-study]")
                self._page.click("[data-do=withdraw]")
            case _:
                self._page.click(f"[data-do={name}]")
        self._page.wait_for_function(
            "before => document.querySelector('[data-reply]')?.dataset.reply !== before"
            " && !document.documentElement.classList.contains('busy')",
            arg=before,
        )

    def _answer(self, answers: dict[str, str], page: Page) -> None:
        for question in page.questions:
            value = answers[question.name]
            if question.kind == "text":
                self._page.fill(f"textarea[name='{question.name}']", value)
            elif question.kind == "object":
                self._page.select_option(f"select[name='{question.name}']", value)
            else:
                chosen = [
                    box
                    for box in self._page.locator(f"input[name='{question.name}']").all()
                    if box.get_attribute("value") == value
                ]
                chosen[0].check()
        self._page.click("[data-do=answer]")
