"""From a seed to nine sound episodes, and every way in which a seed is dropped."""

import pytest

from reibench.backends import Usage
from reibench.dataset.build.asking import Asker, Price
from reibench.dataset.build.pipeline import STEPS, Report, build
from reibench.dataset.check import problems
from reibench.dataset.check_levels import level_problems
from reibench.dataset.levels import derive
from reibench.dataset.script_check import script_problems
from reibench.dataset.scripts import format_script, read_scripts
from reibench.dialogue import LEVELS

IDENTIFY, GENERATE, PROCESS, MIXED, IMPLICIT = range(5)


def test_a_seed_becomes_nine_sound_episodes(outcome, answers, gold, tmp_path):
    found = outcome(answers)
    assert found.script is not None, found.detail
    assert script_problems(found.script) == []
    episodes = derive(found.script)
    assert [episode.vagueness for episode in episodes] == list(LEVELS)
    assert [each for episode in episodes for each in problems(episode)] == []
    assert level_problems(episodes) == []
    # the same talk as the written one, whose words the model gave
    for number in (0, 1, 3, 4, 6, 7):
        mine, written = episodes[number], derive(gold["heat_potato"])[number]
        assert [u.text for u in mine.dialogue.utterances] == [
            u.text for u in written.dialogue.utterances
        ]
    assert {episode.origin for episode in episodes} == {"model:scripted:list"}
    (tmp_path / "built.txt").write_text(format_script(found.script))
    assert read_scripts(tmp_path / "built.txt") == [found.script]


ORDINARY = (
    "Nobody in this house has ever been in a hurry, and we are not going to begin with it now."
)


def change(at, old, new):
    """Return how to spoil the answers: in one of them, one stretch becomes another."""

    def spoil(answers):
        assert old in answers[at], old
        return [*answers[:at], answers[at].replace(old, new), *answers[at + 1 :]]

    return spoil


def says(at, text):
    return lambda answers: [*answers[:at], text, *answers[at + 1 :]]


def without_line(at, number):
    def spoil(answers):
        lines = answers[at].split("\n")
        return says(at, "\n".join(lines[:number] + lines[number + 1 :]))(answers)

    return spoil


def in_all(*pairs):
    """Return how to spoil every answer in the same way."""

    def spoil(answers):
        for old, new in pairs:
            answers = [answer.replace(old, new) for answer in answers]
        return answers

    return spoil


