"""Who may see what participants did: whoever gave the password, or sits at the server."""

import pytest
from fastapi import FastAPI, Request
from fastapi.testclient import TestClient

from study.access import COOKIE, PASSWORD, is_researcher
from study.admin import build
from study.enrolment import Enrolment

SECRET = "correct horse"


@pytest.fixture
def ask(enrolment):
    """Ask a server whether it takes one for a researcher."""

    def ask(client=("127.0.0.1", 5), **headers):
        app = FastAPI()

        @app.get("/who")
        def who(request: Request) -> bool:
            return is_researcher(request)

        app.mount("/admin", build(Enrolment(enrolment.store)))
        here = "http://127.0.0.1:7860"
        asking = TestClient(app, base_url=here, client=client, follow_redirects=False)
        asking.headers.update(headers)
        return asking

    return ask


def test_without_a_password_whoever_sits_at_the_server_is_one(ask, monkeypatch):
    monkeypatch.delenv(PASSWORD, raising=False)
    assert ask().get("/who").json() is True
    assert ask(client=("192.168.1.7", 5)).get("/who").json() is False
    for header in ("X-Forwarded-For", "Forwarded", "X-Real-IP"):
        assert ask(**{header: "127.0.0.1"}).get("/who").json() is False


def test_a_page_elsewhere_whose_name_leads_here_is_none(ask, monkeypatch):
    monkeypatch.delenv(PASSWORD, raising=False)
    for name in ("localhost:7860", "[::1]:7860", "127.0.0.1"):
        assert ask(Host=name).get("/who").json() is True
    for name in ("evil.example:7860", "localhost.evil.example", "127.0.0.1.evil.example"):
        assert ask(Host=name).get("/who").json() is False


def test_a_password_that_is_too_short_is_none(ask, monkeypatch):
    monkeypatch.setenv(PASSWORD, "short")
    assert ask().get("/who").json() is True
    assert ask().get("/admin/-/cases", auth=("", "short")).status_code == 403


def test_with_a_password_only_who_gave_it_is_one(ask, monkeypatch):
    monkeypatch.setenv(PASSWORD, SECRET)
    client = ask()
    assert client.get("/who").json() is False
    assert client.get("/admin/-/cases").status_code == 401
    assert client.get("/admin/-/cases", auth=("", "wrong password")).status_code == 401
    assert client.get("/who").json() is False
    answer = client.get("/admin/-/cases", auth=("", SECRET))
    assert (answer.status_code, answer.headers["location"]) == (303, "/cases")
    assert "HttpOnly" in answer.headers["set-cookie"]
    assert "SameSite=strict" in answer.headers["set-cookie"]
    assert SECRET not in answer.headers["set-cookie"]
    assert client.get("/who").json() is True


def test_a_forged_or_old_cookie_is_worth_nothing(ask, monkeypatch):
    monkeypatch.setenv(PASSWORD, SECRET)
    client = ask()
    client.get("/admin/-/cases", auth=("", SECRET))
    monkeypatch.setenv(PASSWORD, "another password")
    assert client.get("/who").json() is False
    for forged in ("", "x", "0" * 64):
        client.cookies.set(COOKIE, forged)
        assert client.get("/who").json() is False
