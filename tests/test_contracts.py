"""What every registered part must do; a new file in its folder is tested without new tests."""

from itertools import product

import pytest

from reibench.backends import backends
from reibench.backends.opening import open_backend
from reibench.errors import UnknownName
from reibench.methods import methods
from reibench.planners import planners
from reibench.report import score_rows
from reibench.run import RunSpec, evaluate, make_world, needs_model
from reibench.skill import SKILLS
from reibench.tally import records_frame
from reibench.worlds import worlds
from reibench.worlds.naming import create_world
from tests.conftest import HOT_POTATO


@pytest.mark.parametrize(("planner", "method"), list(product(planners.names(), methods.names())))
def test_every_planner_works_with_every_method_from_run_to_score(planner, method, episode, store):
    model = HOT_POTATO if needs_model(planner) else ""
    spec = RunSpec(planner=planner, method=method, model=model, max_steps=12)
    backend = open_backend(model) if model else None
    [played] = evaluate(spec, [episode], backend, make_world(spec), store)
    assert played.error == ""
    assert played.said_done or len(played.steps) == spec.max_steps
    assert {step.decision.skill for step in played.steps} <= set(SKILLS)
    kept = store.record(played.id)
    assert kept.instruction == played.instruction
    assert kept.instruction.text
    assert kept.instruction.original == episode.dialogue.instruction.text
    assert [step.decision for step in kept.steps] == [step.decision for step in played.steps]
    [row] = score_rows(records_frame(store))
    assert (row["episodes"], row["breakdown"]) == (1, 0)


@pytest.mark.parametrize("name", methods.names())
def test_every_method_says_what_it_is(name):
    method = methods.create(name)
    assert method.title
    assert method.summary
    assert "\n" not in method.summary
    assert len(method.summary) < 100


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
