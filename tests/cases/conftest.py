"""A database with runs of a planner without and with a method, and of people."""

from dataclasses import replace

import pytest

from reibench.cases.table import CaseTable
from reibench.methods import Instruction
from reibench.planners import Decision
from reibench.rollout import Rollout
from reibench.run import RunSpec
from reibench.skill import parse_skill

SPEC = RunSpec(planner="saycan", method="none", model="scripted:m")
TOLD = replace(SPEC, method="tocc")
PERSON = RunSpec(planner="person", method="none", model="")


@pytest.fixture
def play(store, world):
    """Play an episode by these skills as one of a spec's records, and return the record."""

    def play(episode, spec, *skills, origin="run", visitor=None, told=""):
        actor = "person" if spec.planner == "person" else ""
        record_id = store.begin(spec, episode, actor=actor, origin=origin, visitor=visitor)
        rollout = Rollout(episode, world)
        if told:
            said = episode.dialogue.instruction.text
            rollout.instruction = Instruction(text=told, original=said)
        store.started(record_id, rollout.start())
        for skill in skills:
            store.add_step(record_id, rollout, rollout.step(Decision(parse_skill(skill))))
        rollout.finish()
        return store.finish(record_id, rollout, actor or spec.actor)

    return play


@pytest.fixture
def helped(play, episode, solution):
    """Play one case that a method mends, which a person carries out too; return its records."""
    plain = play(episode, SPEC, "find an apple", "pick up the apple")
    told = play(episode, TOLD, *solution, told="Heat the potato.")
    person = play(episode, PERSON, "pick up the potato", *solution, origin="demo", visitor="ann")
    return {"plain": plain, "told": told, "person": person}


@pytest.fixture
def table(store):
    return CaseTable(store)
