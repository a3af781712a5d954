"""ALFRED's trials: what is read of them, and what is refused by name."""

import json
from collections import Counter

import pytest

from reibench.__main__ import main
from reibench.dataset.alfred import find_trials
from reibench.dataset.alfred.trial import read_trial
from reibench.dataset.files import episode_from_json, episode_to_json, read_episodes
from reibench.errors import InvalidTrial


@pytest.fixture(scope="module")
def trials(shared_data):
    return find_trials(shared_data / "alfred")


@pytest.fixture
def damaged(trials, tmp_path):
    """Write a real trial with something changed."""

    def write(change):
        content = json.loads(trials[0].file.read_text())
        change(content)
        path = tmp_path / "traj_data.json"
        path.write_text(json.dumps(content))
        return path

    return write


def test_every_trial_is_read(trials):
    assert len(trials) == 611
    goals = [trial.goal for trial in trials if trial.goal]
    assert len(goals) == 578
    assert len(Counter(goal.task_type for goal in goals)) == 6
    assert all(trial.asks and trial.setup.poses and trial.plan for trial in trials)
    assert {trial.setup.room[:9] for trial in trials} == {"FloorPlan"}


def test_the_old_names_of_types_are_those_of_ai2thor_5(trials):
    types = {pose.type for trial in trials for pose in trial.setup.poses}
    assert "Bottle" in types
    assert not types & {"Glassbottle", "PaperTowel"}


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda c: c.pop("scene"), "has no 'scene'"),
        (lambda c: c["pddl_params"].pop("object_target"), "has no 'object_target'"),
        (lambda c: c["scene"]["object_poses"][0].update(objectName="Apple"), "not TYPE_HASH"),
        (lambda c: c["scene"].update(scene_num="kitchen"), "wrong form"),
    ],
)
def test_a_damaged_trial_is_named(damaged, change, said):
    with pytest.raises(InvalidTrial, match=r"traj_data\.json") as caught:
        read_trial(damaged(change))
    assert said in str(caught.value)


def test_no_trials_is_an_error(tmp_path):
    with pytest.raises(InvalidTrial, match=r"no traj_data\.json anywhere below"):
        find_trials(tmp_path)


def test_each_annotator_s_words_become_an_episode_that_a_planner_plays(
    shared_data, trials, tmp_path, monkeypatch, capsys
):
    monkeypatch.setenv("REIBENCH_ROOMS", str(tmp_path / "rooms"))
    assert main(["import", "ithor", str(shared_data / "ithor")]) == 0
    folder = str(next(t.file for t in trials if t.goal and len(t.asks) == 3).parent)
    out = tmp_path / "trial.jsonl"
    assert main(["import", "alfred", folder, "--out", str(out)]) == 0
    episodes = read_episodes(out)
    assert len(episodes) == 3
    assert all(episode_from_json(episode_to_json(each)) == each for each in episodes)
    capsys.readouterr()
    database = str(tmp_path / "records.db")
    run = ["run", "--planner", "expert", "--data", str(out), "--db", database, "--json"]
    assert main(run) == 0
    [row] = json.loads(capsys.readouterr().out)
    assert (row["episodes"], row["success"]) == (3, 3)
    assert main(["replay", "--verify", "all", "--db", database]) == 0
