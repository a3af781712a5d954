"""Episode files: what the loader reads, and what it refuses by name."""

import json
from collections import Counter
from dataclasses import replace

import pytest

from reibench.dataset.check import problems
from reibench.dataset.files import (
    digest,
    episode_from_json,
    episode_to_json,
    read_episodes,
    shipped_episodes,
    write_episodes,
)
from reibench.dataset.sample import select
from reibench.dialogue import LEVELS, Dialogue, Utterance
from reibench.errors import InvalidEpisode, UnknownName


def test_the_shipped_episodes_are_300_tasks_at_nine_levels_each(shipped):
    tasks = {each.task.id: each.task.goal.task_type.short for each in shipped}
    expected = [f"{task}.{level}" for task in tasks for level in LEVELS]
    assert [each.id for each in shipped] == expected
    # the proportions of appendix A.2, rounded to 300 seed tasks
    assert Counter(tasks.values()) == {
        "cool": 50, "heat": 50, "clean": 49, "examine": 40, "stack": 55, "pick": 56,
    }  # fmt: skip


def test_episodes_come_back_from_a_file_as_they_were(tmp_path):
    before = shipped_episodes()[:90]
    write_episodes(tmp_path / "copy.jsonl", before)
    assert read_episodes(tmp_path / "copy.jsonl") == before


def test_the_digest_changes_with_a_single_word(episode):
    *before, last = episode.dialogue.utterances
    other = replace(episode, dialogue=Dialogue((*before, replace(last, text=last.text + "!"))))
    assert digest(other) != digest(episode)


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("{", "line 2 is no JSON"),
        ("{}", "Episode without an id has no 'goal'"),
        ('{"id": "x", "goal": {}, "setup": {}, "task": "x"}', "Episode x has no 'room'"),
    ],
)
def test_a_broken_line_is_named(tmp_path, episode, line, said):
    path = tmp_path / "broken.jsonl"
    path.write_text(json.dumps(episode_to_json(episode)) + "\n" + line)
    with pytest.raises(InvalidEpisode, match=r"broken\.jsonl, line 2") as caught:
        read_episodes(path)
    assert said in str(caught.value)


def test_an_unknown_level_or_task_type_is_refused(episode):
    value = episode_to_json(episode)
    with pytest.raises(
        InvalidEpisode, match=r"No level called 'mixd-noised'\. Did you mean 'mixed"
    ):
        episode_from_json(value | {"level": "mixd-noised"})
    with pytest.raises(InvalidEpisode, match="'juggle' is not a valid TaskType"):
        episode_from_json(value | {"goal": value["goal"] | {"type": "juggle"}})


def test_an_episode_twice_in_a_file_is_refused(tmp_path, episode):
    write_episodes(tmp_path / "twice.jsonl", [episode, episode])
    with pytest.raises(InvalidEpisode, match="is there twice"):
        read_episodes(tmp_path / "twice.jsonl")


def test_a_missing_or_empty_file_is_one_sentence(tmp_path):
    with pytest.raises(InvalidEpisode, match="cannot be read"):
        read_episodes(tmp_path / "nowhere.jsonl")
    (tmp_path / "empty.jsonl").write_text("\n")
    with pytest.raises(InvalidEpisode, match="holds no episode"):
        read_episodes(tmp_path / "empty.jsonl")


def replaced_instruction(episode, text, expressions=()):
    said = Dialogue((*episode.dialogue.context, Utterance("human", text, expressions)))
    return replace(episode, dialogue=said)


def test_a_mixed_instruction_that_names_its_object_is_no_mixed_instruction(episodes):
    named = episodes["heat_potato.explicit-standard"].dialogue.instruction
    wrong = replaced_instruction(episodes["heat_potato.mixed-standard"], named.text,
                                 named.expressions)  # fmt: skip
    assert problems(wrong) == ["the instruction must mention the Potato without naming it"]


def test_a_span_outside_its_text_is_named(episode):
    marks = episode.dialogue.instruction.expressions
    wrong = replaced_instruction(episode, "Heat it.", marks)
    assert any("does not fit its 8 characters" in each for each in problems(wrong))


def test_a_goal_the_room_cannot_serve_is_named(episode):
    goal = replace(episode.task.goal, destination="Bathtub")
    wrong = replace(episode, task=replace(episode.task, goal=goal))
    assert "the room kitchen-2 has no Bathtub" in problems(wrong)
    assert "a Potato may not be put in or on a Bathtub" in problems(wrong)


def test_standard_contexts_hold_no_ambiguous_name(episodes):
    noised = episodes["heat_potato.mixed-noised"]
    level = episodes["heat_potato.mixed-standard"].vagueness
    assert problems(replace(noised, vagueness=level)) == [
        "the ambiguous name stands 3 times in the context, not 0"
    ]


def test_episodes_are_chosen_by_kinds_that_intersect(episodes):
    everything = list(episodes.values())
    assert len(select(everything, "all")) == 54
    assert len(select(everything, "mixed-noised")) == 6
    assert len(select(everything, "heat")) == 9
    assert len(select(everything, "heat,cool,implicit")) == 6
    assert [e.id for e in select(everything, "heat,implicit-short")] == [
        "heat_potato.implicit-short"
    ]
    assert len(select(everything, "kitchen-2,mixed")) == 6


def test_an_unknown_choice_names_the_nearest(episodes):
    with pytest.raises(UnknownName, match="Did you mean 'mixed-noised'"):
        select(list(episodes.values()), "mixed-noisd")


def test_a_manifest_freezes_its_episodes(tmp_path, episodes, episode):
    path = tmp_path / "manifest.json"
    path.write_text(json.dumps({"episodes": {episode.id: digest(episode)}}))
    assert select(list(episodes.values()), str(path)) == [episode]
    path.write_text(json.dumps({"episodes": {episode.id: "0" * 16}}))
    with pytest.raises(InvalidEpisode, match="has changed since the manifest"):
        select(list(episodes.values()), str(path))
