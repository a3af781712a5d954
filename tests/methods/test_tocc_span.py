"""Substitution of the expressions that the model names."""

import pytest

from reibench.backends import Alternative, Selection
from reibench.backends.scripted import ScriptedBackend
from reibench.dialogue import Dialogue, Utterance
from reibench.methods.expressions import candidates, request
from reibench.methods.tocc_span import SpanSubstitution


def told(instruction, *answers):
    backend = ScriptedBackend(answers)
    before = (Utterance("human", "I dropped an egg."), Utterance("robot", "Never mind."))
    dialogue = Dialogue((*before, Utterance("human", instruction)))
    return SpanSubstitution().instruct(dialogue, backend), backend


def test_the_expression_is_replaced_and_so_are_the_pronouns_after_it():
    said = "You win. Warm the oval thing and put it on the desk."
    instruction, _ = told(said, "the oval thing", "egg")
    assert instruction.text == "Warm the egg and put the egg on the desk."
    assert instruction.original == said
    assert instruction.answer == 'By "the oval thing", the human means the egg.'
    assert instruction.context == ()


def test_two_descriptions_stand_for_two_things_and_a_pronoun_for_one_of_them():
    instruction, backend = told(
        "Lay the long one in the deep one and put that on the shelf.",
        *("the long one", "the deep one"),
        *("spoon", "bowl", "bowl"),
    )
    assert instruction.text == "Lay the spoon in the bowl and put the bowl on the shelf."
    assert len(backend.prompts) == 5


def test_an_instruction_that_names_its_object_is_only_shortened_without_a_question():
    instruction, backend = told("A fine day. Put the egg in the sink, please.")
    assert instruction.text == "Put the egg in the sink, please."
    assert backend.prompts == []


def test_none_is_no_answer_where_nothing_is_named():
    instruction, _ = told("Put it on the desk.", "none", "it", "egg")
    assert instruction.text == "Put the egg on the desk."


def test_a_lamp_to_be_switched_on_is_no_thing_to_pick_up():
    instruction, _ = told("Hold it by the desk lamp and switch it on.", "it", "egg")
    assert instruction.text == "Hold the egg by the desk lamp and switch it on."


class Unsure(ScriptedBackend):
    """Says `none` first wherever it can, without being sure."""

    def choose(self, prompt, options):
        if " none" not in options:
            return super().choose(prompt, options)
        listed = (Alternative(" none", 0.6), Alternative(options[0], 0.4))
        return Selection(" none", alternatives=listed)


def test_an_unsure_none_counts_as_the_runner_up():
    said = "Put it on the desk by the egg."
    dialogue = Dialogue((Utterance("human", said),))
    instruction = SpanSubstitution().instruct(dialogue, Unsure(["mug"]))
    assert instruction.text == "Put the mug on the desk by the egg."


@pytest.mark.parametrize(
    ("instruction", "starts"),
    [
        ("Warm the oval thing and leave it on the side table.", ["the oval", "it"]),
        ("Take what I stir with and put that on the desk.", ["what I stir", "that"]),
        ("Put the one with the lid on the stove burner.", ["the one"]),
        ("Put Mum's treasure on the dining table.", ["Mum's treasure"]),
        ("Move it before my trousers catch fire.", ["it"]),
        ("Let's see, it's late.", []),
        ("Put the alarm clock on the bed.", []),
    ],
)
def test_expressions_are_unnamed_things_within_their_clause(instruction, starts):
    assert [candidate.spans[0] for candidate in candidates(instruction)] == starts


def test_an_expression_may_reach_over_what_is_said_about_the_thing():
    [first, *_] = candidates("Wash the flat thing I flip with and put it on the counter.")
    assert first.spans[-1] == "the flat thing I flip with"


def test_the_request_is_what_names_a_place():
    assert request("Sold. Put it on the shelf. Thank you.") == "Put it on the shelf."
    assert request("Close your eyes. Chill the egg.") == "Chill the egg."
    assert request("Never mind.") == "Never mind."


def test_every_question_is_kept_as_it_was_sent_the_last_as_the_prompt():
    said = "Lay the long one in the deep one, please."
    shown, backend = told(said, "the long one", "the deep one", "spoon", "bowl")
    sent = [prompt.text + prompt.begun for prompt in backend.prompts]
    kept = [each.text for each in shown.artefacts if each.kind == "prompt"]
    assert [*kept, shown.prompt] == sent
    answers = [each.text.strip() for each in shown.artefacts if each.kind == "answer"]
    assert answers == ["the long one", "the deep one", "spoon"]
