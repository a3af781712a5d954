"""The packaged Gemma through llama.cpp and transformers: the same weights, one behaviour."""

from collections.abc import Iterator
from itertools import islice

import pytest

from reibench import models
from reibench.backends import Backend, Prompt
from reibench.backends.opening import open_backend
from reibench.backends.scripted import ScriptedBackend
from reibench.methods import methods
from reibench.planners.expert import Expert
from reibench.planners.saycan import SayCan
from reibench.rollout import Rollout, drive
from reibench.skill import DONE, SKILLS
from reibench.worlds import worlds
from tests.backends.unquantized import unquantized

OPTIONS = [*(f" {skill}" for skill in SKILLS), f" {DONE}"]
STEPS = 200


@pytest.fixture(scope="module")
def hf() -> Iterator[Backend]:
    opened = open_backend("hf:gemma-3-270m")
    yield opened
    opened.close()


@pytest.fixture(params=["llama-cpp", "hf"])
def backend(request, gemma) -> Backend:
    return gemma if request.param == "llama-cpp" else request.getfixturevalue("hf")


def asked(episode) -> list[Prompt]:
    """Return what SayCan asks a model that takes the expert's steps."""
    world = worlds.create("embedded")
    told = methods.create("none").instruct(episode.dialogue, ScriptedBackend([]))
    solving = Rollout(episode, world)
    solving.start()
    steps = [s.decision.skill.text for s in drive(solving, Expert(episode.task.goal), told)]
    script = ScriptedBackend([*steps, DONE])
    replaying = Rollout(episode, world)
    replaying.start()
    assert [s.decision.skill.text for s in drive(replaying, SayCan(script), told)] == steps
    return script.prompts


@pytest.fixture(scope="module")
def prompts(episodes) -> list[Prompt]:
    apart = list(episodes.values())[:: len(episodes) // 40]
    found = list(islice((prompt for each in apart for prompt in asked(each)), STEPS))
    assert len(found) == STEPS
    return found


@pytest.fixture(scope="module")
def through_hf(hf, prompts) -> list[str]:
    chosen = [hf.choose(prompt, OPTIONS).text for prompt in prompts]
    assert len(set(chosen)) > 10  # not the same answer to everything
    return chosen


def test_with_the_same_weights_they_choose_the_same_skill(through_hf, prompts, tmp_path):
    path = unquantized(models.path_of("gemma-3-270m"), tmp_path / "gemma.gguf")
    llama = open_backend(f"llama-cpp:{path}")
    chosen = [llama.choose(prompt, OPTIONS).text for prompt in prompts]
    llama.close()
    same = sum(one == other for one, other in zip(through_hf, chosen, strict=True))
    assert same >= 0.95 * STEPS


def test_with_packed_weights_they_part_only_where_two_skills_are_nearly_even(
    gemma, through_hf, prompts
):
    """Packed, llama.cpp computes in eight bits, so a close call may fall out the other way."""
    apart = 0
    for prompt, other in zip(prompts, through_hf, strict=True):
        selection = gemma.choose(prompt, OPTIONS)
        if selection.text != other:
            apart += 1
            probable = {each.text: each.probability for each in selection.alternatives}
            assert probable[other] > 0.5 * probable[selection.text]
    assert apart <= 0.15 * STEPS


def test_skills_are_chosen_when_the_text_calls_for_them(backend, gemma):
    missed = {}
    # each takes a while: every second will do, and through transformers every third
    for option in OPTIONS[:: 2 if backend is gemma else 3]:
        said = ",".join([option] * 4)
        chosen = backend.choose(Prompt(f"Again and again:{said},"), OPTIONS).text
        if chosen != option:
            missed[option] = chosen
    assert missed == {}


def test_they_say_the_same_and_stop_alike(gemma, hf):
    counting = Prompt("1, 2, 3, 4,")
    for model in (gemma, hf):
        assert model.generate(counting, max_tokens=20, stop=[" 7"]).text == " 5, 6,"
        whole = model.generate(counting, max_tokens=3)
        begun = model.generate(Prompt("1, 2,", chat=True, begun=" 3, 4,"), max_tokens=3)
        assert begun.text == whole.text
        assert begun.prompt == counting.text


def test_they_keep_to_a_grammar_alike(gemma, hf):
    listing = Prompt("The fruits:")
    grammar = 'root ::= (" apple" | " pear" | " plum") ("," root)?'
    said = [model.generate(listing, max_tokens=12, grammar=grammar).text for model in (gemma, hf)]
    assert said[0] == said[1]
    assert set(said[1].split(",")) <= {" apple", " pear", " plum"}
    answer = hf.generate(Prompt("Is snow white? Answer:"), grammar='root ::= " yes" | " no"')
    assert answer.text in (" yes", " no")
