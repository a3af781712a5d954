"""Whole episodes over the embedded world, FIFO and WSGI leave equal records."""

from collections.abc import Iterator
from dataclasses import replace
from random import Random

import pytest

from reibench.episode import Episode
from reibench.methods import Instruction
from reibench.planners import Decision
from reibench.planners.expert import Expert
from reibench.rollout import Record, Rollout, drive
from reibench.skill import SKILLS
from reibench.worlds import World
from reibench.worlds.naming import create_world
from reibench.worlds.rules import rules_called

TASKS = "pick_keys stack_pencil_mug clean_lettuce heat_potato cool_apple light_card".split()
MUDDLED = 25
"""Random skills before the expert sets in, who has to make the best of what they did."""


@pytest.fixture(scope="module", params=["strict", "official"])
def rules(request) -> str:
    return request.param


@pytest.fixture(scope="module")
def three_worlds(rules, tmp_path_factory) -> Iterator[list[World]]:
    """The embedded world, and the stand-in through AI2-THOR's client over either protocol."""
    worlds = [create_world("embedded", rules_called(rules))]
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("HOME", str(tmp_path_factory.mktemp("home")))
        for server in ("fifo", "wsgi"):
            patch.setenv("REIBENCH_UNITY_SERVER", server)
            worlds.append(create_world("ai2thor:stand-in", rules_called(rules)))
        yield worlds
        for world in worlds:
            world.close()


@pytest.mark.parametrize("task", TASKS)
def test_muddled_episodes_leave_equal_records(three_worlds, episodes, task):
    episode = episodes[f"{task}.mixed-noised"]
    embedded, *others = [muddle(world, episode) for world in three_worlds]
    assert len(embedded.steps) > MUDDLED
    assert any(step.event.success for step in embedded.steps)
    assert any(not step.event.success for step in embedded.steps)
    for other in others:
        assert other.status == embedded.status
        for expected, got in zip(embedded.steps, other.steps, strict=True):
            assert got == expected
        assert other == embedded


def muddle(world: World, episode: Episode) -> Record:
    """Do things at random, then what the expert says; the times, which differ, are left out."""
    random = Random(f"muddle {episode.task.id}")
    rollout = Rollout(episode, world, max_steps=60)
    rollout.start()
    for _ in range(MUDDLED):
        held = rollout.last_event.scene.held
        near = {thing.type for thing in rollout.last_event.scene.objects}
        about = [skill for skill in SKILLS if skill.object in near]
        mine = [skill for skill in SKILLS if held and skill.object == held.type]
        rollout.step(Decision(random.choice(random.choice([about, about, mine or about]))))
    for _ in drive(rollout, Expert(episode.task.goal), Instruction(text="", original="")):
        pass
    record = rollout.record("", "expert")
    return replace(record, steps=tuple(replace(step, seconds=0.0) for step in record.steps))
