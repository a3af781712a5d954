"""The script that stands in for a model."""

import pytest

from reibench.backends import Prompt
from reibench.backends.opening import open_backend
from reibench.backends.scripted import ScriptedBackend
from reibench.errors import ModelUnavailable, ReibenchError


def test_it_answers_in_turn_and_keeps_the_prompts():
    script = ScriptedBackend(["find a mug", "Bring the mug."])
    assert script.choose(Prompt("Robot:"), [" find a mug", " done"]).text == " find a mug"
    assert script.generate(Prompt("Again?")).text == "Bring the mug."
    assert [prompt.text for prompt in script.prompts] == ["Robot:", "Again?"]


def test_it_reads_a_file_with_an_answer_a_line(tmp_path):
    (tmp_path / "plan.txt").write_text("find a mug\n\ndone\n")
    script = open_backend(f"scripted:{tmp_path / 'plan.txt'}")
    assert [script.generate(Prompt("")).text for _ in range(2)] == ["find a mug", "done"]


def test_an_empty_script_says_so():
    with pytest.raises(ReibenchError, match="no answer left after 0"):
        ScriptedBackend([]).generate(Prompt("Robot:"))


def test_an_answer_that_is_no_option_is_named():
    with pytest.raises(ReibenchError, match="'fly', which is none of the 1 options"):
        ScriptedBackend(["fly"]).choose(Prompt("Robot:"), [" done"])


def test_a_missing_script_is_named(tmp_path):
    with pytest.raises(ModelUnavailable, match="cannot be read"):
        open_backend(f"scripted:{tmp_path / 'absent.txt'}")


def test_a_line_of_a_file_can_hold_an_answer_of_several_lines(tmp_path):
    (tmp_path / "plan.txt").write_text("1: find a mug\\n2: find a cup\ndone\n")
    script = open_backend(f"scripted:{tmp_path / 'plan.txt'}")
    assert script.generate(Prompt("")).text == "1: find a mug\n2: find a cup"


@pytest.fixture
def ruled(tmp_path):
    def write(rules):
        (tmp_path / "rules.toml").write_text(rules)
        return open_backend(f"scripted:{tmp_path / 'rules.toml'}")

    return write


def test_a_script_of_rules_answers_by_the_first_that_is_for_the_prompt_over_and_over(ruled):
    script = ruled("""
[[rule]]
asked = 'Graph:$'
answers = ["1: find a mug"]
[[rule]]
asked = ''
answers = ["find a cup", "#2"]
""")
    assert script.generate(Prompt("Graph:")).text == "1: find a mug"
    options = [" find a cup", " done"]
    chosen = [script.choose(Prompt("Robot:"), options).text for _ in range(3)]
    assert chosen == [" find a cup", " done", " find a cup"]


def test_a_prompt_that_no_rule_is_for_is_named(ruled):
    script = ruled("[[rule]]\nasked = 'Graph:$'\nanswers = ['1: find a mug']\n")
    with pytest.raises(ReibenchError, match=r"ends with 'Robot:'; a last rule"):
        script.generate(Prompt("Robot:"))


@pytest.mark.parametrize(
    "rules",
    ["rule = 3", "[[rule]]\nasked = '('\nanswers = ['a']", "[[rule]]\nanswers = ['a']", "[["],
)
def test_a_file_that_holds_no_rules_says_how_they_look(ruled, rules):
    with pytest.raises(ModelUnavailable, match=r"should have tables \[\[rule\]\]"):
        ruled(rules)


def test_a_rule_without_answers_is_refused(ruled):
    with pytest.raises(ModelUnavailable, match="has no answers"):
        ruled("[[rule]]\nasked = ''\nanswers = []")
