"""The packaged Gemma through llama.cpp and transformers: the same weights, one behaviour."""

from collections.abc import Iterator

import pytest

from reibench.backends import Backend, Prompt
from reibench.backends.opening import open_backend
from reibench.methods import methods
from reibench.planners.saycan import SayCan
from reibench.rollout import Rollout, drive
from reibench.skill import DONE, SKILLS
from reibench.worlds import worlds

OPTIONS = [*(f" {skill}" for skill in SKILLS), f" {DONE}"]
STEPS = 200
EACH = 8
"""Steps of an episode at most: a model this small soon repeats itself, where both would agree."""


@pytest.fixture(scope="module")
def hf() -> Iterator[Backend]:
    opened = open_backend("hf:gemma-3-270m")
    yield opened
    opened.close()


@pytest.fixture(params=["llama-cpp", "hf"])
def backend(request, gemma) -> Backend:
    return gemma if request.param == "llama-cpp" else request.getfixturevalue("hf")


class Both:
    """Answer as one model does, asking another the same."""

    name = "both"

    def __init__(self, answering: Backend, other: Backend) -> None:
        self.chosen: list[tuple[str, str]] = []
        """What the two chose at each step."""
        self._models = answering, other

    def choose(self, prompt, options):
        first, second = (model.choose(prompt, options) for model in self._models)
        self.chosen.append((first.text, second.text))
        return first

    def generate(self, prompt, *, max_tokens=128, stop=(), grammar=""):
        raise NotImplementedError

    def close(self):
        pass


def test_they_choose_the_same_skill_in_95_of_100_steps(gemma, hf, episodes):
    # float32 against llama.cpp's sums in eight bits: they part where two skills are as good as even
    both, world = Both(gemma, hf), worlds.create("embedded")
    told = methods.create("none")
    for episode in list(episodes.values())[:: len(episodes) // 40]:
        rollout = Rollout(episode, world, max_steps=EACH)
        rollout.start()
        list(drive(rollout, SayCan(both), told.instruct(episode.dialogue, both)))
        if len(both.chosen) >= STEPS:
            break
    world.close()
    chosen = both.chosen[:STEPS]
    assert len(chosen) == STEPS
    assert len({one for one, _ in chosen}) > 20  # not the same answer to everything
    apart = [pair for pair in chosen if pair[0] != pair[1]]
    assert len(apart) <= 0.05 * STEPS, apart


def test_each_of_the_skills_is_chosen_when_the_text_calls_for_it(backend):
    missed = {}
    for option in OPTIONS:
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
