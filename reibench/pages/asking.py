"""What the browser asks for: untrusted data, read once."""

import secrets
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from reibench.view.choices import offered_methods, offered_planners
from reibench.view.topbar import ACTORS, Actor

_TOKEN_LENGTH = 22
DEFAULT_PLANNER = "saycan"


@dataclass(frozen=True)
class Ask:
    """One event from the browser, with what its page showed."""

    seq: int = 0
    """Its number in the browser; the answer carries it back."""
    episode: str = ""
    actor: Actor = "me"
    sitting: str = ""
    expected: int = 0
    """The number the next step should get."""
    seconds: float | None = None
    """From the moment the page was shown to the choice, by the browser's clock."""
    skill: str = ""
    model: str = ""
    planner: str = DEFAULT_PLANNER
    method: str = ""
    """Nothing is the one that suits the model."""
    solution: bool = False
    """Whether the expert's steps are shown."""
    as_actor: Actor | None = None
    kind: str = ""
    task: str = ""
    level: str = ""
    room: str = ""
    words: str = ""
    """Of an episode that is looked for."""
    shuffle: int | None = None
    row: int | None = None
    left: str = ""
    right: str = ""
    wanted: str = ""
    """Name of a model to fetch."""

    @classmethod
    def read(cls, sent: object) -> "Ask":
        """Read what an event carries; anything odd counts as not given."""
        data: Mapping[str, Any] = sent if isinstance(sent, Mapping) else {}
        seconds = data.get("seconds")
        return cls(
            seq=_whole(data.get("seq")) or 0,
            episode=_word(data.get("episode")),
            actor=actor_called(data.get("actor")) or "me",
            sitting=_word(data.get("sitting")),
            expected=_whole(data.get("expected")) or 0,
            seconds=float(seconds) if isinstance(seconds, int | float) and seconds >= 0 else None,
            skill=_word(data.get("skill")),
            model=_word(data.get("model")),
            planner=next(
                (p for p in offered_planners() if p == data.get("planner")), DEFAULT_PLANNER
            ),
            method=next((m for m in offered_methods() if m == data.get("method")), ""),
            solution=data.get("solution") is True,
            as_actor=actor_called(data.get("as")),
            kind=_word(data.get("kind")),
            task=_word(data.get("task")),
            level=_word(data.get("level")),
            room=_word(data.get("room")),
            words=_word(data.get("words")),
            shuffle=_whole(data.get("shuffle")),
            row=_whole(data.get("row")),
            left=_word(data.get("left")),
            right=_word(data.get("right")),
            wanted=_word(data.get("wanted")),
        )


def actor_called(name: object) -> Actor | None:
    """Return the actor of that name, if there is one."""
    return next((actor for actor in ACTORS if actor == name), None)


def visitor_token(known: object) -> str:
    """Return the token a browser is known by; a new one if it has none that could be ours."""
    if isinstance(known, str) and len(known) == _TOKEN_LENGTH and known.isascii():
        return known
    return secrets.token_urlsafe(16)


def _word(value: object) -> str:
    return value[:200] if isinstance(value, str) else ""


def _whole(value: object) -> int | None:
    return value if isinstance(value, int) and not isinstance(value, bool) else None
