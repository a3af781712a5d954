"""The skills are the published 214 choices, in one order, in LoTA-Bench's words."""

import pytest

from reibench.errors import UnknownSkill
from reibench.skill import DONE, SKILLS, Verb, in_words, parse_skill


def test_there_are_214_choices_and_each_is_there_once():
    texts = [*(skill.text for skill in SKILLS), DONE]
    assert len(texts) == len(set(texts)) == 214


@pytest.mark.parametrize(
    ("verb", "count"),
    [(Verb.FIND, 80), (Verb.PICK_UP, 53), (Verb.PUT_DOWN, 53), (Verb.OPEN, 7), (Verb.CLOSE, 7),
     (Verb.SLICE, 5), (Verb.TURN_ON, 4), (Verb.TURN_OFF, 4)],
)  # fmt: skip
def test_each_verb_has_as_many_skills_as_published(verb, count):
    assert sum(skill.verb is verb for skill in SKILLS) == count


def test_skills_read_as_published():
    texts = {skill.text for skill in SKILLS}
    assert {"find an apple", "pick up the key chain", "find a CD", "turn on the desk lamp"} <= texts
    assert in_words("Bottle") == "glassbottle"


@pytest.mark.parametrize("skill", SKILLS, ids=str)
def test_every_skill_is_read_back_from_its_words(skill):
    assert parse_skill(f"  {skill.text.upper()}. ") is skill


def test_what_is_no_skill_is_refused_with_the_words():
    with pytest.raises(UnknownSkill, match="'fly to the moon' is none of the 213 skills"):
        parse_skill("fly to the moon")
