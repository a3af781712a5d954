"""guidance over a transformers model, tiny and untrained: what matters is that it goes on."""

import pytest

from reibench.bench.published import Published, missing

OPTIONS = [" find a pan", " find a potato", " pick up the pan", " done"]
PROMPT = "Human: bring me the pan.\nRobot:"


@pytest.fixture(scope="module")
def tiny() -> Published:
    """Return one whose attention reaches back further in some layers than in others."""
    if lacking := missing():
        pytest.skip(lacking)
    import tokenizers
    import torch
    import transformers

    letters = {letter: n for n, letter in enumerate(tokenizers.pre_tokenizers.ByteLevel.alphabet())}
    inner = tokenizers.Tokenizer(tokenizers.models.BPE(letters | {"<end>": len(letters)}, []))
    inner.pre_tokenizer = tokenizers.pre_tokenizers.ByteLevel(add_prefix_space=False)
    inner.decoder = tokenizers.decoders.ByteLevel()
    tokenizer = transformers.PreTrainedTokenizerFast(tokenizer_object=inner, eos_token="<end>")
    torch.manual_seed(0)
    config = transformers.Gemma3TextConfig(
        vocab_size=len(tokenizer), hidden_size=16, intermediate_size=16, num_hidden_layers=2,
        num_attention_heads=2, num_key_value_heads=1, head_dim=8, sliding_window=8,
        layer_types=["sliding_attention", "full_attention"],
    )  # fmt: skip
    return Published(transformers.Gemma3ForCausalLM(config).eval(), tokenizer)


def test_it_selects_one_of_the_options(tiny):
    assert tiny.choose(PROMPT, OPTIONS).text in OPTIONS


def test_of_a_prompt_that_begins_as_the_last_one_only_the_rest_is_evaluated(tiny):
    tiny.choose(PROMPT, OPTIONS)
    longer = tiny.choose(f"{PROMPT} find a pan, pick up the pan,", OPTIONS)
    assert len(" find a pan, pick up the pan,") <= longer.evaluated < len(PROMPT) + 29
    assert longer.seconds > 0


def test_after_another_prompt_it_selects_the_same_again(tiny):
    first = tiny.choose(PROMPT, OPTIONS)
    tiny.choose(f"{PROMPT[:10]} anything else:", OPTIONS)
    assert tiny.choose(PROMPT, OPTIONS).text == first.text


def test_nothing_is_kept_where_that_is_asked_for(tiny):
    kept = tiny.choose(PROMPT, OPTIONS)
    afresh = tiny.choose_afresh(PROMPT, OPTIONS)
    assert afresh.text == kept.text
    assert afresh.evaluated >= len(PROMPT)
