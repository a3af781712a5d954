"""A study of two trials, and people on their way through it."""

from dataclasses import replace
from pathlib import Path

import pytest

from reibench.store import Store
from study.enrolment import Enrolment
from study.flow import Flow
from study.reading import read_study

EXAMPLE = Path(__file__).parents[2] / "assets" / "study" / "study.toml"


@pytest.fixture(scope="session")
def example():
    return read_study(EXAMPLE)


@pytest.fixture
def enrolment(tmp_path):
    return Enrolment(Store(tmp_path / "study.db"))


@pytest.fixture
def short(example):
    """The example with two trials."""
    return replace(example, trials=2)


@pytest.fixture
def flow(enrolment, short):
    enrolment.create(short)
    return Flow(enrolment)


@pytest.fixture
def someone(flow, short):
    """Return the token of somebody who has just arrived."""
    return flow.enrolment.arrive(short.name, {"SESSION_ID": "s", "PROLIFIC_PID": "p"}).token


def right(questions):
    """Return the right answers, and some answer where none is right."""
    kinds = {"choice": "", "scale": "4", "object": "Mug", "text": "Nice."}
    return {one.name: one.right or kinds[one.kind] or one.options[0] for one in questions}


def go_to(flow, token, stage, place=0):
    """Do what leads to a stage, and return its page."""
    page = flow.page(token)
    while (page.stage, page.place) != (stage, place):
        if page.stage == "consent":
            page = flow.consent(token, agreed=True)
        elif page.stage == "tutorial":
            page = flow.read(token)
        elif page.stage == "outcome":
            page = flow.read(token, "outcome", page.place)
        elif page.stage in ("practice", "trial"):
            page = flow.done(token, page.stage, page.place, len(page.sitting.steps) + 1)
        else:
            tries = page.participant.quiz_tries if page.stage == "quiz" else 0
            page = flow.answer(token, page.stage, page.place, right(page.questions), tries)
    return page
