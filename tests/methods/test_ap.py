"""The aware prompt, and its gate."""

from dataclasses import replace

import pytest

from reibench.backends.scripted import ScriptedBackend
from reibench.dataset.levels import derive
from reibench.dataset.scripts import read_scripts
from reibench.dialogue import Dialogue, Utterance
from reibench.methods import methods
from reibench.methods.patterns import implicit_patterns
from reibench.planners.telling import told
from reibench.view.icons import ASSETS

CHECK = "I will check whether"
INFER = "I can infer their meaning"


def instructed(name, *turns):
    backend = ScriptedBackend([])
    said = Dialogue(tuple(Utterance("human", turn) for turn in turns))
    return methods.create(name).instruct(said, backend)


def test_the_robot_always_tells_itself_both_sentences_after_the_instruction():
    text = told(instructed("ap", "I dropped an egg.", "Put the egg on the desk."))
    before, _, after = text.partition("Human pending instruction: Put the egg on the desk.\n")
    assert "I dropped an egg." in before
    assert after.startswith("Robot thinks: I will check whether")
    assert INFER in after
    assert after.count("\n") == 1


@pytest.mark.parametrize(
    ("instruction", "pattern"),
    [
        ("Put it on the desk, please.", "pronoun"),
        ("Warm that lumpy thing and put it on the desk.", "stand-in"),
        ("Lay what tells me the time on the desk.", "what-clause"),
        ("Set the old tyrant on the desk.", "unnamed"),
    ],
)
def test_the_gate_opens_at_a_pattern_and_says_which(instruction, pattern):
    shown = instructed("gated-ap", "I dropped an egg.", instruction)
    [gate] = shown.artefacts
    assert (gate.kind, gate.title) == ("note", "gate")
    assert pattern in gate.text
    assert INFER in shown.notes


@pytest.mark.parametrize(
    "instruction",
    [
        "Put the egg in the sink.",
        "Warm the potato and put it on the desk.",
        "That was lovely. Put the keys in the drawer, please.",
    ],
)
def test_the_gate_stays_shut_where_things_are_named_and_says_so(instruction):
    shown = instructed("gated-ap", "I dropped an egg.", instruction)
    assert "stayed shut" in shown.artefacts[0].text
    assert CHECK in shown.notes
    assert INFER not in shown.notes


def test_with_the_gate_open_both_aware_prompts_are_the_same():
    turns = ("I dropped an egg.", "Put it on the desk.")
    gated = instructed("gated-ap", *turns)
    assert replace(gated, artefacts=()) == instructed("ap", *turns)


def test_the_gate_tells_the_levels_apart():
    opened = {"explicit": [], "mixed": []}
    for path in sorted((ASSETS / "scripts").glob("*.txt")):
        for script in read_scripts(path):
            for episode in derive(script):
                if (
                    episode.vagueness.context == "standard"
                    and episode.vagueness.reference in opened
                ):
                    found = implicit_patterns(episode.dialogue.instruction.text)
                    opened[episode.vagueness.reference].append(bool(found))
    assert sum(opened["mixed"]) >= 0.99 * len(opened["mixed"])
    assert sum(opened["explicit"]) <= 0.05 * len(opened["explicit"])
