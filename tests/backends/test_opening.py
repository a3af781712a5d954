"""Backends by their names."""

import pytest

from reibench.backends.opening import open_backend
from reibench.errors import ModelUnavailable, UnknownName


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("lama-cpp:gemma-3-270m", "Did you mean 'llama-cpp'"),
        ("llama-cpp:gema-3-270m", "Did you mean 'gemma-3-270m'"),
        ("llama-cpp", "should read KIND:NAME"),
        ("scripted:", "should read KIND:NAME"),
        ("openai", "for example 'openai:NAME'"),
        ("opena:gpt-4o-mini", "Did you mean 'openai'"),
    ],
)
def test_a_wrong_name_is_answered_with_a_right_one(name, hint):
    with pytest.raises(UnknownName, match=hint):
        open_backend(name)


def test_a_model_that_is_not_here_says_how_to_get_it(tmp_path, monkeypatch):
    monkeypatch.setenv("REIBENCH_MODELS", str(tmp_path))
    with pytest.raises(ModelUnavailable, match=r"models get qwen2\.5-coder-1\.5b"):
        open_backend("llama-cpp:qwen2.5-coder-1.5b")
