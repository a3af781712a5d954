"""A seed whose model answers are known: the written dialogue about the potato, as a model's."""

from dataclasses import replace

import pytest

from reibench.backends.scripted import ScriptedBackend
from reibench.dataset.build import processing
from reibench.dataset.build.asking import Asker
from reibench.dataset.build.pipeline import Outcome, build
from reibench.dataset.build.seeding import SeedInstruction, plainly
from reibench.dataset.build.speech import show
from reibench.dataset.levels import derive
from reibench.dataset.realise.nouns import Name
from reibench.dataset.scripts import SCRIPTS, read_scripts
from reibench.episode import Task
from reibench.household import load_room


@pytest.fixture(scope="session")
def gold():
    return {script.id: script for script in read_scripts(SCRIPTS / "gold.txt")}


@pytest.fixture(scope="session")
def seed(gold) -> SeedInstruction:
    script = gold["heat_potato"]
    task = Task(script.id, script.setup, script.goal)
    present = {thing.type for thing in load_room(script.setup.room).objects}
    return SeedInstruction(task, tuple(sorted(present)), plainly(script.goal))


@pytest.fixture
def answers(gold, seed, monkeypatch) -> list[str]:
    """What a perfect model says about the seed."""
    script = gold["heat_potato"]
    name = Name(script.name, script.category, script.decoy)
    monkeypatch.setattr(processing, "ambiguous_names", lambda: (name,))
    levels = derive(script)
    explicit, noised, mixed, implicit = (levels[place] for place in (0, 1, 3, 6))
    texts = [
        show([utterance.text for utterance in episode.dialogue.utterances])
        for episode in (explicit, noised, mixed, implicit)
    ]
    return ["potato", *texts]


@pytest.fixture
def outcome(gold, seed):
    """Build the seed from a list of answers."""

    def run(answers: list[str], *, retries: int = 0, sentence: str = "") -> Outcome:
        asked = replace(seed, text=sentence) if sentence else seed
        asker = Asker(ScriptedBackend(answers), retries=retries)
        [found] = build([asked], asker, list(gold.values()))
        return found

    return run
