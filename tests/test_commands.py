"""The command line: results on stdout, one clear sentence and status 2 for mistakes."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from filelock import FileLock

from reibench.__main__ import main
from reibench.run import RunSpec
from reibench.skill import DONE

ROOT = Path(__file__).parents[1]


@pytest.fixture
def call(capsys, tmp_path, monkeypatch):
    monkeypatch.setenv("REIBENCH_DB", str(tmp_path / "records.db"))

    def run(*arguments):
        status = main(arguments)
        printed = capsys.readouterr()
        return status, printed.out, printed.err

    return run


def test_the_expert_solves_all_54_and_every_replay_confirms_it(call):
    status, out, _ = call("run", "--planner", "expert", "--episodes", "gold", "--json")
    [row] = json.loads(out)
    assert status == 0
    assert (row["episodes"], row["success"]) == (54, 54)
    status, out, _ = call("score", "--json")
    assert [(row["episodes"], row["success"]) for row in json.loads(out)] == [(54, 54)]
    status, out, err = call("replay", "--verify", "all")
    assert (status, err) == (0, "")
    assert out.startswith("54 records")


def test_the_expert_solves_all_54_under_official_rules_too(call):
    _, out, _ = call(
        "run", "--planner", "expert", "--rules", "official", "--episodes", "gold", "--json"
    )
    assert json.loads(out)[0]["success"] == 54


def test_a_scripted_model_runs_from_the_command_line(call, tmp_path):
    (tmp_path / "script").write_text("\n".join(["done"] * 3))
    model = f"scripted:{tmp_path / 'script'}"
    _, out, err = call(
        "run", "--model", model, "--episodes", "heat_potato", "--limit", "3", "--json"
    )
    [row] = json.loads(out)
    assert (row["episodes"], row["object_omission"]) == (3, 3)
    assert "[3/3] heat_potato.mixed-short: failure, object-omission, 0 steps" in err


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["run", "--planner", "sycan"], "No planner called 'sycan'. Did you mean 'saycan'?"),
        (["run", "--method", "toc"], "No method called 'toc'. Did you mean 'tocc'?"),
        (["run", "--planner", "expert", "--rules", "strct"], "Did you mean 'strict'?"),
        (["run", "--planner", "expert", "--world", "embeded"], "Did you mean 'embedded'?"),
        (["run", "--planner", "expert", "--episodes", "hot"], "No episode, level"),
        (["run", "--planner", "expert", "--limit", "0"], "must be at least 1"),
        (["run", "--planner", "expert", "--data", "nowhere.jsonl"], "nowhere.jsonl cannot be"),
        (["run", "--model", "llama-cpp:gema-3-270m"], "Did you mean 'gemma-3-270m'?"),
        (["run", "--model", "lama-cpp:x"], "Did you mean 'llama-cpp'?"),
        (["run", "--model", "llama-cpp:nowhere.gguf"], "nowhere.gguf"),
        (["models", "get", "qwen9"], "qwen9"),
        (["score"], "There is no database"),
        (["replay", "--verify", "all"], "There is no database"),
    ],
)
def test_a_mistake_is_one_clear_sentence_and_status_2(call, arguments, said):
    status, out, err = call(*arguments)
    assert status == 2
    assert out == ""
    assert said in err
    assert len(err.strip().splitlines()) == 1


def test_an_unknown_record_is_named(call):
    call("run", "--planner", "expert", "--episodes", "heat_potato.mixed-short")
    status, _, err = call("replay", "nobody")
    assert status == 2
    assert "has no record 'nobody'" in err


def test_a_record_is_printed_step_by_step(call):
    call("run", "--planner", "expert", "--episodes", "pick_keys.explicit-short")
    _, out, _ = call("score", "--json")
    assert json.loads(out)[0]["spec"]["planner"] == "expert"
    import os

    from reibench.store import Store

    [entry] = Store(os.environ["REIBENCH_DB"]).entries()
    status, out, _ = call("replay", entry.id)
    assert status == 0
    assert "find a key chain" in out


def test_a_corrupt_database_is_one_sentence_and_left_alone(call, tmp_path):
    path = tmp_path / "records.db"
    path.write_bytes(b"not a database" * 1000)
    before = path.read_bytes()
    for command in (["run", "--planner", "expert"], ["score"], ["replay", "--verify"]):
        status, _, err = call(*command)
        assert status == 2
        assert "file is not a database" in err
    assert path.read_bytes() == before


def test_listing_skills_lists_all_214_choices(call):
    _, out, _ = call("list", "skills")
    assert len(out.split("\n")) - 1 == 214
    assert out.rstrip().endswith(DONE)


def test_listing_episodes_follows_the_choice(call):
    _, out, _ = call("list", "episodes", "--episodes", "stack_pencil_mug,mixed", "--json")
    assert len(json.loads(out)) == 3


def test_a_larger_limit_extends_a_smaller_one_and_both_vary_tasks_and_levels(call):
    few, more = (
        {row["episode"] for row in json.loads(call("list", "episodes", "--limit", n, "--json")[1])}
        for n in ("6", "12")
    )
    assert few < more
    assert len({name.split(".")[0] for name in few}) >= 5
    assert len({name.split(".")[1] for name in few}) >= 5


def test_check_dataset_confirms_the_shipped_episodes(call):
    status, out, _ = call("check-dataset")
    assert (status, out) == (0, "2700 of 2700 episodes are sound and solvable.\n")


def test_the_same_run_twice_at_once_is_refused(call, tmp_path):
    spec = RunSpec(planner="expert").versioned()
    with FileLock(f"{tmp_path / 'records.db'}.{spec.id}.lock"):
        status, _, err = call("run", "--planner", "expert", "--limit", "1")
        assert status == 2
        assert "already going on in another process" in err
    status, _, _ = call("run", "--planner", "expert", "--limit", "1")
    assert status == 0


def test_a_killed_run_resumes_without_repeating(tmp_path):
    """Kill the process in mid-run, for real, and run the same command again."""
    database = tmp_path / "killed.db"
    command = [sys.executable, "-m", "reibench", "run", "--planner", "expert", "--db", database]
    command += ["--episodes", "gold"]
    first = subprocess.Popen(command, cwd=ROOT, stderr=subprocess.PIPE, text=True)
    for line in first.stderr:
        if line.startswith("[5/"):
            first.kill()
            break
    first.wait()
    again = subprocess.run(
        [*command, "--json"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    [row] = json.loads(again.stdout)
    assert (row["episodes"], row["success"], row["unfinished"]) == (54, 54, 0)
    finished_before = int(again.stderr.split("54 episodes, ")[1].split()[0])
    assert finished_before >= 5


def test_frames_are_kept_when_asked_for_and_replay_uses_the_records_own_world(tmp_path, capsys):
    database = str(tmp_path / "a.db")
    common = ["--db", database, "--episodes", "heat_potato.mixed-noised"]
    run = ["run", "--planner", "expert", "--world", "ai2thor:stand-in", *common]
    assert main([*run, "--frames"]) == 0
    out = capsys.readouterr()
    assert "ai2thor:stand-in (protocol-verified)" in out.out
    assert "expert (protocol-verified): 1 episodes" in out.err
    [folder] = (tmp_path / "a.db-frames").iterdir()
    assert len(list(folder.glob("*-robot.png"))) == len(list(folder.glob("*-above.png"))) == 13
    for world in ([], ["--world", "embedded"]):
        assert main(["replay", "--verify", "--db", database, *world]) == 0
        assert "1 records, 12 steps replayed: 1 came out the same" in capsys.readouterr().out


def test_frames_of_a_world_without_cameras_are_a_mistake(tmp_path, capsys):
    arguments = ["--planner", "expert", "--frames", "--db", str(tmp_path / "a.db")]
    assert main(["run", *arguments]) == 2
    assert "embedded renders no frames" in capsys.readouterr().err
