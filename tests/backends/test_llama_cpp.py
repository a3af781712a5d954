"""A real model, the packaged Gemma, behind the Backend contract."""

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import pytest

from reibench import models
from reibench.backends import Prompt
from reibench.backends.llama_cpp import LlamaCpp
from reibench.backends.opening import open_backend
from reibench.errors import ModelUnavailable, ReibenchError
from reibench.skill import SKILLS

FINDS = [" find a pan", " find a pen", " find a pencil", " find a pot", " find a potato"]
PLAN = "Robot: find a mug, pick up the mug, find a sink, put down the mug,"
EXAMPLES = "\n".join(
    f"Human: Bring me the {thing}.\nRobot: find a {thing}, pick up the {thing}, done"
    for thing in ("mug", "vase", "book", "pillow", "laptop", "statue")
)


def test_it_carries_the_name_it_was_opened_by(gemma):
    assert gemma.name == "llama-cpp:gemma-3-270m"


def test_it_chooses_one_of_the_options_and_the_same_one_again(gemma):
    options = [f" {skill}" for skill in SKILLS]
    first = gemma.choose(Prompt(PLAN), options)
    assert first.text in options
    assert gemma.choose(Prompt(PLAN), options).text == first.text


@pytest.mark.parametrize("option", FINDS)
def test_options_that_begin_alike_are_told_apart(gemma, option):
    said = ",".join([option] * 4)
    assert gemma.choose(Prompt(f"Again and again:{said},"), FINDS).text == option


def test_an_option_that_begins_another_can_be_chosen_as_well_as_the_longer_one(gemma):
    options = [" soap", " soap bar"]
    for option in options:
        said = ",".join([option] * 6)
        assert gemma.choose(Prompt(f"List:{said},"), options).text == option


def test_the_walk_agrees_with_a_grammar_where_the_prompt_leads_into_the_options(gemma):
    prompt = Prompt(f"{EXAMPLES}\nHuman: Bring me the pencil.\nRobot:")
    grammar = "root ::= " + " | ".join(f'"{option}"' for option in FINDS)
    chosen = gemma.choose(prompt, FINDS).text
    assert chosen == gemma.generate(prompt, grammar=grammar).text == " find a pencil"


def test_alternatives_are_probabilities_among_the_options_with_the_chosen_one(gemma):
    selection = gemma.choose(Prompt(PLAN), [f" {skill}" for skill in SKILLS])
    shares = [alternative.probability for alternative in selection.alternatives]
    assert selection.text in [alternative.text for alternative in selection.alternatives]
    assert 0 < sum(shares) <= 1.0001
    assert shares == sorted(shares, reverse=True)


def test_it_generates_within_a_grammar_and_up_to_a_stop(gemma):
    answer = gemma.generate(Prompt("Is snow white? Answer:"), grammar='root ::= " yes" | " no"')
    assert answer.text in (" yes", " no")
    counted = gemma.generate(Prompt("1, 2, 3, 4,"), max_tokens=20, stop=[" 7"])
    assert counted.text == " 5, 6,"
    assert counted.usage.completion_tokens > 3


def test_an_answer_goes_on_from_how_it_was_begun(gemma):
    whole = gemma.generate(Prompt("1, 2, 3, 4,"), max_tokens=3)
    begun = gemma.generate(Prompt("1, 2,", chat=True, begun=" 3, 4,"), max_tokens=3)
    assert begun.text == whole.text


def test_a_fixed_prefix_is_evaluated_once_and_survives_another(gemma):
    prefix = f"{EXAMPLES}\n"
    one = Prompt(f"{prefix}Human: Bring me the pen.\nRobot:", fixed=len(prefix))
    gemma.choose(one, FINDS)
    elsewhere = EXAMPLES.replace("Bring", "Fetch")
    gemma.choose(Prompt(f"{elsewhere}\nRobot:", fixed=len(elsewhere)), FINDS)
    other = Prompt(f"{prefix}Human: Bring me the potato.\nRobot:", fixed=len(prefix))
    usage = gemma.choose(other, FINDS).usage
    assert usage.prompt_tokens - usage.cached_tokens < 16
    assert usage.cached_tokens > 100


def test_two_threads_may_ask_at_once(gemma):
    prompts = [Prompt(f"{EXAMPLES}\nHuman: Bring me the {o[8:]}.\nRobot:") for o in FINDS]
    alone = [gemma.choose(prompt, FINDS).text for prompt in prompts]
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(lambda prompt: gemma.choose(prompt, FINDS).text, prompts))
    assert together == alone


def test_a_second_model_can_be_open_beside_the_first_and_be_closed(gemma):
    second = LlamaCpp(models.path_of("gemma-3-270m"), slots=1)
    prompt = Prompt(PLAN)
    assert second.choose(prompt, FINDS).text == gemma.choose(prompt, FINDS).text
    second.close()
    with pytest.raises(ModelUnavailable, match="has been closed"):
        second.choose(prompt, FINDS)
    assert gemma.choose(prompt, FINDS).text in FINDS


def test_a_prompt_that_is_too_long_is_refused_with_the_reason(gemma):
    with pytest.raises(ReibenchError, match="exceeds the available context"):
        gemma.generate(Prompt("word " * 4000))


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(ModelUnavailable, match=r"no model file .*absent\.gguf"):
        open_backend(f"llama-cpp:{tmp_path / 'absent.gguf'}")


def test_a_file_of_another_kind_is_no_model(tmp_path):
    (tmp_path / "page.gguf").write_text("<html>Sign in to download</html>")
    with pytest.raises(ModelUnavailable, match="is no GGUF file"):
        open_backend(f"llama-cpp:{tmp_path / 'page.gguf'}")


def test_a_file_cut_off_is_said_to_be_damaged(tmp_path):
    with models.path_of("gemma-3-270m").open("rb") as whole:
        (tmp_path / "half.gguf").write_bytes(whole.read(20_000_000))
    with pytest.raises(ModelUnavailable, match="damaged or cut off"):
        open_backend(f"llama-cpp:{tmp_path / 'half.gguf'}")


OPENED = """
from reibench.backends.opening import open_backend
for _ in range(4):
    open_backend("llama-cpp:gemma-3-270m").close()
"""


def test_a_model_that_is_closed_before_it_was_asked_lets_go():
    # in a process of its own: a server that waits for ever can only be killed
    subprocess.run([sys.executable, "-c", OPENED], check=True, timeout=120)
