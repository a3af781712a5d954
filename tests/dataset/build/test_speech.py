"""Dialogues as models write them."""

import pytest

from reibench.dataset.build.asking import Unfit
from reibench.dataset.build.speech import read_dialogue, show

TURNS = ("One.", "Two.", "Three.", "Four.", "Five.", "Six.", "Seven.")


@pytest.mark.parametrize(
    "answer",
    [
        show(TURNS),
        show(TURNS).replace("\n", "\n\n"),
        show(TURNS).replace("Human", "Alice"),
        show(TURNS).replace("Human:", "**Human**:").replace("Robot:", "**Robot:**"),
        "Context Memory:\n" + show(TURNS).replace("Human: Seven", "Instruction:\nHuman: Seven"),
        show(TURNS).replace("Three.", "Three.\n").replace("Human: Two", "Robot: Two"),
    ],
)
def test_seven_turns_are_read_however_they_are_dressed(answer):
    assert read_dialogue(answer) == TURNS


def test_a_turn_may_go_over_lines_and_quotes_are_straightened():
    answer = show(TURNS).replace("Three.", "Three\nand “a half”.")
    assert read_dialogue(answer)[2] == 'Three and "a half".'


@pytest.mark.parametrize("answer", ["", "Hello.", show(TURNS).rsplit("\n", 1)[0]])
def test_anything_else_is_refused(answer):
    with pytest.raises(Unfit, match="There must be seven lines"):
        read_dialogue(answer)
