"""Free rewriting."""

import pytest

from reibench.backends.scripted import ScriptedBackend
from reibench.dialogue import Dialogue, Utterance
from reibench.methods.tocc import TaskOrientedContextCognition

TALK = (
    Utterance("human", "This apple is warm."),
    Utterance("robot", "Indeed."),
    Utterance("human", "Chill the fruit for me."),
)


def rewritten(answer):
    backend = ScriptedBackend([answer])
    return TaskOrientedContextCognition().instruct(Dialogue(TALK), backend), backend


def test_the_model_is_asked_in_chat_with_the_dialogue_in_the_papers_words():
    _, backend = rewritten("Chill the apple.")
    [prompt] = backend.prompts
    assert prompt.chat
    assert prompt.text.startswith("Human pending instruction may contain vague referring")
    assert (
        "Human previous inquiry (not required to execute): This apple is warm.\n"
        "Human pending instruction: Chill the fruit for me.\n"
    ) in prompt.text
    assert "Indeed" not in prompt.text


@pytest.mark.parametrize(
    "answer",
    [
        "Chill the apple for me.",
        ' "Chill the apple for me."\n',
        "Human pending instruction: Chill the apple for me.",
        "Sure, here are the clear instructions:\n\n1. Chill the apple for me.",
        "Clear instruction: Chill the apple\n- for me.",
    ],
)
def test_the_planner_is_told_the_restated_instruction_only(answer):
    told, _ = rewritten(answer)
    assert told.text == "Chill the apple for me."
    assert told.context == ()
    assert (told.rewritten, told.answer) == (True, answer)


@pytest.mark.parametrize("answer", ["", "\n\n", "1.", "Instruction:"])
def test_an_empty_answer_leaves_the_instruction_as_it_was_and_shows(answer):
    told, _ = rewritten(answer)
    assert told.text == told.original == "Chill the fruit for me."
    assert (told.rewritten, told.answer) == (False, answer)
