"""The official split: nine dialogues an entry, over real trials, tolerant of more fields."""

import json

import pytest

from reibench.dataset.alfred import find_trials
from reibench.dataset.rei_bench import MEMORIES, dialogue_of, read_rei_bench
from reibench.dialogue import LEVELS
from reibench.errors import InvalidEpisode

SAID = "Alice: The mug from Lisbon is cold.\nRobot: Shall I warm it?\nAlice: Warm it up."


@pytest.fixture(scope="module")
def trials(shared_data):
    folder = shared_data / "alfred" / "json_2.1.0" / "valid_seen"
    return [trial for trial in find_trials(folder) if trial.goal][:2]


@pytest.fixture
def entry(trials):
    return {
        "task": f"valid_seen/some-folder/{trials[0].id}",
        "repeat_idx": 1,
        "task_dec": "Put a heated mug on the table.",
        "reference": "mug",
        "confuse_name": "Mug Star",
        **dict.fromkeys(MEMORIES, SAID),
    }


@pytest.fixture
def split(tmp_path):
    def write(*entries):
        path = tmp_path / "rei_bench.json"
        path.write_text(json.dumps({"valid_seen": entries, "train": []}))
        return path

    return write


def test_an_entry_becomes_nine_episodes_of_one_real_task(split, entry, trials):
    episodes = read_rei_bench(split(entry), trials)
    assert tuple(episode.vagueness for episode in episodes) == LEVELS
    assert {episode.task.id for episode in episodes} == {f"{trials[0].id}-r1"}
    assert episodes[0].task.goal == trials[0].goal
    assert [turn.speaker for turn in episodes[0].dialogue.utterances] == ["human", "robot", "human"]
    assert episodes[0].dialogue.instruction.text == "Warm it up."


def test_an_empty_memory_falls_back_to_the_clear_instruction(split, entry, trials):
    episodes = read_rei_bench(split(entry | {"memory1-3": ""}), trials)
    [short] = [each for each in episodes if str(each.vagueness) == "explicit-short"]
    assert short.dialogue.instruction.text == entry["task_dec"]
    assert short.dialogue.context == ()


def test_what_is_said_over_two_lines_is_kept_and_a_last_robot_line_is_none():
    said = dialogue_of("Alice: One.\nTwo.\nRobot: Well.", "clear")
    assert [turn.text for turn in said.utterances] == ["One. Two."]


@pytest.mark.parametrize("field", ["task_dec", "repeat_idx", "memory2-3"])
def test_a_missing_field_is_named_with_its_entry(split, entry, trials, field):
    broken = {key: value for key, value in entry.items() if key != field}
    with pytest.raises(InvalidEpisode, match=rf"entry 2 \(valid_seen/.*\) has no '{field}'"):
        read_rei_bench(split(entry, broken), trials)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"task": "valid_seen/x/trial_T0"}, "trial_T0 is not among the 2 ALFRED trials"),
        ({"memory1-1": 7}, "cannot be read"),
        ({"memory1-1": "nobody says this"}, "said by nobody"),
        ({"repeat_idx": "first"}, "cannot be read"),
    ],
)
def test_a_wrong_value_is_named_with_its_entry(split, entry, trials, change, said):
    with pytest.raises(InvalidEpisode, match="entry 1") as caught:
        read_rei_bench(split(entry | change), trials)
    assert said in str(caught.value)


def test_a_file_without_the_split_is_refused(tmp_path, trials):
    path = tmp_path / "rei_bench.json"
    path.write_text("{}")
    with pytest.raises(InvalidEpisode, match="has no list 'valid_seen'"):
        read_rei_bench(path, trials)
