"""Pictures for the README, taken of the real app: `python -m tests.browser.screenshots`."""

import argparse
import os
import tempfile
from collections.abc import Sequence
from pathlib import Path

from playwright.sync_api import Browser, Page

from reibench.dataset.files import shipped_episodes
from reibench.methods import Instruction
from reibench.planners.expert import Expert
from reibench.rollout import Rollout, drive
from reibench.store import Store
from reibench.worlds import worlds
from study.access import PASSWORD
from study.enrolment import Enrolment
from study.reading import read_study
from study.simulating import Character, Simulation
from tests.browser import serving
from tests.study.conftest import EXAMPLE

FOLDER = serving.ROOT / "docs" / "screenshots"
SHOWN = "heat_potato.implicit-standard"
DESKTOP = {"width": 1280, "height": 800}
PHONE = {"width": 390, "height": 844}
PATIENCE = 600_000
"""Milliseconds two runs of a model may take."""


def expert_skills(episode_id: str) -> list[str]:
    """Return the skills that solve an episode, in words."""
    episode = next(each for each in shipped_episodes() if each.id == episode_id)
    rollout = Rollout(episode, worlds.create("embedded"))
    rollout.start()
    steps = drive(rollout, Expert(episode.task.goal), Instruction(text="", original=""))
    return [step.decision.skill.text for step in steps]


def visit(browser: Browser, address: str, **options: object) -> Page:
    """Open the demo as a new visitor."""
    page = browser.new_context(**{"viewport": DESKTOP, **options}).new_page()  # type: ignore[arg-type]
    page.goto(address)
    page.wait_for_selector("#choice")
    page.wait_for_selector("#act, #sbs", state="attached")
    page.wait_for_timeout(600)
    return page


def act(page: Page, skills: Sequence[str]) -> None:
    """Carry out skills by the picker."""
    for skill in skills:
        number = int(page.get_attribute("#act", "data-expected") or 0) + 1
        page.fill("#skill", skill)
        page.press("#skill", "Enter")
        page.wait_for_selector(f"#act[data-expected='{number}']")
    page.wait_for_timeout(400)


def save(page: Page, name: str) -> None:
    """Write what the page shows to the folder of pictures."""
    page.screenshot(path=FOLDER / f"{name}.png")


def person(browser: Browser, address: str, skills: Sequence[str]) -> None:
    """Take the pictures of somebody who acts."""
    wanted = f"{address}/?episode={SHOWN}&actor=me"
    for scheme, suffix in (("light", ""), ("dark", "-dark")):
        page = visit(browser, wanted, color_scheme=scheme)
        if not suffix:
            save(page, "start")
        page.click("[data-do=marks]")
        middle = next(at for at, skill in enumerate(skills) if skill.startswith("put down"))
        act(page, [*skills[: middle - 1], "open the fridge", skills[middle - 1]])
        page.hover(".wide-plan [data-type=Apple]")
        page.fill("#skill", "pot")
        page.wait_for_timeout(300)
        save(page, f"mid-episode{suffix}")
        if not suffix:
            page.fill("#skill", "")
            act(page, skills[middle:])
            page.click("[data-do=done]")
            page.wait_for_selector(".act .verdict")
            page.mouse.move(5, 5)
            page.wait_for_timeout(400)
            save(page, "success")
    page = visit(browser, wanted, viewport=PHONE, has_touch=True, is_mobile=True)
    act(page, skills[:3])
    page.evaluate("window.scrollTo(0, 0)")
    page.wait_for_timeout(300)
    save(page, "phone")


def planners(browser: Browser, address: str, episodes: Sequence[str]) -> str:
    """Take the picture of two runs, of the first of `episodes` that only TOCC gets right if any.

    Returns the episode shown.
    """
    shown = ""
    for shown in episodes:
        page = visit(browser, f"{address}/?episode={shown}&actor=side")
        page.click("#sbs [data-do=watch]")
        page.wait_for_selector("#sbs.over", timeout=PATIENCE)
        page.wait_for_timeout(800)
        tones = [each.get_attribute("class") or "" for each in page.locator(".verd .verdict").all()]
        if "bad" in tones[0] and "good" in tones[1]:
            break
    page.mouse.move(5, 300)
    save(page, "side-by-side")
    return shown


