"""Restating by a model that was taught it."""

import re

import pytest

from reibench import models
from reibench.__main__ import main
from reibench.backends import Prompt
from reibench.backends.opening import open_backend
from reibench.errors import ModelUnavailable
from reibench.methods import methods
from reibench.methods.restating import clear, grammar, question


@pytest.fixture(scope="module")
def taught():
    opened = open_backend("llama-cpp:gemma-3-270m+planner")
    yield opened
    opened.close()


def test_the_answer_is_what_the_planner_is_told(episode, script):
    told = methods.create("tocc-taught").instruct(
        episode.dialogue, script(" Heat the potato and put it on the counter top.")
    )
    assert told.text == "Heat the potato and put it on the counter top."
    assert told.context == ()
    assert told.rewritten
    assert told.prompt == question(episode.dialogue)


def test_it_asks_the_adapter(episode, script):
    backend = script("Put the mug on the desk.")
    methods.create("tocc-taught").instruct(episode.dialogue, backend)
    assert backend.prompts == [Prompt(question(episode.dialogue), adapter="resolver")]


def test_a_model_without_the_adapter_is_refused_before_anything_is_played(
    episode, capsys, tmp_path
):
    class Untaught:
        name = "llama-cpp:other"

    with pytest.raises(ModelUnavailable, match="or another method"):
        methods.create("tocc-taught").instruct(episode.dialogue, Untaught())
    model = f"llama-cpp:{models.path_of('gemma-3-270m')}"  # by its path it comes without
    asked = ["run", "--method", "tocc-taught", "--model", model, "--db", str(tmp_path / "a.db")]
    assert main(asked) == 2
    assert "has no adapter 'resolver'" in capsys.readouterr().err


def test_a_real_model_answers_in_one_of_the_forms(episodes, taught):
    right = 0
    for episode in list(episodes.values())[::6]:
        told = methods.create("tocc-taught").instruct(episode.dialogue, taught)
        assert told.text.endswith(".")
        assert told.text.split()[0] in ("Put", "Wash", "Heat", "Cool", "Look")
        right += told.text == clear(episode.task.goal)
    assert right >= 2


def test_every_clear_instruction_is_in_the_grammar(shipped):
    rules = dict(line.split(" ::= ", maxsplit=1) for line in grammar().splitlines())

    def pattern(rule: str) -> str:
        parts = re.findall(r'"[^"]*"|[a-z]+|[|()]', rules[rule])
        return "".join(
            re.escape(part.strip('"')) if part[0] == '"'
            else part if part in "|()"
            else f"(?:{pattern(part)})"
            for part in parts
        )  # fmt: skip

    known = re.compile(pattern("root"))
    for episode in shipped[::9]:
        assert known.fullmatch(f" {clear(episode.task.goal)}")
    assert not known.fullmatch(" Put the mug on the moon.")
