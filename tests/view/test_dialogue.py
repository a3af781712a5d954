"""The dialogue reads as it was said; marks tell what vague words stand for, or nothing at all."""

import re
from html import unescape

from reibench.artefact import Artefact
from reibench.methods import Instruction
from reibench.view.dialogue import conversation, utterance_text
from reibench.view.rewrite import told_box, word_diff


def plain(markup):
    return unescape(re.sub(r"<sup>.*?</sup>|<[^>]+>", "", markup))


def test_every_utterance_is_shown_word_for_word(episodes, tags):
    for episode in episodes.values():
        markup = conversation(episode.dialogue)
        tags(markup)
        for utterance in episode.dialogue.utterances:
            assert plain(utterance_text(utterance)) == utterance.text
            assert utterance.text in plain(markup)


def test_a_vague_expression_says_what_it_stands_for_and_an_explicit_one_need_not(episode):
    markup = conversation(episode.dialogue)
    vague = [
        each
        for utterance in episode.dialogue.utterances
        for each in utterance.expressions
        if not each.explicit and not each.is_noise
    ]
    assert vague
    assert markup.count("<sup>") >= len(vague)
    assert f'data-type="{vague[0].referent}"' in markup


def test_without_marks_nothing_in_the_page_tells_which_words_are_vague(episode):
    markup = conversation(episode.dialogue, marked=False)
    assert "<sup>" not in markup
    assert "data-type" not in markup
    assert 'class="re' not in markup


def test_the_instruction_stands_apart_in_the_only_tinted_box(episode):
    markup = conversation(episode.dialogue)
    assert markup.count('class="ask"') == 1
    box = markup[markup.index('class="ask"') :]
    assert episode.dialogue.instruction.text in plain(box)


def test_a_rewrite_strikes_what_went_and_marks_what_came():
    before = "Heat the lumpy thing and put it on the table."
    after = "Heat the potato and put the potato on the table."
    markup = word_diff(before, after)
    assert "<del>lumpy thing</del> <ins>potato</ins>" in markup
    assert plain(markup).endswith("on the table.")
    kept_and_new = re.sub(r"<del>.*?</del> ?", "", markup)
    assert plain(kept_and_new) == after


def test_a_rewrite_is_escaped():
    assert "<b>" not in word_diff("Heat it.", "Heat <b>it</b>.")


def test_what_led_to_an_instruction_can_be_unfolded():
    told = Instruction(
        text="Heat it.",
        original="Heat it.",
        context=("A potato.",),
        demonstrations="By <it>, the human means",
        notes="Robot thinks: it is the potato.",
        prompt="Which thing is meant?",
        answer="the potato",
        artefacts=(Artefact("note", "gate", "It stayed shut."),),
    )
    box = told_box(told, "CoT", turns=1)
    assert "<h3>Prepared by CoT before planning</h3>" in box
    assert "<blockquote>Robot thinks: it is the potato.</blockquote>" in box
    assert "It stayed shut." in box
    for folded in ("By &lt;it&gt;, the human means", "Which thing is meant?", "the potato"):
        assert f"<pre>{folded}</pre>" in box
    assert "left the instruction" not in box
    assert "not shown the dialogue" not in box


def test_a_planner_that_is_kept_from_the_dialogue_says_so():
    told = Instruction(text="Heat it.", original="Heat it.")
    assert "not shown the dialogue" in told_box(told, "No context", turns=2)
    assert "not shown the dialogue" not in told_box(told, "No context", turns=0)


def test_an_instruction_that_was_left_alone_says_so():
    told = Instruction(text="Heat it.", original="Heat it.")
    assert "left the instruction as it was" in told_box(told, "TOCC")
