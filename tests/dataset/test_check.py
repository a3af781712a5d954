"""Broken episodes of many kinds: each is found, and the complaint says what is wrong."""

import json

import pytest

from reibench.dataset.check import disagreeing_tasks, problems
from reibench.dataset.check_levels import level_problems
from reibench.dataset.files import episode_from_json, episode_to_json


def say(value, turn, text, *marks):
    """Let a turn say something else; marks are (words, referent, form, explicit or implicit)."""
    value["dialogue"][turn]["text"] = text
    value["dialogue"][turn]["expressions"] = [
        [text.index(words), text.index(words) + len(words), *rest] for words, *rest in marks
    ]


def swap(value, turn, old, new):
    """Swap words outside any mark, in place, moving the marks after them."""
    text = value["dialogue"][turn]["text"]
    start = text.index(old)
    value["dialogue"][turn]["text"] = text.replace(old, new, 1)
    for mark in value["dialogue"][turn]["expressions"]:
        if mark[0] > start:
            mark[0] += len(new) - len(old)
            mark[1] += len(new) - len(old)


def noise_of(value, turn):
    return next(mark for mark in value["dialogue"][turn]["expressions"] if mark[2][0] == "@")


def change_speakers(value):
    """Let the robot say the first turn, and the human the second."""
    first, second = value["dialogue"][:2]
    value["dialogue"][:2] = [second | {"speaker": "human"}, first | {"speaker": "robot"}]


def name_again(value):
    text = value["dialogue"][3]["text"].replace("something that size", "the potato")
    say(value, 3, text, potato("the potato"))


def potato(words, form="definite", explicit="explicit"):
    return (words, "Potato", form, explicit)


TABLE = ("the dining table", "DiningTable", "definite", "explicit")
MARK = ("Potato", "definite", "explicit")
BROKEN = {
    "a turn too few": (
        "heat_potato.explicit-standard",
        lambda v: v["dialogue"].pop(2),
        "the turns must be human and robot",
    ),
    "the robot gives the instruction": (
        "heat_potato.explicit-standard",
        lambda v: v["dialogue"][6].update(speaker="robot"),
        "the turns must be human and robot",
    ),
    "an empty turn": (
        "heat_potato.explicit-standard",
        lambda v: say(v, 1, " "),
        "utterance 2 is empty",
    ),
    "a turn of few words": (
        "heat_potato.mixed-standard",
        lambda v: say(v, 1, "A potato fills you up.", potato("A potato", "indefinite")),
        "turn 2 has 5 words; it needs 20",
    ),
    "a mark beyond the text": (
        "heat_potato.explicit-standard",
        lambda v: v["dialogue"][6]["expressions"].append([900, 910, *MARK]),
        "the span 900–910 does not fit",
    ),
    "marks that overlap": (
        "heat_potato.explicit-standard",
        lambda v: v["dialogue"][6]["expressions"].append([43, 60, *MARK]),
        "overlaps the one before",
    ),
    "a pronoun that counts as a name": (
        "heat_potato.implicit-standard",
        lambda v: v["dialogue"][6]["expressions"][0].__setitem__(4, "explicit"),
        "is marked explicit, but as attributive",
    ),
    "an explicit request without the name": (
        "heat_potato.explicit-standard",
        lambda v: say(
            v,
            6,
            "Heat it and put it on the dining table.",
            potato("it", "pronoun", "implicit"),
            TABLE,
        ),
        "the instruction must name the Potato",
    ),
    "a mixed request with the name": (
        "heat_potato.mixed-standard",
        lambda v: say(v, 6, "Heat the potato, for the dining table.", potato("the potato"), TABLE),
        "the instruction must mention the Potato without naming it",
    ),
    "too few named mentions": (
        "heat_potato.explicit-standard",
        lambda v: [turn["expressions"].clear() for turn in v["dialogue"][1:6]],
        "needs 3 named and 0 unnamed mentions for the Potato",
    ),
    "a second named mention at implicit": (
        "heat_potato.implicit-standard",
        name_again,
        "needs 1 named and 2 unnamed mentions",
    ),
    "a first mention without the name": (
        "heat_potato.implicit-standard",
        lambda v: v.update(dialogue=[v["dialogue"][i] for i in (4, 1, 2, 3, 0, 5, 6)]),
        "the first mention of the Potato",
    ),
    "a name left at implicit-short": (
        "heat_potato.implicit-short",
        lambda v: say(v, 5, "You could sit down to the potato soon.", potato("the potato")),
        "needs no named mention for the Potato",
    ),
    "the ambiguous name only twice": (
        "heat_potato.mixed-noised",
        lambda v: v["dialogue"][0]["expressions"].pop(0),
        "the ambiguous name stands 2 times in the context, not 3",
    ),
    "two ambiguous names": (
        "heat_potato.mixed-noised",
        lambda v: noise_of(v, 2).__setitem__(2, "@Dr. Pot"),
        "more than one ambiguous name",
    ),
    "a robot that says the ambiguous name": (
        "heat_potato.mixed-noised",
        change_speakers,
        "'Dr. Pan' belongs into the human's turns",
    ),
    "an ambiguous name that gives the object away": (
        "heat_potato.mixed-noised",
        lambda v: say(
            v,
            2,
            "Potato King rang. Potato King sang. Potato King won.",
            ("Potato King", "@Potato King", "proper", "explicit"),
        ),
        "gives the task object away",
    ),
    "the object's name outside a mark": (
        "heat_potato.implicit-standard",
        lambda v: swap(v, 4, "peeling", "potato peeling"),
        "'potato' names the Potato outside a named mark",
    ),
    "a mark that does not name what it should": (
        "heat_potato.explicit-standard",
        lambda v: say(v, 6, "Heat the spoon for the dining table.", potato("the spoon"), TABLE),
        "'the spoon' is marked as naming the Potato, but does not",
    ),
    "a pronoun of the wrong number": (
        "heat_potato.mixed-standard",
        lambda v: say(
            v, 6, "Warm them up for the dining table.", potato("them", "pronoun", "implicit"), TABLE
        ),
        "'them' has not the number of",
    ),
    "a left-over article": (
        "heat_potato.implicit-standard",
        lambda v: swap(v, 3, "A few minutes", "A the the few minutes"),
        "'the the' is doubled",
    ),
    "an before a consonant": (
        "heat_potato.implicit-standard",
        lambda v: swap(v, 5, "A chair", "An chair"),
        "'An chair': a or an",
    ),
    "a small letter at a sentence's start": (
        "heat_potato.implicit-standard",
        lambda v: swap(v, 5, "A chair", "a chair"),
        "'a' begins a sentence small",
    ),
    "a room that lacks the object": (
        "heat_potato.explicit-standard",
        lambda v: v["setup"].update(room="bathroom-1"),
        "the room bathroom-1 has no Potato",
    ),
    "a place the thing may not go": (
        "heat_potato.explicit-standard",
        lambda v: v["goal"].update(destination="StoveBurner"),
        "a Potato may not be put in or on a StoveBurner",
    ),
    "a candidate that is not meant": (
        "cool_apple.implicit-short",
        lambda v: v.update(candidates=["Tomato", "Apple"]),
        "the first candidate is Tomato, not what is meant",
    ),
    "two candidates without the mark": (
        "cool_apple.implicit-short",
        lambda v: v.update(underdetermined=False),
        "it is marked not underdetermined, but has 2 candidates",
    ),
}


