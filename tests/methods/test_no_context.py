"""The instruction alone."""

from reibench.backends.scripted import ScriptedBackend
from reibench.methods.no_context import NoContext
from reibench.planners.telling import told


def test_the_planner_reads_the_instruction_and_none_of_the_dialogue(dialogue):
    backend = ScriptedBackend([])
    shown = NoContext().instruct(dialogue, backend)
    assert told(shown) == "Human pending instruction: Warm the oval thing and put it on the desk.\n"
    assert backend.prompts == []
