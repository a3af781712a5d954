"""`build-dataset`: what makes episodes, and where they may not go."""

import pytest

from reibench.__main__ import main
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