@pytest.mark.parametrize("kind", BROKEN)
def test_a_broken_episode_is_found(kind, episodes):
    name, damage, said = BROKEN[kind]
    value = json.loads(json.dumps(episode_to_json(episodes[name])))
    assert problems(episode_from_json(value)) == []
    damage(value)
    found = problems(episode_from_json(value))
    assert any(said in each for each in found), found


def levels_of(episodes, task="heat_potato"):
    return {
        str(each.vagueness): json.loads(json.dumps(episode_to_json(each)))
        for each in episodes.values()
        if each.task.id == task
    }


BETWEEN = {
    "a level is missing": (lambda v: v.pop("mixed-short"), "the task lacks mixed-short"),
    "mixed changes more than the mentions": (
        lambda v: swap(v["mixed-noised"], 6, "favorite", "best"),
        "turn 7 differs from heat_potato.explicit-noised outside the mentions",
    ),
    "noise changes what was said": (
        lambda v: swap(v["explicit-noised"], 0, "granola", "chocolate"),
        "turn 1 changes more than it adds",
    ),
    "noise loses a sentence": (
        lambda v: swap(v["explicit-noised"], 2, "Standing is exactly the problem. ", ""),
        "turn 3 lacks a sentence of the standard one",
    ),
    "noise without a name": (
        lambda v: swap(v["explicit-noised"], 1, "Is half", "Is a half"),
        "turn 2 differs from the standard one without any noise",
    ),
    "short changes a sentence": (
        lambda v: swap(v["explicit-short"], 3, "The microwave", "That microwave"),
        "turn 4 is not the noised one with sentences missing",
    ),
    "the request differs between contexts": (
        lambda v: swap(v["mixed-short"], 6, ", please", ""),
        "the request differs from that of the standard context",
    ),
}


@pytest.mark.parametrize("kind", BETWEEN)
def test_levels_that_differ_more_than_they_may_are_found(kind, episodes):
    damage, said = BETWEEN[kind]
    values = levels_of(episodes)
    assert level_problems([episode_from_json(each) for each in values.values()]) == []
    damage(values)
    found = level_problems([episode_from_json(each) for each in values.values()])
    assert any(said in sentence for _, sentence in found), found


def test_one_task_id_for_two_tasks_is_found(episodes):
    values = levels_of(episodes)
    values["mixed-short"]["setup"]["seed"] += 1
    [sentence] = disagreeing_tasks([episode_from_json(each) for each in values.values()])
    assert sentence.startswith("heat_potato.mixed-short disagrees")