DROPS = {
    "nothing identified": (says(IDENTIFY, "dining table"), "generation", "is not identified"),
    "a word that is not there": (says(IDENTIFY, "spuds"), "generation", "is not identified"),
    "prose": (says(GENERATE, "Here is a script for you!"), "generation", "not seven turns"),
    "a turn too few": (without_line(GENERATE, 3), "generation", "not seven turns"),
    "a short turn": (
        change(GENERATE, "Is half a granola bar really all you have had?", ""),
        "generation",
        "a short turn",
    ),
    "too few mentions": (
        change(GENERATE, "potato ", "thing "),
        "generation",
        "too few named mentions",
    ),
    "a request for something else": (
        change(GENERATE, "I'd like the potato heated", "I'd like dinner heated"),
        "generation",
        "the request lacks the object",
    ),
    "no destination": (
        change(GENERATE, "on the dining table", "right here"),
        "generation",
        "the request lacks the destination",
    ),
    "a pronoun": (
        change(GENERATE, "heat a potato right through", "heat a potato, and it stays hot,"),
        "generation",
        "a pronoun at the explicit level",
    ),
    "a changed sentence": (
        change(PROCESS, "Standing is exactly the problem.", "Standing is the problem."),
        "processing",
        "adds something else",
    ),
    "a lost sentence": (
        change(PROCESS, " Dr. Pan had the other half.", ""),
        "processing",
        "the name is not said three times",
    ),
    "a missing sentence": (
        change(PROCESS, "The microwave needs no watching. ", ""),
        "processing",
        "adds something else",
    ),
    "the last sentence missing": (
        change(PROCESS, " Like a human being, I mean, and not over the sink in my coat.", ""),
        "processing",
        "changes what was said",
    ),
    "an added sentence without the name": (
        change(PROCESS, "Dr. Pan had the other half.", "Somebody had the other half."),
        "processing",
        "adds something else",
    ),
    "the name in the robot's mouth": (
        change(PROCESS, "The microwave needs", "Dr. Pan says so. The microwave needs"),
        "processing",
        "the name is in the wrong turn",
    ),
    "the name in the request": (
        change(PROCESS, "You are my favorite", "Dr. Pan is right. You are my favorite"),
        "processing",
        "the name is in the wrong turn",
    ),
    "a request that changes": (
        change(MIXED, "on the dining table, please", "on the table, please"),
        "replacement",
        "changes more than the expressions",
    ),
    "a request that still names": (
        change(MIXED, "I'd like that lumpy thing heated", "I'd like that nice potato heated"),
        "replacement",
        "still named",
    ),
    "a context that changes": (
        change(IMPLICIT, "woke up to two firefighters", "woke up"),
        "replacement",
        "changes more than the expressions",
    ),
    "a context that still names": (
        change(IMPLICIT, "What I want is that lumpy brown thing", "What I want is the potato"),
        "replacement",
        "still named",
    ),
    "a first mention that does not": (
        change(IMPLICIT, "the thought of that potato", "the thought of that thing"),
        "replacement",
        "changes more than the expressions",
    ),
    "a request that forgets the heat": (
        in_all(("heated up and put", "washed up and put")),
        "filter",
        "is to be treated",
    ),
    "a wrong number": (
        change(MIXED, "I'd like that lumpy thing heated", "I'd like them heated"),
        "filter",
        "does not agree in number",
    ),
    "broken grammar": (
        change(
            IMPLICIT, "What I want is that lumpy brown thing", "What I want is the the brown one"
        ),
        "filter",
        "is doubled",
    ),
}


@pytest.mark.parametrize(("spoil", "step", "reason"), DROPS.values(), ids=DROPS)
def test_what_cannot_be_used_is_dropped_where_it_went_wrong(outcome, answers, spoil, step, reason):
    found = outcome(spoil(answers))
    assert found.script is None
    assert (found.step, reason in found.reason) == (step, True), (found.step, found.reason)


def test_a_dialogue_of_single_sentences_leaves_nothing_to_leave_out(outcome, answers):
    lines = [line.split(": ", 1) for line in answers[GENERATE].split("\n")]
    one = "\n".join(f"{who}: {text.replace('. ', ', ').replace('? ', ', ')}" for who, text in lines)
    found = outcome([answers[IDENTIFY], one.replace("Dr,", "Dr."), *answers[PROCESS:]])
    assert found.script is None
    assert found.step == "processing"


def test_an_unfit_answer_is_complained_about_and_may_be_mended(outcome, answers):
    spoiled = change(GENERATE, "heat a potato right", "heat a potato, and it gets hot right")
    found = outcome([*spoiled(answers)[:2], answers[GENERATE], *answers[2:]], retries=1)
    assert found.script is not None, found.detail


def test_the_complaint_is_in_the_next_question(script, seed, gold):
    backend = script("dining table", "vase", "nothing")
    [found] = build([seed], Asker(backend, retries=2), list(gold.values()))
    assert found.reason == "a task object is not identified"
    first, second, third = (prompt.text for prompt in backend.prompts)
    assert second.startswith(first)
    assert "'dining table' does not give the task objects" in second
    assert "'vase' does not give" in third


def test_the_report_counts_every_seed_once(outcome, answers):
    report = Report()
    report.note(outcome(answers))
    for spoil, _, _ in DROPS.values():
        report.note(outcome(spoil(answers)))
    assert (report.seeds, report.kept) == (len(DROPS) + 1, 1)
    rows = report.rows()
    assert sum(count for _, _, count in rows) == len(DROPS)
    assert [step for step, _, _ in rows] == sorted((step for step, _, _ in rows), key=STEPS.index)
    found = report.as_json(Usage(2_000_000, 0, 500_000, 12.34), 9, 3, Price(0.15, 0.6))
    assert (found["kept"], found["seconds"], found["cost"]) == (1, 12.3, 0.6)
