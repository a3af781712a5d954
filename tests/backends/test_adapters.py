"""A model and what it was taught besides: each prompt says which of them it is for."""

import pytest

from reibench import models
from reibench.backends import Prompt, adapters_of
from reibench.backends.llama_cpp import LlamaCpp
from reibench.backends.opening import open_backend
from reibench.errors import ModelUnavailable, UnknownName
from reibench.planners.examples import fixed_set
from reibench.planners.saycan import introduction
from reibench.skill import DONE, SKILLS

OPTIONS = [*(f" {skill}" for skill in SKILLS), f" {DONE}"]
ASKED = "Human pending instruction: Chill the tomato and put it on the counter.\nRobot:"
MEGABYTE = 1_000_000


@pytest.fixture(scope="module")
def taught():
    opened = open_backend("llama-cpp:gemma-3-270m+planner")
    yield opened
    opened.close()


def test_the_shipped_adapters_are_there_and_small():
    files = models.adapters_of("gemma-3-270m+planner")
    assert set(files) == {"planner", "resolver"}
    assert all(file.stat().st_size < 10 * MEGABYTE for file in files.values())
    assert set(models.adapters_of("gemma-3-270m")) == {"resolver"}


def test_it_plans_without_an_example_as_it_was_taught(taught):
    done = ["find a tomato", "pick up the tomato", "find a fridge", "open the fridge"]
    text = ASKED
    for skill in done:
        assert taught.choose(Prompt(text, adapter="planner"), OPTIONS).text.strip() == skill
        text += f" {skill},"


def test_it_is_another_model_with_an_adapter_than_without(taught, gemma):
    plain = [taught.choose(Prompt(ASKED), OPTIONS) for _ in range(2)]
    assert [one.text for one in plain] == [gemma.choose(Prompt(ASKED), OPTIONS).text] * 2
    planned = taught.choose(Prompt(ASKED, adapter="planner"), OPTIONS)
    again = taught.choose(Prompt(ASKED), OPTIONS)
    assert again.alternatives[0].probability == pytest.approx(
        plain[0].alternatives[0].probability, rel=0.05
    )
    assert planned.alternatives != again.alternatives


def test_what_one_has_evaluated_the_other_does_not_take_for_its_own(taught):
    prompt = "Human pending instruction: Rinse the old blue plate by the door.\nRobot:"
    first = taught.choose(Prompt(prompt, adapter="planner"), OPTIONS)
    other = taught.choose(Prompt(prompt, adapter="resolver"), OPTIONS)
    again = taught.choose(Prompt(prompt, adapter="planner"), OPTIONS)
    assert other.usage.cached_tokens < first.usage.prompt_tokens / 2
    assert again.usage.cached_tokens > first.usage.prompt_tokens / 2
    assert again.text == first.text


def test_a_fixed_prefix_is_kept_apart_for_each_adapter(tmp_path):
    prefix = introduction(fixed_set()[:3])
    prompts = [Prompt(f"{prefix}{ASKED}", len(prefix), adapter=name) for name in ("", "planner")]
    evaluated = []
    for _ in range(2):
        model = LlamaCpp(
            models.path_of("gemma-3-270m"),
            adapters=models.adapters_of("gemma-3-270m+planner"),
            cache=tmp_path,
        )
        usages = [model.choose(prompt, OPTIONS).usage for prompt in prompts]
        evaluated.append([usage.prompt_tokens - usage.cached_tokens for usage in usages])
        model.close()
    assert len(list(tmp_path.glob("*.kv"))) == 2
    assert all(later < first / 2 for first, later in zip(*evaluated, strict=True))


def test_an_adapter_that_is_not_there_is_refused(gemma):
    with pytest.raises(UnknownName, match="adapter"):
        gemma.choose(Prompt(ASKED, adapter="planner"), OPTIONS)


def test_backends_that_have_none_say_so(script):
    assert "planner" not in adapters_of(script("done"))


def test_transformers_does_not_pretend_to_have_it():
    with pytest.raises(ModelUnavailable, match=r"take llama-cpp:gemma-3-270m\+planner"):
        open_backend("hf:gemma-3-270m+planner")
