"""Chains of thought: in full, short and segmented."""

import pytest

from reibench.backends import Generation, Usage
from reibench.backends.scripted import ScriptedBackend
from reibench.methods import methods
from reibench.methods.reasoning import reasoned
from reibench.planners.telling import told

RESTATED = 'Clear instruction: "Warm the egg and put the egg on the desk."'


@pytest.mark.parametrize("name", ["cot", "short-cot"])
def test_the_planner_reads_the_thought_after_dialogue_and_instruction(name, dialogue):
    backend = ScriptedBackend([f'the oval thing" is the egg.\n{RESTATED}'])
    shown = methods.create(name).instruct(dialogue, backend)
    [prompt] = backend.prompts
    assert prompt.chat
    assert "Before planning, I will first identify any referring expressions" in prompt.text
    assert "not required to execute): I dropped an egg.\nHuman pending instruction" in prompt.text
    assert shown.text == shown.original
    assert shown.context == ("I dropped an egg.",)
    assert shown.prompt == prompt.text + prompt.begun
    lines = told(shown).splitlines()
    assert lines[1].startswith("Human pending instruction")
    assert lines[2].startswith("Robot thinks: ")
    assert lines[2].endswith(RESTATED)


def test_the_segments_are_shown_what_they_need_and_are_kept(dialogue):
    answers = ['the oval thing".', " egg.", " Warm the egg and put the egg on the desk."]
    backend = ScriptedBackend(answers)
    shown = methods.create("segmented-cot").instruct(dialogue, backend)
    identify, infer, rewrite = (prompt.text for prompt in backend.prompts)
    assert "dropped an egg" in infer
    assert "dropped an egg" not in identify + rewrite
    assert 'Referring expressions: "the oval thing"' in infer
    assert 'By "the oval thing", the human means egg.' in rewrite
    assert [each.kind for each in shown.artefacts] == ["prompt", "answer"] * 2
    assert shown.prompt.startswith(rewrite)
    assert shown.context == ("I dropped an egg.",)
    assert shown.notes.endswith(
        'By "the oval thing", the human means egg. '
        "Clear instruction: Warm the egg and put the egg on the desk."
    )


def test_segments_end_where_nothing_is_found(dialogue):
    backend = ScriptedBackend(['I", "a blue moon", "Warm the oval thing and put it on the desk".'])
    shown = methods.create("segmented-cot").instruct(dialogue, backend)
    assert len(backend.prompts) == 1
    assert shown.notes == ""
    assert shown.answer


@pytest.mark.parametrize("answer", ["", " \n", "...", "I see it. I see it. I see it. I see it."])
@pytest.mark.parametrize("name", ["cot", "short-cot", "segmented-cot"])
def test_an_empty_or_rambling_answer_leaves_no_note_but_shows(name, answer, dialogue):
    shown = methods.create(name).instruct(dialogue, ScriptedBackend([answer]))
    assert shown.notes == ""
    assert shown.answer == answer
    assert shown.text == shown.original


def test_a_thought_that_was_cut_off_ends_with_its_last_whole_sentence():
    cut = Generation("It is the egg. So I will go to the", Usage(completion_tokens=9))
    assert reasoned("What?", "Thought:", cut, 9) == "Thought: It is the egg."
    assert reasoned("What?", "Thought:", cut, 10).endswith("go to the")


def test_a_title_ends_no_sentence_and_quotes_stay_with_theirs():
    said = 'It is what Dr. Pan had. "Warm the egg." So I go to Dr.'
    cut = Generation(said, Usage(completion_tokens=9))
    assert reasoned("What?", "So:", cut, 9) == 'So: It is what Dr. Pan had. "Warm the egg."'


def test_what_is_kept_after_a_copy_does_not_hang_on_a_quote_that_was_opened():
    copy = Generation('I dropped an egg." The oval thing is the egg.')
    assert reasoned("I dropped an egg.", 'By "', copy, 50) == "The oval thing is the egg."


def test_words_of_the_question_are_no_thought():
    answer = Generation("1. I dropped an egg.\n2. The oval thing is the egg.")
    assert reasoned("I dropped an egg.", "So:", answer, 50) == "The oval thing is the egg."


def test_lists_become_one_line_in_which_nobody_else_speaks(dialogue):
    backend = ScriptedBackend(['the oval thing", "it"\n\n- the oval thing: **egg**\n- it: egg'])
    shown = methods.create("cot").instruct(dialogue, backend)
    assert shown.notes == (
        'Robot thinks: Referring expressions of the human pending instruction: "the oval thing", '
        '"it" the oval thing: egg it: egg'
    )
