"""Which method suits which model."""

import pytest

from reibench.models import overview
from reibench.view.choices import usable_method
from reibench.view.shelf import shelf

TAUGHT = "llama-cpp:gemma-3-270m+planner"
LARGER = "llama-cpp:qwen2.5-coder-1.5b"


@pytest.mark.parametrize(
    ("chosen", "model", "used"),
    [
        ("", TAUGHT, "tocc-taught"),
        ("", LARGER, "tocc-span"),
        ("", "openai:anything", "tocc-span"),
        ("tocc", TAUGHT, "tocc"),
        ("tocc-taught", LARGER, "tocc-span"),
        ("tocc-taught", "scripted:FILE", "tocc-taught"),
    ],
)
def test_a_choice_is_kept_where_the_model_can_do_it(chosen, model, used):
    assert usable_method(chosen, model) == used


def test_what_a_model_was_not_taught_cannot_be_chosen_for_it():
    def choice(chosen):
        markup = shelf(overview(), chosen=chosen, planner="saycan", method="tocc")
        return markup.partition('value="tocc-taught"')[2].partition("</label>")[0]

    assert "disabled" in choice("qwen2.5-coder-1.5b")
    assert "the chosen model was not" in choice("qwen2.5-coder-1.5b")
    assert "disabled" not in choice("gemma-3-270m+planner")
