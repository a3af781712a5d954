"""Asking again, and for how long to wait."""

from datetime import UTC, datetime, timedelta
from email.utils import format_datetime

import pytest

from reibench.backends.patience import Exhausted, Patience, Trouble, asked_wait, spent_for


@pytest.fixture
def slept(monkeypatch):
    """Keep the clock still but for what is slept."""
    sleeps = []
    monkeypatch.setattr("reibench.backends.patience.sleep", sleeps.append)
    monkeypatch.setattr("reibench.backends.patience.monotonic", lambda: sum(sleeps))
    return sleeps


def failing(*troubles):
    left = list(troubles)

    def ask():
        if left:
            raise left.pop(0)
        return "answer"

    return ask


def test_it_waits_about_twice_as_long_each_time_up_to_a_limit(slept):
    ask = failing(*[Trouble("busy")] * 5)
    assert Patience(first=1, longest=5).persist(ask) == "answer"
    for seconds, most in zip(slept, (1, 2, 4, 5, 5), strict=True):
        assert most / 2 <= seconds <= most


def test_it_waits_as_long_as_it_is_asked_to(slept):
    assert Patience(first=1).persist(failing(Trouble("busy", wait=40))) == "answer"
    assert sum(slept) == pytest.approx(40)


def test_it_gives_up_after_so_many_tries_and_at_once_where_it_should_wait_for_an_hour(slept):
    with pytest.raises(Exhausted, match="busy; asked 3 times, then given up"):
        Patience(tries=3).persist(failing(*[Trouble("busy")] * 9))
    before = len(slept)
    with pytest.raises(Exhausted, match="asks to wait 3600 s; asked once"):
        Patience().persist(failing(Trouble("busy", wait=3600)))
    assert len(slept) == before


def test_it_sends_no_more_a_minute_than_it_may(slept):
    patience = Patience(per_minute=30)
    for _ in range(4):
        patience.persist(lambda: "answer")
    assert sum(slept) == pytest.approx(6)


@pytest.mark.parametrize(
    ("headers", "seconds"),
    [
        ({"retry-after": "7"}, 7),
        ({"retry-after": "1.5"}, 1.5),
        ({"retry-after-ms": "250", "retry-after": "7"}, 0.25),
        ({"x-ratelimit-remaining-requests": "0", "x-ratelimit-reset-requests": "1m2s"}, 62),
        ({"x-ratelimit-remaining-tokens": "0", "x-ratelimit-reset-tokens": "20ms"}, 0.02),
        ({"x-ratelimit-remaining-requests": "3", "x-ratelimit-reset-requests": "1m"}, 0),
        ({"retry-after": "soon"}, 0),
        ({}, 0),
    ],
)
def test_it_reads_how_long_a_server_asks_to_wait(headers, seconds):
    assert asked_wait(headers) == pytest.approx(seconds)


def test_it_reads_a_date_to_wait_for():
    later = datetime.now(UTC) + timedelta(seconds=100)
    assert 90 < asked_wait({"retry-after": format_datetime(later, usegmt=True)}) <= 100


def test_it_waits_where_the_tokens_left_are_not_enough_for_one_more_question():
    headers = {"x-ratelimit-remaining-tokens": "900", "x-ratelimit-reset-tokens": "12s"}
    assert spent_for(headers, tokens=1000) == 12
    assert spent_for(headers, tokens=800) == 0
