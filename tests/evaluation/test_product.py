"""Lists of planners, methods and models: the whole product, each run once, with its progress."""

import json
from dataclasses import replace

import pytest

from reibench.__main__ import main
from reibench.backends.scripted import ScriptedBackend
from reibench.evaluation.product import product
from reibench.evaluation.progress import spoken
from reibench.run import RunSpec, evaluate
from reibench.store import Store
from reibench.worlds import worlds


@pytest.fixture
def call(capsys, tmp_path):
    def run(*arguments):
        status = main(["run", "--json", "--db", str(tmp_path / "records.db"), *arguments])
        printed = capsys.readouterr()
        return status, json.loads(printed.out or "[]"), printed.err

    return run


@pytest.fixture
def scripts(tmp_path):
    """Return the names of two models that always say done."""
    for name in "ab":
        (tmp_path / name).write_text("done\n" * 100)
    return [f"scripted:{tmp_path / name}" for name in "ab"]


def test_each_planner_method_and_model_is_one_run_and_the_expert_is_one_alone(call, scripts):
    status, rows, err = call(
        "--planner", "saycan,expert,saycan", "--method", "none,tocc", "--model", ",".join(scripts),
        "--limit", "3",
    )  # fmt: skip
    assert status == 0
    runs = {(r["spec"]["planner"], r["spec"]["method"], r["spec"]["model"]) for r in rows}
    assert runs == {("expert", "none", "")} | {
        ("saycan", method, model) for method in ("none", "tocc") for model in scripts
    }
    assert [row["episodes"] for row in rows] == [3] * 5
    assert "5 runs, 15 episodes to play" in err
    assert "[15/15] " in err
    assert "15 of 15 episodes recorded" in err


def test_progress_counts_what_each_run_solved_also_before(call):
    call("--planner", "expert", "--limit", "2")
    _, _, err = call("--planner", "expert", "--limit", "5")
    assert "expert: 5 episodes, 2 finished before" in err
    assert "[3/3] " in err
    assert "solved 5 of 5 (100.0%)" in err
    _, [row], err = call("--planner", "expert", "--limit", "5")
    assert row["episodes"] == 5
    assert "[" not in err


def test_a_long_run_is_foretold_after_a_few_episodes(call):
    _, _, err = call("--planner", "expert", "--limit", "60")
    lines = err.splitlines()
    [place] = [place for place, line in enumerate(lines) if line.startswith("All 60 will take")]
    assert lines[place - 1].startswith("[5/60]")


def test_a_mistake_in_the_last_model_shows_before_anything_is_played(call, scripts, tmp_path):
    status, _, err = call("--model", f"{scripts[0]},scripted:{tmp_path / 'nowhere'}")
    assert status == 2
    assert "nowhere cannot be read" in err
    assert len(err.splitlines()) == 1
    assert Store(tmp_path / "records.db").entries() == []


def test_what_broke_is_played_again_only_when_asked_for(call, tmp_path):
    (tmp_path / "short").write_text("done\ndone\n")
    model = ["--model", f"scripted:{tmp_path / 'short'}", "--limit", "4"]
    _, [row], err = call(*model)
    assert (row["episodes"], row["breakdown"]) == (4, 2)
    assert "2 broke, which --retry-errors plays again" in err
    _, [row], _ = call(*model)
    assert row["breakdown"] == 2
    _, [row], err = call(*model, "--retry-errors")
    assert (row["episodes"], row["breakdown"]) == (4, 0)
    assert "4 episodes, 2 finished before" in err


def test_threads_share_a_model_that_takes_many_calls_at_once(call, scripts, monkeypatch, tmp_path):
    opened = []
    monkeypatch.setattr(ScriptedBackend, "concurrent", True, raising=False)
    monkeypatch.setattr(ScriptedBackend, "close", lambda self: opened.append(self))
    _, [row], _ = call("--model", scripts[0], "--limit", "40", "--workers", "4")
    assert (row["episodes"], row["object_omission"], row["unfinished"]) == (40, 40, 0)
    assert [len(backend.prompts) for backend in opened] == [40]
    assert len(Store(tmp_path / "records.db").entries()) == 40


def test_the_product_keeps_the_order_of_the_lists():
    specs = product(RunSpec(rules="official"), ["saycan"], ["tocc", "none"], ["a", "b"])
    assert [(s.model, s.method) for s in specs] == [
        ("a", "tocc"), ("a", "none"), ("b", "tocc"), ("b", "none")
    ]  # fmt: skip
    assert {spec.rules for spec in specs} == {"official"}


def test_a_runs_seed_moves_where_the_robot_starts_and_the_record_can_be_replayed(
    call, episode, store, tmp_path
):
    spec, world = RunSpec(planner="expert"), worlds.create("embedded")
    starts = [
        next(evaluate(replace(spec, seed=seed), [episode], None, world, store)).start
        for seed in range(6)
    ]
    poses = {start.scene.agent for start in starts}
    assert len(poses) > 3
    assert starts[0] == world.reset(episode.task)
    setup = replace(episode.task.setup, seed=episode.task.setup.seed + 2)
    assert starts[2] == world.reset(replace(episode.task, setup=setup))
    call("--planner", "expert", "--seed", "2", "--episodes", episode.id)
    assert main(["replay", "--verify", "--db", str(tmp_path / "records.db")]) == 0


@pytest.mark.parametrize(
    ("seconds", "said"),
    [(0.4, "0 s"), (59.7, "1 min 0 s"), (200, "3 min 20 s"), (7500, "2 h 5 min")],
)
def test_durations_are_said_as_people_say_them(seconds, said):
    assert spoken(seconds) == said
