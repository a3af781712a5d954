"""`build-dataset`: what makes episodes, and where they may not go."""

import json

import pytest

from reibench.__main__ import main
from reibench.dataset.check import problems
from reibench.dataset.files import SHIPPED, read_episodes
from reibench.dataset.realise import ORIGIN


def test_realised_scripts_become_episodes_the_same_for_the_same_seed(tmp_path):
    for name in ("one.jsonl.gz", "two.jsonl.gz"):
        out = str(tmp_path / name)
        assert main(["build-dataset", "--realise", "4", "--seed", "9", "--out", out]) == 0
    assert (tmp_path / "one.jsonl.gz").read_bytes() == (tmp_path / "two.jsonl.gz").read_bytes()
    episodes = read_episodes(tmp_path / "one.jsonl.gz")
    assert len(episodes) == 36
    assert {episode.origin for episode in episodes} == {ORIGIN}


def test_levels_and_rooms_can_be_chosen(tmp_path):
    out = tmp_path / "some.jsonl"
    levels, rooms = "implicit-short,mixed-noised", "bedroom-1, bathroom-2"
    arguments = ["--realise", "6", "--levels", levels, "--rooms", rooms, "--out", str(out)]
    assert main(["build-dataset", *arguments]) == 0
    episodes = read_episodes(out)
    assert {str(episode.vagueness) for episode in episodes} == set(levels.split(","))
    assert {episode.task.setup.room for episode in episodes} == {"bedroom-1", "bathroom-2"}


def test_realised_episodes_are_sound_and_solvable(tmp_path, capsys):
    out = str(tmp_path / "few.jsonl")
    main(["build-dataset", "--realise", "5", "--exclude-lexicon", "0.3", "--out", out])
    assert main(["check-dataset", "--data", out]) == 0
    assert "45 of 45 episodes are sound and solvable." in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--realise", "0", "--out", "x.jsonl"], "makes no script; ask for at least 1"),
        (["--realise", "1", "--levels", "vague", "--out", "x.jsonl"], "No level called 'vague'"),
        (["--realise", "1", "--rooms", "attic", "--out", "x.jsonl"], "No room called 'attic'"),
        (["--realise", "1", "--exclude-lexicon", "1", "--out", "x.jsonl"], "not including, 1"),
        (["--realise", "1"], "name another file with --out"),
        (["--realise", "1", "--out", str(SHIPPED / "more.jsonl")], "name another file with --out"),
    ],
)
def test_what_cannot_be_built_is_said_in_a_sentence(tmp_path, monkeypatch, capsys, arguments, said):
    monkeypatch.chdir(tmp_path)
    assert main(["build-dataset", *arguments]) == 2
    assert said in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_the_packaged_model_runs_all_the_way_and_its_report_adds_up(tmp_path, capsys):
    """Its dialogues are not judged: what matters is that nothing unsound gets through."""
    out, answers = tmp_path / "built.jsonl", tmp_path / "answers"
    limits = ["--retries", "0", "--max-tokens", "120", "--answers", str(answers)]
    model = ["--model", "llama-cpp:gemma-3-270m", "--seeds", "2", "--price", "1", "2"]
    arguments = ["build-dataset", *model, *limits, "--out", str(out), "--json"]
    assert main(arguments) == 0
    report = json.loads(capsys.readouterr().out)
    dropped = sum(row["count"] for row in report["dropped"])
    assert report["seeds"] == report["kept"] + dropped == 2
    assert report["completion_tokens"] > 0
    assert report["cost"] > 0
    lines = out.read_text().splitlines()
    assert len(lines) == 9 * report["kept"]
    assert len(list(answers.iterdir())) == report["asked"]
    if lines:
        assert main(["check-dataset", "--data", str(out)]) == 0
    # the same command again asks nothing
    assert main(arguments) == 0
    again = json.loads(capsys.readouterr().out)
    assert (again["asked"], again["from_cache"]) == (0, report["asked"])
    assert (again["kept"], again["dropped"]) == (report["kept"], report["dropped"])


def test_what_a_model_says_is_reported_by_step_and_reason(tmp_path, capsys):
    seeds, said = tmp_path / "seeds.txt", tmp_path / "said.txt"
    seeds.write_text("heat Potato > DiningTable | kitchen-2, 2\n")
    said.write_text("potato\nnot a dialogue\n")
    model = ["--model", f"scripted:{said}", "--seeds", str(seeds), "--retries", "0"]
    for name in ("built.txt", "built.jsonl.gz"):
        out, answers = tmp_path / name, tmp_path / f"answers-{name}"
        arguments = [*model, "--out", str(out), "--answers", str(answers)]
        assert main(["build-dataset", *arguments]) == 0
        printed = capsys.readouterr()
        assert "generation  not seven turns  1" in printed.out
        assert "0 of 1 seeds kept." in printed.out
        assert "[1/1] seeds_1: generation: There must be seven lines" in printed.err
        assert out.exists()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "--model needs --seeds"),
        (["--seeds", "0"], "--seeds 0 leaves nothing to do"),
        (["--seeds", "none.txt"], "The seed file none.txt cannot be read"),
    ],
)
def test_a_model_without_seeds_is_refused(tmp_path, monkeypatch, capsys, arguments, said):
    monkeypatch.chdir(tmp_path)
    call = ["build-dataset", "--model", "scripted:x", "--out", "x.jsonl", *arguments]
    assert main(call) == 2
    assert said in capsys.readouterr().err


def test_alfreds_own_words_become_sound_sets_of_nine(tmp_path, capsys, monkeypatch, shared_data):
    monkeypatch.setenv("REIBENCH_ROOMS", str(tmp_path / "rooms"))
    assert main(["import", "ithor", str(shared_data / "ithor")]) == 0
    out = tmp_path / "alfred.jsonl.gz"
    trials = ["--alfred", str(shared_data / "alfred"), "--seeds", "60", "--seed", "1"]
    capsys.readouterr()
    assert main(["build-dataset", *trials, "--out", str(out), "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["kept"] >= 40
    assert report["kept"] + sum(report["dropped"].values()) == report["trials"] == 60
    episodes = read_episodes(out)
    assert len(episodes) == report["episodes"] == 9 * report["kept"]
    assert {found for episode in episodes for found in problems(episode)} == set()
    assert all(episode.task.setup.poses for episode in episodes)
    assert {episode.origin for episode in episodes} == {ORIGIN}


def test_without_rooms_every_trial_is_dropped_for_that(tmp_path, capsys, shared_data):
    out = tmp_path / "alfred.jsonl"
    trials = ["--alfred", str(shared_data / "alfred"), "--seeds", "8"]
    assert main(["build-dataset", *trials, "--out", str(out), "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["kept"] == 0
    assert report["dropped"]["room: it is not there"] >= 4


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--seeds", "some.txt", "--out", "x.jsonl"], "--seeds is a number of trials: 'some.txt'"),
        (["--out", "x.txt"], "Scripts cannot hold a trial's poses"),
        (["--out", str(SHIPPED / "x.jsonl")], "name another file with --out"),
    ],
)
def test_alfred_wants_a_number_and_an_episode_file(shared_data, capsys, arguments, said):
    assert main(["build-dataset", "--alfred", str(shared_data / "alfred"), *arguments]) == 2
    assert said in capsys.readouterr().err
