"""The paper's models by name."""

import json

import pytest

from reibench.__main__ import main
from reibench.backends import backends
from reibench.backends.opening import open_backend
from reibench.errors import ReibenchError, UnknownName
from reibench.models.presets import full_name, known, presets
from reibench.run import RunSpec

PAPER = {
    "gpt-4o-mini", "gpt-4o", "llama3.1-8b", "gemma2-9b", "deepseekmath-7b", "ministral-8b",
    "qwen2.5-7b",
}  # fmt: skip


def test_the_seven_models_of_the_paper_have_names():
    assert {preset.name for preset in presets()} == PAPER
    assert {preset.model.partition(":")[0] for preset in presets()} == {"hf", "openai"}
    assert all(preset.licence and preset.note and preset.parameters for preset in presets())


def test_a_preset_is_recorded_under_its_full_name():
    assert full_name("LLaMA3.1-8B") == "hf:meta-llama/Llama-3.1-8B-Instruct"
    assert full_name("scripted:plan.txt") == "scripted:plan.txt"
    spec = RunSpec(model="qwen2.5-7b").versioned()
    assert spec.model == "hf:Qwen/Qwen2.5-7B-Instruct"
    assert spec.id == RunSpec(model="hf:Qwen/Qwen2.5-7B-Instruct").versioned().id


def test_a_name_that_is_no_preset_is_answered_with_one():
    with pytest.raises(UnknownName, match=r"KIND:NAME.*Did you mean 'llama3\.1-8b'"):
        open_backend("llama3.1-7b")


def test_a_preset_opens_what_it_stands_for(monkeypatch):
    asked = []

    def refuse(source):
        asked.append(source)
        raise ReibenchError("no network in tests")

    monkeypatch.setitem(backends._factories, "hf", refuse)
    with pytest.raises(ReibenchError, match="no network"):
        open_backend("ministral-8b")
    assert asked == ["mistralai/Ministral-8B-Instruct-2410"]


def test_presets_and_the_shelf_are_listed(capsys):
    assert main(["list", "models", "--json"]) == 0
    listed = {row["name"]: row for row in json.loads(capsys.readouterr().out)}
    assert set(listed) >= PAPER
    assert "llama-cpp:gemma-3-270m" in listed
    assert listed["gemma2-9b"]["kind"] == "base"
    assert len(listed) == len(known())
    assert main(["models"]) == 0
    assert "hf:Qwen/Qwen2.5-7B-Instruct, 15.2 GB, chat, Apache-2.0" in capsys.readouterr().out
