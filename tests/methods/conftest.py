"""A dialogue to resolve."""

import pytest

from reibench.dialogue import Dialogue, Utterance


@pytest.fixture
def dialogue() -> Dialogue:
    talk = (
        ("human", "I dropped an egg."),
        ("robot", "Never mind."),
        ("human", "Warm the oval thing and put it on the desk."),
    )
    return Dialogue(tuple(Utterance(speaker, text) for speaker, text in talk))
