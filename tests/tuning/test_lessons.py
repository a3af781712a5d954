"""What adapters are taught: clear requests, and clear words for vague ones."""

import re
from itertools import islice

import pytest

from reibench.dataset.forms import names
from reibench.dataset.lexicon import expressions
from reibench.episode import TaskType
from reibench.methods.restating import clear
from reibench.skill import DONE, PICKABLE, RECEPTACLES, parse_skill
from reibench.tuning.grounds import made_up
from reibench.tuning.held_out import held_out_episodes
from reibench.tuning.lessons import lessons
from reibench.tuning.restatements import (
    restatements,
    shipped_expressions,
    taught_lexicon,
    untaught_lexicon,
)
from reibench.tuning.wishes import wishes
from reibench.worlds.embedded import embedded_world
from reibench.worlds.rules import RULES

NUMBER = 400


def made_lessons(rooms, seed=1, number=NUMBER):
    worlds = [embedded_world(rules) for rules in RULES.values()]
    return list(islice(lessons(rooms, worlds, seed), number))


@pytest.fixture(scope="module")
def rooms():
    with made_up(12) as made:
        yield made


@pytest.fixture(scope="module")
def taught(rooms):
    return made_lessons(rooms)


@pytest.fixture(scope="module")
def restated(rooms):
    return list(islice(restatements(rooms, 1), NUMBER))


def request(lesson):
    return lesson.told.rpartition("Human pending instruction: ")[2].removesuffix("\nRobot:")


def test_the_same_seed_gives_the_same_lessons(rooms, taught):
    assert made_lessons(rooms, number=40) == taught[:40]
    assert made_lessons(rooms, seed=2, number=40) != taught[:40]


def test_every_place_that_the_skills_know_and_rooms_have_is_asked_for(rooms):
    asked = {seed.task.goal.destination for seed in islice(wishes(rooms, 1), 1500)}
    there = {thing.type for room in rooms for thing in room.objects}
    assert set(RECEPTACLES) & there <= asked
    assert {"Sink", "Bathtub", "Microwave", "Safe"} <= asked


def test_everything_that_can_be_picked_up_is_asked_for(rooms):
    asked = {seed.task.goal.object for seed in islice(wishes(rooms, 1), 1500)}
    assert set(PICKABLE) & {thing.type for room in rooms for thing in room.objects} <= asked


def test_things_are_put_in_or_on_every_kind_of_thing_that_holds_some(rooms):
    seeds = [s for s in islice(wishes(rooms, 1), 1500) if s.task.goal.movable_receptacle]
    holders = {seed.task.goal.movable_receptacle for seed in seeds}
    assert holders == {"Bowl", "Box", "Cup", "Mug", "Pan", "Plate", "Pot"}


def test_every_step_taught_is_a_skill_and_every_lesson_ends_with_done(taught):
    for lesson in taught:
        assert lesson.moves[-1].skill == DONE
        assert lesson.moves[-1].taught
        for move in lesson.moves[:-1]:
            parse_skill(move.skill)


def test_nothing_vague_is_taught_to_the_planner(taught):
    """No expression of the lexicon, in whatever person it is said, is in any lesson."""
    named = {word for known in names().values() for word in (*known.singular, *known.plural)}
    every = {one.text.lower() for found in expressions().values() for one in found}
    vague = {text for text in every if text.removeprefix("the ") not in named}  # a rag is a cloth
    for lesson in taught:
        said = lesson.told.lower()
        assert not [text for text in vague if re.search(rf"\b{re.escape(text)}\b", said)]


def test_no_request_is_one_of_a_shipped_episode(taught, restated, shipped):
    known = {episode.dialogue.instruction.text.lower() for episode in shipped}
    assert not known & {request(lesson).lower() for lesson in taught}
    asked = {one.asked.rpartition("instruction: ")[2].partition("\n")[0] for one in restated}
    assert not known & {text.lower() for text in asked}


def test_all_task_types_and_most_things_are_taught(taught):
    skills = [move.skill for lesson in taught for move in lesson.moves]
    assert {"turn on the faucet", "turn on the microwave", "close the fridge"} <= set(skills)
    picked = {parse_skill(skill).object for skill in skills if skill.startswith("pick up")}
    assert len(picked) >= 0.8 * len(PICKABLE)


def test_a_slip_is_shown_with_what_puts_it_right_but_is_not_taught(taught):
    slips = [lesson for lesson in taught if not all(move.taught for move in lesson.moves)]
    assert 0.1 * NUMBER < len(slips) < 0.5 * NUMBER
    failures = [move.failure for lesson in taught for move in lesson.moves if move.failure]
    for said in ("which is closed", "already holding", "find it first", "put down failed"):
        assert any(said in failure for failure in failures), said


def test_some_requests_stand_alone_and_others_follow_a_dialogue(taught):
    alone = sum(lesson.told.startswith("Human pending") for lesson in taught)
    assert 0.5 * NUMBER < alone < 0.75 * NUMBER


def test_the_resolver_learns_no_expression_of_a_shipped_dialogue_nor_one_kept_back():
    taught, kept = (
        {one.text.lower() for found in lexicon.values() for one in found}
        for lexicon in (taught_lexicon(), untaught_lexicon())
    )
    assert len(taught) > 3 * len(kept) > 100
    assert not taught & kept
    assert not (taught | kept) & shipped_expressions()


def test_answers_are_clear_instructions_that_name_everything(restated, shipped):
    forms = [one.answer.strip() for one in restated]
    assert all(re.fullmatch(r"(Put|Wash|Heat|Cool|Look at) the .+\.", form) for form in forms)
    by_type = {kind: 0 for kind in TaskType}
    for episode in shipped[::9]:
        goal = episode.task.goal
        by_type[goal.task_type] += 1
        text = clear(goal)
        assert text.count("the ") >= (4 if goal.movable_receptacle else 2)
    assert all(by_type.values())


def test_vague_words_stand_in_most_of_what_the_resolver_is_asked(restated):
    named = [
        one
        for one in restated
        if re.findall(r"the ([A-Za-z ]+?) (?:in|on|under|and)", one.answer)[0].lower()
        in one.asked.rpartition("instruction: ")[2].lower()
    ]
    assert len(named) < 0.5 * len(restated)


def test_episodes_for_measuring_use_what_was_kept_back():
    made = held_out_episodes(18, 1, lambda task: True)
    assert len({str(episode.vagueness) for episode in made}) == 9
    kept = {one.text.lower() for found in untaught_lexicon().values() for one in found}
    taught = {one.text.lower() for found in taught_lexicon().values() for one in found}
    said = {
        expression.text.lower()
        for episode in made
        for turn in episode.dialogue.utterances
        for expression in turn.expressions
        if not expression.explicit and turn.speaker == "human"
    }
    assert said & kept
    assert not said & taught
    assert held_out_episodes(18, 1, lambda task: True) == made
