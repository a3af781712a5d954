"""Dialogues as models write them, and as they are shown to models."""

import re
from collections.abc import Sequence

from reibench.dataset.build.asking import Unfit
from reibench.dataset.check_levels import sentences
from reibench.dialogue import Speaker

TURNS: tuple[Speaker, ...] = ("human", "robot") * 3 + ("human",)
LEAST_WORDS = 20
_SPEAKER = re.compile(
    r"^\W*(?:\*\*)?(Human|Alice|User|Robot|Assistant)(?:\*\*)?\s*:(?:\*\*)?\s*", re.I
)
_CURLY = str.maketrans({"“": '"', "”": '"', "‘": "'", "’": "'", "…": "..."})


def read_dialogue(answer: str) -> tuple[str, ...]:
    """Return the seven turns in a model's answer; raises Unfit when there are others."""
    said: list[tuple[Speaker, str]] = []
    for line in answer.translate(_CURLY).splitlines():
        found = _SPEAKER.match(line)
        text = " ".join(line[found.end() if found else 0 :].split()).strip('* "')
        if not text or (not found and _is_heading(text)):
            continue
        if found:
            speaker: Speaker = "robot" if found[1].lower() in ("robot", "assistant") else "human"
            said.append((speaker, text))
        elif said:
            said[-1] = (said[-1][0], f"{said[-1][1]} {text}")
    speakers = tuple(speaker for speaker, _ in said)
    if speakers != TURNS:
        raise Unfit(
            "not seven turns",
            f"There must be seven lines, from Human and Robot in turn, the last from Human; there"
            f" are {len(said)} ({', '.join(speakers[:9]) or 'none'}).",
        )
    return tuple(text for _, text in said)


def _is_heading(text: str) -> bool:
    return text.rstrip(":").lower() in ("instruction", "context memory", "dialogue", "output")


def show(turns: Sequence[str]) -> str:
    """Return a dialogue as prompts hold it."""
    pairs = zip(TURNS, turns, strict=True)
    return "\n".join(f"{speaker.capitalize()}: {text}" for speaker, text in pairs)


def check_lengths(turns: Sequence[str]) -> None:
    """Raise Unfit when a turn of the context is shorter than appendix B.1 asks."""
    for number, text in enumerate(turns[:-1], start=1):
        if (words := len(text.split())) < LEAST_WORDS:
            raise Unfit(
                "a short turn",
                f"Line {number} has {words} words; each line needs no fewer than {LEAST_WORDS}.",
            )


def in_sentences(turns: Sequence[str]) -> list[list[str]]:
    """Return each turn's sentences."""
    return [sentences(text) for text in turns]
