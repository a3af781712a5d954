"""Teaching in small: twenty lessons, and the file that comes of them."""

import json

import pytest

from reibench import models
from reibench.backends import Prompt
from reibench.backends.llama_cpp import LlamaCpp
from reibench.errors import ModelUnavailable, ReibenchError
from reibench.skill import DONE, SKILLS
from reibench.tuning.teaching import BASE, Recipe, lessons_of, teach

RECIPE = Recipe("planner", samples=24, rooms=2, batch=4, warm_up=1)
OPTIONS = [*(f" {skill}" for skill in SKILLS), f" {DONE}"]


@pytest.fixture(scope="module")
def loaded():
    from reibench.backends.transformers.loading import load
    from reibench.backends.transformers.source import Source

    return load(Source(BASE, dtype="float32", device="cpu"))


@pytest.fixture(scope="module")
def taught(loaded, tmp_path_factory):
    told = []
    folder = tmp_path_factory.mktemp("planner")
    return teach(RECIPE, folder, told.append, loaded), told, folder


def test_the_loss_goes_down(taught):
    losses = taught[0].losses
    assert len(losses) == 6
    assert sum(losses[-2:]) < 0.9 * sum(losses[:2])


def test_it_is_told_how_far_it_is_and_how_long_it_will_take(taught):
    assert any("[6/6] loss" in line and "min left" in line for line in taught[1])


def test_the_same_command_again_goes_on_from_what_is_there(taught, loaded):
    _, _, folder = taught
    told = []
    again = teach(RECIPE, folder, told.append, loaded)
    assert list(again.losses) == list(taught[0].losses)
    assert again.file.read_bytes() == taught[0].file.read_bytes()
    assert not any("loss" in line for line in told)


def test_another_recipe_is_not_mixed_in(taught):
    with pytest.raises(ReibenchError, match="has been begun by another recipe"):
        teach(Recipe("planner", samples=40, rooms=2), taught[2], str)


def test_it_says_what_it_was_made_from(taught):
    card = json.loads((taught[2] / "card.json").read_text())
    assert card["recipe"]["seed"] == 1
    assert card["lessons"] == 24
    assert card["versions"]["peft"]


def test_too_few_lessons_are_refused(tmp_path):
    with pytest.raises(ReibenchError, match="take at least 8"):
        teach(Recipe("resolver", samples=3), tmp_path, str)


def test_llama_cpp_opens_the_file_and_chooses_as_torch_does(taught, loaded):
    """The first skill of each request, by the adapter in llama.cpp and by its weights in torch."""
    import torch

    from reibench.tuning.coding import coded
    from reibench.tuning.training import Trainer

    folder = taught[2]
    lessons = lessons_of(RECIPE)
    told, allowed = coded(lessons, loaded.tokenizer)
    trainer = Trainer(loaded.model, told, allowed, RECIPE, folder)
    trainer.run(lambda *progress: None)  # nothing is left to teach
    model = LlamaCpp(models.path_of(BASE), adapters={"planner": taught[0].file})
    agreed = 0
    for lesson in lessons[:12]:
        found = model.choose(Prompt(lesson.told, adapter="planner"), OPTIONS)
        verb, _, _ = found.text.strip().partition(" ")
        tokens = loaded.tokenizer(lesson.told, return_tensors="pt")["input_ids"]
        with torch.no_grad():
            scores = trainer.model(tokens).logits[0, -1][allowed]
        agreed += loaded.tokenizer.decode(allowed[int(scores.argmax())]).strip() == verb
    model.close()
    trainer.close()
    assert agreed >= 11


def test_a_file_that_is_no_adapter_is_named(tmp_path):
    broken = tmp_path / "broken.gguf"
    broken.write_bytes(b"GGUF" + b"\0" * 100)
    with pytest.raises(ModelUnavailable, match=r"broken\.gguf"):
        LlamaCpp(models.path_of(BASE), adapters={"planner": broken})
