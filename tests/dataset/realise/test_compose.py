"""Realised dialogues: sound at all levels, different from each other, never without their mark."""

from dataclasses import replace

import pytest

from reibench.dataset.check import problems
from reibench.dataset.check_levels import level_problems
from reibench.dataset.files import episode_from_json, episode_to_json, shipped_episodes
from reibench.dataset.levels import derive
from reibench.dataset.lexicon import expressions, held_out
from reibench.dataset.realise import ORIGIN
from reibench.dataset.realise.compose import CannotRealise, Realiser
from reibench.dataset.realise.wording import said_by
from reibench.dataset.script_check import script_problems
from reibench.dataset.scripts import format_scripts, read_scripts
from reibench.episode import Goal, SceneSetup, Task, TaskType
from reibench.household import load_room


def test_every_realised_script_is_sound(realised):
    wrong = {script.id: script_problems(script) for script in realised}
    assert {name: found for name, found in wrong.items() if found} == {}


def test_so_are_its_nine_episodes_each_alone_and_against_each_other(realised):
    for script in realised[:120]:
        episodes = derive(script)
        assert [found for each in episodes for found in problems(each)] == []
        assert level_problems(episodes) == []


def test_the_same_seed_gives_the_same_script_and_another_seed_another(realised):
    script = realised[0]
    task = Task(script.id, script.setup, script.goal)
    present = sorted({thing.type for thing in load_room(script.setup.room).objects})
    assert Realiser().realise(task, present, script.id) == script
    assert Realiser().realise(task, present, "other").turns != script.turns


def test_hardly_two_dialogues_are_alike(realised):
    texts = {
        "\n".join(u.text for u in derive(script)[1].dialogue.utterances) for script in realised
    }
    assert len(texts) == len(realised)
    openings = {derive(script)[0].dialogue.utterances[0].text for script in realised}
    assert len(openings) > 0.8 * len(realised)


def test_the_mark_is_on_script_and_episodes_and_survives_files(realised, tmp_path):
    path = tmp_path / "realised.txt"
    path.write_text(format_scripts(realised[:5]))
    assert read_scripts(path) == realised[:5]
    for episode in derive(realised[0]):
        assert episode.origin == ORIGIN
        assert episode_to_json(episode)["origin"] == ORIGIN
        assert episode_from_json(episode_to_json(episode)) == episode


def test_written_episodes_bear_no_mark_and_keep_the_form_that_digests_are_taken_of():
    for episode in shipped_episodes():
        assert episode.origin == ""
        assert "origin" not in episode_to_json(episode)


def test_expressions_that_are_held_out_are_never_said(realised):
    kept, out = held_out(0.4, seed=2)
    realiser = Realiser(kept)
    for script in realised[:100]:
        present = {thing.type for thing in load_room(script.setup.room).objects}
        task = Task(script.id, script.setup, script.goal)
        made = realiser.realise(task, present, script.id)
        for _, _, mention in made.mentions:
            name = script.goal.object if mention.of == "object" else script.goal.movable_receptacle
            secret = {said_by(e.text, who) for e in out.get(name, ()) for who in ("human", "robot")}
            assert mention.unnamed not in secret


def test_every_kind_of_task_and_every_level_of_mention_occurs(realised):
    assert {script.goal.task_type for script in realised} == set(TaskType)
    unnamed = [mention.unnamed for script in realised for _, _, mention in script.mentions]
    pronouns = sum(text in ("it", "they", "them", "that", "those") for text in unnamed)
    assert 0.1 < pronouns / sum(map(bool, unnamed)) < 0.5


def test_the_request_leaves_no_doubt_where_nothing_is_marked(realised):
    """Some expression that the short context keeps fits nothing else in the room."""
    for script in realised:
        if script.candidates or script.goal.movable_receptacle:
            continue
        present = {thing.type for thing in load_room(script.setup.room).objects}
        left = present - {script.goal.object}
        for _, passage, mention in script.mentions:
            if passage.stay == "always" and mention.of == "object":
                for known in expressions()[script.goal.object]:
                    if mention.unnamed in (known.text, said_by(known.text, "robot")):
                        left &= known.also_fits
        assert not left, script.id


def test_a_task_without_parts_is_refused_in_words():
    goal = Goal(TaskType.EXAMINE, "Apple", "FloorLamp")
    task = Task("odd", SceneSetup("kitchen-1"), goal)
    with pytest.raises(CannotRealise, match="No dialogue can be composed for odd in kitchen-1"):
        Realiser().realise(task, ["Apple", "Mug"], "1")


def test_the_robot_says_you_where_the_human_says_i():
    assert said_by("what I take my tea in", "robot") == "what you take your tea in"
    assert (
        said_by("the one I click when I'm nervous", "robot")
        == "the one you click when you're nervous"
    )
    assert said_by("what I take my tea in", "human") == "what I take my tea in"


def test_a_script_marked_otherwise_is_still_read(realised, tmp_path):
    path = tmp_path / "other.txt"
    path.write_text(format_scripts([replace(realised[0], origin="model:scripted:list")]))
    assert read_scripts(path)[0].origin == "model:scripted:list"
