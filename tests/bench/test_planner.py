"""`bench planner`: our way measured here, and beside it the published one."""

import pytest

from reibench.__main__ import main
from reibench.backends import Prompt, Selection, Usage
from reibench.backends.llama_cpp import LlamaCpp
from reibench.bench import published
from reibench.bench.planner import Asked, bench_planner, tokens_new

MODEL = "gemma-3-270m"


@pytest.fixture
def without_guidance(monkeypatch):
    """Have one of the needed packages called by a name that is on no machine."""
    monkeypatch.setattr(published, "NEEDED", ("guidance_that_is_nowhere", "torch"))


def test_ours_is_measured_where_guidance_is_not_installed(without_guidance):
    told = bench_planner(MODEL, threads=1, steps=2, restarts=1)
    assert told["ratio"] is told["guidance_seconds_per_step"] is None
    assert "guidance_that_is_nowhere cannot be imported" in told["guidance"]
    assert 0 < told["warm_seconds_per_step"] < told["first_step_seconds"]
    # the examples are most of a prompt, and evaluated once for all processes
    assert told["tokens_evaluated_after_restart"] < told["tokens_of_first_prompt"] / 2
    assert told["tokens_evaluated_per_step"] < 1.5 * told["tokens_new_per_step"]
    assert told["steps_measured"] == 10


def test_the_command_says_it_in_sentences(without_guidance, capsys):
    assert main(["bench", "planner", "--threads", "1", "--steps", "1"]) == 0
    said = capsys.readouterr().out
    assert "5 warm steps:" in said
    assert "guidance_that_is_nowhere" in said


def asked(model: LlamaCpp, text: str, answer: str) -> Asked:
    tokens = len(model.tokens(text)) + 1
    return Asked(Prompt(text), Selection(answer, Usage(tokens), prompt=text), 1.0, 1.0)


def test_new_are_the_tokens_that_nothing_before_had(gemma):
    steps = [asked(gemma, "one, two,", " three"), asked(gemma, "one, two, three,", " four")]
    first, second = tokens_new(gemma, [asked(gemma, "one,", " six")], steps)
    assert first == len(gemma.tokens("one, two,")) + 1 - len(gemma.tokens("one,"))
    assert second == 2  # the comma and the answer