def cases(browser: Browser, address: str) -> None:
    """Take the pictures of a recorded case and of wording one's own."""
    page = browser.new_context(viewport=DESKTOP).new_page()
    page.goto(f"{address}/cases?kind=helps&level=implicit-short")
    page.click("#list .case:has-text('apple')")
    page.wait_for_timeout(600)
    save(page, "cases")
    page.goto(f"{address}/own?room=kitchen-6")
    page.fill("#before", "Human: I have eaten nothing since five.\nRobot: There is fruit in here.")
    page.fill("#request", "Then put the round red thing somewhere cold, would you?")
    save(page, "own-words")


def comparison(browser: Browser, database: Path) -> None:
    """Take the picture of the comparison of a database's runs."""
    with serving.app(database) as address:
        page = browser.new_context(viewport={"width": 1280, "height": 900}).new_page()
        page.goto(f"{address}/comparison")
        page.wait_for_timeout(600)
        save(page, "comparison")


def participants(browser: Browser, database: Path) -> None:
    """Take the pictures of somebody on their way through a study."""
    Enrolment(Store(database)).create(read_study(EXAMPLE))
    with serving.app(database) as address:
        page = browser.new_context(viewport=DESKTOP).new_page()
        page.goto(f"{address}/s/household")
        page.wait_for_selector("#agree")
        save(page, "study-consent")
        page.check("#agree")
        page.click("[data-do=agree]")
        page.click("[data-do=read]")
        _at(page, "practice")
        page.click("[data-do=done]")
        _at(page, "quiz")
        for question in page.locator("#questions fieldset").all():
            question.locator("input").nth(1).check()
        page.click("[data-do=answer]")
        _at(page, "trial")
        act(page, ["find a drawer", "open the drawer"])
        save(page, "study-trial")
        page.set_viewport_size(PHONE)
        page.wait_for_timeout(600)
        page.evaluate("scrollTo(0, 0)")
        save(page, "study-phone")
        page.set_viewport_size(DESKTOP)
        page.click("[data-do=done]")
        _at(page, "after")
        page.check("input[name=confidence][value='4']")
        save(page, "study-after")


def _at(page: Page, stage: str) -> None:
    page.wait_for_selector(f"#where[data-stage={stage}]", state="attached")
    page.wait_for_timeout(400)


def researchers(browser: Browser, database: Path) -> None:
    """Take the pictures of what researchers see of a study that simulated people try."""
    enrolment = Enrolment(Store(database))
    study = read_study(EXAMPLE)
    enrolment.create(study)
    Simulation(enrolment, study.name, Character(), 1).run(14, together=2, tell=print)
    os.environ[PASSWORD] = secret = "only for pictures"
    with serving.app(database) as address:
        known = {"username": "", "password": secret}
        page = browser.new_context(viewport=DESKTOP, http_credentials=known).new_page()
        for name, path in (("study-researchers", ""), ("study-analysis", "/analysis")):
            page.goto(f"{address}/admin/{study.name}{path}?everybody=true")
            page.wait_for_timeout(600)
            save(page, name)


def main() -> None:
    """Take all pictures, or only those of a person (no language model) or of planners (one)."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--model", default="", help="for the side by side; the best one if empty")
    parser.add_argument("--episodes", default=SHOWN, help="to try for it, with commas")
    parser.add_argument("--only", choices=("person", "planners", "cases", "study"))
    parser.add_argument("--runs", type=Path, help="a database of runs, for the comparison")
    given = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    with (
        tempfile.TemporaryDirectory() as folder,
        serving.app(Path(folder) / "demo.db", model=given.model) as address,
        serving.browser() as browser,
    ):
        if given.only in (None, "person"):
            person(browser, address, expert_skills(SHOWN))
        if given.only in (None, "planners"):
            planners(browser, address, given.episodes.split(","))
        if given.only in (None, "cases"):
            cases(browser, address)
        if given.only in (None, "study"):
            participants(browser, Path(folder) / "taking-part.db")
            researchers(browser, Path(folder) / "study.db")
        if given.runs:
            comparison(browser, given.runs)


if __name__ == "__main__":
    main()
