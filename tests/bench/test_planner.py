"""`bench planner`: our way measured here, and beside it the published one."""

import pytest

from reibench.backends import Prompt, Selection, Usage
from reibench.backends.llama_cpp import LlamaCpp
from reibench.bench import published
from reibench.bench.planner import Asked, bench_planner, tokens_new
from reibench.commands.benching import planner_lines

MODEL = "gemma-3-270m"


@pytest.fixture(scope="module")
def measured():
    """Measure where one of the needed packages is called by a name that is on no machine."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(published, "NEEDED", ("guidance_that_is_nowhere", "torch"))
        return bench_planner(MODEL, threads=1, steps=2, restarts=1)


def test_ours_is_measured_where_guidance_is_not_installed(measured):
    assert measured["ratio"] is measured["guidance_seconds_per_step"] is None
    assert "guidance_that_is_nowhere cannot be imported" in measured["guidance"]
    assert 0 < measured["warm_seconds_per_step"] < measured["first_step_seconds"]
    # the examples are most of a prompt, and evaluated once for all processes
    assert measured["tokens_evaluated_after_restart"] < measured["tokens_of_first_prompt"] / 2
    assert measured["tokens_evaluated_per_step"] < 1.5 * measured["tokens_new_per_step"]
    assert measured["steps_measured"] == 10


def test_it_is_said_in_sentences(measured):
    said = "\n".join(planner_lines(measured))
    assert "10 warm steps:" in said
    assert "guidance_that_is_nowhere" in said


def asked(model: LlamaCpp, text: str, answer: str) -> Asked:
    tokens = len(model.tokens(text)) + 1
    return Asked(Prompt(text), Selection(answer, Usage(tokens), prompt=text), 1.0, 1.0)


def test_new_are_the_tokens_that_nothing_before_had(gemma):
    steps = [asked(gemma, "one, two,", " three"), asked(gemma, "one, two, three,", " four")]
    first, second = tokens_new(gemma, [asked(gemma, "one,", " six")], steps)
    assert first == len(gemma.tokens("one, two,")) + 1 - len(gemma.tokens("one,"))
    assert second == 2  # the comma and the answer
