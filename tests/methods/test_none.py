"""No method."""

from reibench.backends.scripted import ScriptedBackend
from reibench.dialogue import Dialogue, Utterance
from reibench.methods.none import NoMethod


def test_the_planner_is_shown_the_human_turns_as_they_were_said():
    talk = (("human", "I like apples."), ("robot", "Who doesn't."), ("human", "Bring me one."))
    dialogue = Dialogue(tuple(Utterance(speaker, text) for speaker, text in talk))
    backend = ScriptedBackend([])
    told = NoMethod().instruct(dialogue, backend)
    assert (told.text, told.context) == ("Bring me one.", ("I like apples.",))
    assert not told.rewritten
    assert backend.prompts == []
