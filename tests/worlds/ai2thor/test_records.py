"""The same episode through AI2-THOR's client leaves the same record as in this process."""

import pytest

from reibench.run import RunSpec, evaluate, make_world
from reibench.worlds.naming import create_world, resolve_world, verified

TASKS = [
    "pick_keys",
    "stack_pencil_mug",
    "clean_lettuce",
    "heat_potato",
    "cool_apple",
    "light_card",
]


@pytest.mark.parametrize("rules", ["strict", "official"])
def test_the_experts_records_are_equal_over_both_protocols(rules, server, episodes, store):
    chosen = [episodes[f"{task}.mixed-noised"] for task in TASKS]
    events = []
    for name in ("embedded", "ai2thor:stand-in"):
        spec = RunSpec(planner="expert", world=name, rules=rules)
        world = make_world(spec)
        records = list(evaluate(spec, chosen, None, world, store))
        world.close()
        assert [record.status for record in records] == ["success"] * len(chosen)
        again = [store.record(record.id) for record in records]
        events.append([[r.start, *(step.event for step in r.steps)] for r in again])
    assert events[0] == events[1]


def test_refusals_are_equal_too(server, episode):
    embedded, through_client = create_world("embedded"), create_world("ai2thor:stand-in")
    assert embedded.reset(episode.task) == through_client.reset(episode.task)
    for skill in embedded.skills:
        assert embedded.step(skill) == through_client.step(skill), skill
    through_client.close()


def test_rendering_changes_nothing_but_the_frames(episode, solution):
    from reibench.skill import parse_skill

    plain, rendering = (create_world("ai2thor:stand-in", frames=f) for f in (False, True))
    assert plain.reset(episode.task) == rendering.reset(episode.task)
    for text in solution:
        seen, unseen = rendering.step(parse_skill(text)), plain.step(parse_skill(text))
        assert seen == unseen
        assert [frame.camera for frame in seen.frames] == ["robot", "above"]
        assert all(frame.png.startswith(b"\x89PNG") for frame in seen.frames)
        assert unseen.frames == ()
    plain.close()
    rendering.close()


def test_a_record_names_the_unity_it_was_made_with(monkeypatch):
    monkeypatch.setenv("REIBENCH_UNITY", "stand-in")
    assert RunSpec(planner="expert", world="ai2thor").versioned().world == "ai2thor:stand-in"
    monkeypatch.setenv("REIBENCH_UNITY", "build/thor")
    assert resolve_world("ai2thor").endswith("/build/thor")
    assert resolve_world("ai2thor:stand-in") == "ai2thor:stand-in"
    monkeypatch.delenv("REIBENCH_UNITY")
    assert resolve_world("ai2thor") == f"ai2thor:{_published()}"


def test_the_published_build_is_the_clients_own():
    from ai2thor.build import COMMIT_ID

    assert _published() == COMMIT_ID


def test_what_comes_through_the_stand_in_is_called_protocol_verified():
    assert verified("ai2thor:stand-in") == "protocol-verified"
    assert verified("ai2thor:/opt/thor") == verified("embedded") == ""


def _published() -> str:
    from reibench.worlds.ai2thor.builds import PUBLISHED

    return PUBLISHED
