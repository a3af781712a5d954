"""Prefixes of a real model, the packaged Gemma, from one process to the next."""

import json
import shutil
import subprocess
import sys
from hashlib import sha256
from pathlib import Path

import pytest

from reibench import models
from reibench.backends import Prompt, Usage
from reibench.backends.llama_cpp import LlamaCpp
from reibench.planners.examples import fixed_set
from reibench.planners.saycan import introduction
from reibench.skill import SKILLS

OPTIONS = [f" {skill}" for skill in SKILLS]
PREFIX = introduction(fixed_set()[:3])
PROMPT = Prompt(f"{PREFIX}Human pending instruction: Wash the apple.\nRobot:", fixed=len(PREFIX))
ELSEWHERE = """
import json, sys
from dataclasses import asdict
from tests.backends.test_slots import PROMPT, asked
print(json.dumps([asdict(selection) for selection in asked(PROMPT)]))
"""


def asked(*prompts: Prompt, slots: int = 8):
    """Return what the model, opened anew, answers to `prompts`."""
    # in one thread sums are always made in the same order
    model = LlamaCpp(models.path_of("gemma-3-270m"), slots=slots, threads=1)
    answers = [model.choose(prompt, OPTIONS) for prompt in prompts]
    model.close()
    return answers


def evaluated(usage: Usage) -> int:
    return usage.prompt_tokens - usage.cached_tokens


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """Have a prefix evaluated and kept; return the folder and what was chosen."""
    cache = tmp_path_factory.mktemp("cache")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("REIBENCH_CACHE", str(cache))
        [first] = asked(PROMPT)
    return cache / "prefixes", first


@pytest.fixture
def first(made):
    return made[1]


@pytest.fixture
def kept(made, tmp_path, monkeypatch):
    """Have prefixes kept in a folder with that one in it."""
    monkeypatch.setenv("REIBENCH_CACHE", str(tmp_path))
    return Path(shutil.copytree(made[0], tmp_path / "prefixes"))


def test_a_prefix_is_evaluated_once_and_not_again_in_another_process(kept, first):
    assert evaluated(first.usage) >= first.usage.prompt_tokens - 5 > 150
    assert len(list(kept.iterdir())) == 1
    run = subprocess.run([sys.executable, "-c", ELSEWHERE], capture_output=True, check=True)
    [again] = json.loads(run.stdout)
    usage = Usage(**again["usage"])
    assert usage.prompt_tokens == first.usage.prompt_tokens
    assert evaluated(usage) < 30
    assert again["text"] == first.text
    chances = [one["probability"] for one in again["alternatives"]]
    assert chances == pytest.approx([one.probability for one in first.alternatives], abs=1e-4)


def test_the_choice_is_the_same_where_nothing_can_be_kept(kept, first):
    kept.rename(kept.with_name("moved"))
    kept.write_text("no folder")
    [other] = asked(PROMPT)
    assert evaluated(other.usage) > 150
    assert other.text == first.text


@pytest.mark.parametrize("damage", [b"", b"garbage" * 1000])
def test_a_damaged_file_is_ignored_and_made_anew(kept, first, caplog, damage):
    [file] = kept.iterdir()
    whole = file.read_bytes()
    file.write_bytes(damage or whole[: len(whole) // 2])
    [again] = asked(PROMPT)
    assert "is damaged" in caplog.text
    assert again.text == first.text
    assert evaluated(again.usage) > 150
    assert [path.name for path in kept.iterdir()] == [file.name]


def test_a_file_of_another_make_is_refused_by_llama_cpp_and_made_anew(kept, first, caplog):
    [file] = kept.iterdir()
    file.unlink()
    other = b"made by another version"
    name = f"{file.stem.partition('-')[0]}-{sha256(other).hexdigest()[:32]}.kv"
    (kept / name).write_bytes(other)
    [again] = asked(PROMPT)
    assert f"cannot use {name}" in caplog.text
    assert again.text == first.text
    assert [path.name for path in kept.iterdir()] == [file.name]


def test_a_prefix_pushed_out_of_its_slot_comes_back_from_disk(kept, first):
    other = PREFIX.replace("robot", "machine")
    prompts = PROMPT, Prompt(f"{other}Robot:", fixed=len(other)), PROMPT
    _, _, again = asked(*prompts, slots=1)
    assert evaluated(again.usage) < 30
    assert again.text == first.text


def test_generating_counts_the_prefix_it_had_to_evaluate(kept):
    next(kept.iterdir()).unlink()
    model = LlamaCpp(models.path_of("gemma-3-270m"), slots=1, threads=1)
    first, again = (model.generate(PROMPT, max_tokens=4) for _ in range(2))
    model.close()
    assert evaluated(first.usage) >= first.usage.prompt_tokens - 5 > 150
    assert evaluated(again.usage) < 5
    assert again.text == first.text
