"""Studies as files: what is read, and what is refused."""

import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from reibench.errors import ReibenchError
from study.__main__ import main
from study.config import from_json
from study.reading import read_study

EXAMPLE = Path(__file__).parents[2] / "assets" / "study" / "study.toml"


@pytest.fixture
def changed(tmp_path):
    """Write the example with a line in place of another, and return its path."""

    def change(old: str, new: str) -> Path:
        text = EXAMPLE.read_text(encoding="utf-8")
        assert text.count(old) == 1
        path = tmp_path / "study.toml"
        path.write_text(text.replace(old, new), encoding="utf-8")
        return path

    return change


def test_the_example_says_all_there_is_and_comes_back_from_the_database_as_it_was():
    study = read_study(EXAMPLE)
    assert from_json(study.to_json()) == study
    assert len({episode.task.id for episode in study.chosen()}) == study.tasks
    assert len(study.chosen()) == 9 * study.tasks
    assert not any(episode.underdetermined for episode in study.chosen())
    types = {episode.task.goal.task_type for episode in study.chosen()}
    assert len(types) == 6


def test_any_change_is_another_version_a_word_of_a_text_too():
    study = read_study(EXAMPLE)
    other = replace(study, texts={**study.texts, "debrief": study.texts["debrief"] + "!"})
    assert len({study.version, other.version, replace(study, trials=8).version}) == 3


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('name = "household" ', 'name = "../x" ', "letters, digits and hyphens"),
        ('design = "latin-square"', 'design = "latin-squares"', "Did you mean 'latin-square'"),
        ("trials = 9 ", "trials = 90 ", "need as many different tasks"),
        ("trials = 9 ", "trials = 0 ", "from 1 up"),
        ("seed = 1 ", "sede = 1 ", "Did you mean 'seed'"),
        ('shows = "text and room"', 'shows = "room"', "way to show"),
        ('"pick_keys.explicit-standard"', '"pick_kyes.explicit-standard"', "Did you mean"),
        (
            '"pick_keys.explicit-standard"',
            '"pick_keys.explicit-standard", "pick_keys.mixed-short"',
            "nobody meets the same one twice",
        ),
        ('submission = "SESSION_ID"', 'submission = "SESSION"', "none of the parameters"),
        ('consent = "consent.md"', 'consent = "../../README.md"', "There is no text"),
        ('consent = "consent.md"', 'konsent = "consent.md"', "Did you mean 'consent'"),
        ('right = "The cabinet has to be opened."', 'right = "No."', "none of its options"),
        ('completed = "REI-DONE"', 'complete = "REI-DONE"', "Did you mean 'completed'"),
        ("trial_minutes = 0 ", 'trial_minutes = "5" ', "should be a number, without quotes"),
        ("trial_minutes = 0 ", "trial_minutes = -1 ", "should be 0"),
        ("reveal_success = false ", 'reveal_success = "no" ', "true or false, without quotes"),
        ("invited_only = false ", 'invited_only = "false" ', "true or false, without quotes"),
        ("recent_minutes = 90 ", "recent_minutes = 0 ", "should be 1 or more"),
        ("seed = 1 ", "seed = 1.5 ", "whole number"),
        ("tasks = 36 ", "tasks = 3600 ", "can be drawn"),
        ("points = 5", "points = 1", "should have 2 to 11"),
        ("points = 5", 'points = "5"', "of the question 'confidence' should be a whole number"),
        ("optional = true", 'optional = "no"', "true or false, without quotes"),
        ('completed = "REI-DONE"', "completed = 5", "should be text in quotes"),
        ('right = "sometimes"', 'right = "maybe"', "nobody could give it"),
        ('no_consent = "REI-NO"', 'no_consent = "REI-DONE"', "Two endings have the code"),
        (
            '# completed = "https://app.prolific.com/submissions/complete?cc={code}"',
            'completed = "javascript:alert(1)"',
            "begin with https://",
        ),
        ("[codes]", "[codes", "cannot be read as TOML"),
    ],
)
def test_what_cannot_work_is_refused_in_a_sentence(changed, old, new, said):
    with pytest.raises(ReibenchError, match=said):
        read_study(changed(old, new))


def test_a_study_s_own_texts_are_beside_it(tmp_path):
    shutil.copy(EXAMPLE, tmp_path / "study.toml")
    (tmp_path / "consent.md").write_text("# Ours", encoding="utf-8")
    assert read_study(tmp_path / "study.toml").texts["consent"] == "# Ours"


def test_the_command_line_creates_invites_pauses_and_tells(tmp_path, capsys):
    db = ["--db", str(tmp_path / "a.db")]
    assert main(["create", str(EXAMPLE), *db]) == 0
    assert "design latin-square" in capsys.readouterr().out
    assert main(["create", str(EXAMPLE), *db]) == 0
    assert "unchanged" in capsys.readouterr().out
    assert main(["invite", "household", "--n", "3", *db]) == 0
    assert len(set(capsys.readouterr().out.split())) == 3
    assert main(["pause", "household", *db]) == 0
    assert main(["status", *db]) == 0
    assert "paused" in capsys.readouterr().out
    assert main(["status", "household", "--json", *db]) == 0
    assert '"planned": 36' in capsys.readouterr().out
    assert main(["open", "houshold", *db]) == 2
    assert "Did you mean 'household'" in capsys.readouterr().err
    assert main(["status", "--db", str(tmp_path / "none.db")]) == 2
