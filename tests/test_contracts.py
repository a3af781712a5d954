"""What every registered part must do; a new file in its folder is tested without new tests."""

from itertools import product

import pytest

from reibench.backends import backends
from reibench.errors import UnknownName
from reibench.methods import methods
from reibench.planners import planners
from reibench.rollout import Rollout, drive
from reibench.run import RunSpec, instruct, make_planner, make_world, needs_model
from reibench.skill import SKILLS
from reibench.worlds import worlds
from reibench.worlds.naming import create_world

ANSWERS = [" find a potato", " pick up the potato", " done"]


@pytest.fixture
def obliging():
    """Make a backend that says something sensible to a method and then plans three steps."""
    from reibench.backends import Alternative, Generation, Selection

    class Obliging:
        name = "scripted:obliging"

        def __init__(self):
            self.skills = iter(ANSWERS)

        def generate(self, prompt, *, max_tokens=128, stop=(), grammar=""):
            if prompt.begun.startswith("(:goal"):
                return Generation(" (hot potato)))")
            return Generation("Heat the potato.")

        def choose(self, prompt, options):
            if " done" not in options:
                return Selection(options[0])
            return Selection(next(self.skills), alternatives=(Alternative("done", 0.2),))

        def close(self):
            pass

    return Obliging()


@pytest.mark.parametrize(("planner", "method"), list(product(planners.names(), methods.names())))
def test_every_planner_works_with_every_method(planner, method, episode, obliging):
    spec = RunSpec(planner=planner, method=method, model="scripted:x")
    rollout = Rollout(episode, make_world(spec))
    rollout.start()
    backend = obliging if needs_model(planner) else None
    told = instruct(spec, episode, backend)
    assert told.text
    assert told.original == episode.dialogue.instruction.text
    steps = list(drive(rollout, make_planner(spec, episode, backend), told))
    assert steps
    assert {step.decision.skill for step in steps} <= set(SKILLS)
    assert rollout.said_done or rollout.exhausted


WORLDS = [
    pytest.param("embedded", {}, id="embedded"),
    pytest.param("ai2thor:stand-in", {"REIBENCH_UNITY_SERVER": "fifo"}, id="fifo"),
    pytest.param("ai2thor:stand-in", {"REIBENCH_UNITY_SERVER": "wsgi"}, id="wsgi"),
]
"""Every kind of world, in the variant that runs anywhere, with its settings."""


def test_every_kind_of_world_is_under_contract():
    assert {world.values[0].partition(":")[0] for world in WORLDS} == set(worlds.names())


@pytest.mark.parametrize(("name", "settings"), WORLDS)
def test_every_world_starts_the_same_each_time_and_refuses_without_breaking(
    name, settings, episode, monkeypatch
):
    for variable, value in settings.items():
        monkeypatch.setenv(variable, value)
    world = create_world(name)
    first, again = world.reset(episode.task), world.reset(episode.task)
    assert first == again
    assert world.skills == SKILLS
    assert not first.solved
    for skill in SKILLS:
        event = world.step(skill)
        assert event.success or event.message, skill
        assert event.goals
    world.close()


@pytest.mark.parametrize("registry", [planners, methods, backends, worlds], ids=lambda r: r.kind)
def test_an_unknown_name_says_what_is_known(registry):
    known = registry.names()[0]
    with pytest.raises(UnknownName, match=f"Did you mean '{known}'"):
        registry.create(known + "x")


@pytest.mark.parametrize("registry", [planners, methods, backends, worlds], ids=lambda r: r.kind)
def test_a_name_is_registered_once(registry):
    name = registry.names()[0]
    with pytest.raises(ValueError, match="registered twice"):
        registry.register(name)(object)
