"""Demonstrations before the dialogue."""

import re

from reibench.backends.scripted import ScriptedBackend
from reibench.dataset.script_set import WORDS_IN_A_ROW, word_runs
from reibench.dataset.scripts import read_scripts
from reibench.methods.icl import InContextLearning, demonstrations
from reibench.planners.telling import told
from reibench.view.icons import ASSETS


def test_two_solved_examples_stand_before_the_dialogue_which_stays(dialogue):
    backend = ScriptedBackend([])
    text = told(InContextLearning().instruct(dialogue, backend))
    shown, _, rest = text.partition(
        "\n\nHuman previous inquiry (not required to execute): I dropped"
    )
    assert shown.count("Human pending instruction: ") >= 1
    assert demonstrations().count("Clear instruction: ") == 2
    assert text.index("Clear instruction") < text.index("I dropped an egg.")
    assert rest.endswith("Warm the oval thing and put it on the desk.\n")
    assert backend.prompts == []


def test_demonstrations_share_no_five_words_with_any_script():
    # labels and the sentence that grounds an expression are ours and stand in no script anyway
    words = re.findall(r"[\w'’]+", demonstrations().lower())
    runs = {tuple(words[at : at + WORDS_IN_A_ROW]) for at in range(len(words))}
    for path in sorted((ASSETS / "scripts").glob("*.txt")):
        for script in read_scripts(path):
            assert not runs & word_runs(script), script.id
