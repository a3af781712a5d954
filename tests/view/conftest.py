"""Scenes and runs to look at."""

from collections.abc import Callable
from html.parser import HTMLParser

import pytest

from reibench.household import Controller, load_room, room_names
from reibench.rollout import Rollout
from reibench.scene import Scene
from reibench.watching import Sitting

VOID = {"br", "img", "input", "meta"}


class _Balance(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.seen: list[tuple[str, dict[str, str | None]]] = []

    def handle_starttag(self, tag, attrs):
        self.seen.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.seen.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.open, f"</{tag}> closes nothing"
        assert self.open.pop() == tag


@pytest.fixture(scope="session")
def tags() -> Callable[..., list[dict[str, str | None]]]:
    """Return the attributes of every element of a kind, after checking that the markup nests."""

    def read(markup: str, *names: str) -> list[dict[str, str | None]]:
        parser = _Balance()
        parser.feed(markup)
        assert not parser.open
        return [attributes for tag, attributes in parser.seen if not names or tag in names]

    return read


@pytest.fixture(scope="session")
def rooms() -> dict[str, Scene]:
    return {name: Controller(load_room(name)).snapshot() for name in room_names()}


@pytest.fixture
def kitchen(rooms) -> Scene:
    return rooms["kitchen-1"]


@pytest.fixture
def sitting() -> Callable[..., Sitting]:
    """Show a rollout as a page would, in progress or over."""

    def show(rollout: Rollout, *, over: bool = False, actor: str = "person") -> Sitting:
        return Sitting(
            id="a1b2",
            visitor="ann",
            episode=rollout.episode,
            actor=actor,
            start=rollout.first_event,
            steps=tuple(rollout.steps),
            max_steps=rollout.max_steps,
            status=rollout.status if over else None,
            phase="over" if over else "acting",
            instruction=rollout.instruction,
        )

    return show
