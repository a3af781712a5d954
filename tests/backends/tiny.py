"""Tiny checkpoints of several families, with random weights and a real tokenizer."""

from pathlib import Path

from reibench.skill import SKILLS

TEMPLATE = (
    "{% for message in messages %}[INST] {{ message.content }} [/INST]{% endfor %}"
    "{% if add_generation_prompt %} Answer:{% endif %}"
)
SHAPE = {
    "hidden_size": 32, "intermediate_size": 64, "num_hidden_layers": 2, "num_attention_heads": 4,
    "num_key_value_heads": 2, "bos_token_id": 0, "eos_token_id": 1, "pad_token_id": 1,
    "initializer_range": 0.5,  # so that answers hang on what was said
}  # fmt: skip
FAMILIES = {
    "llama": {},
    "gemma2": {
        "head_dim": 8,
        "sliding_window": 8,
        "layer_types": ["sliding_attention", "full_attention"],
    },
    "lfm2": {"layer_types": ["conv", "full_attention"]},
    "mamba": {"state_size": 4},
    "gpt2": {},
}
"""Plain, with sliding windows, with recurrent layers, all recurrent, and an old one."""


def tiny(folder: Path, family: str = "llama", *, chat: bool = False, **settings: object) -> Path:
    """Write a checkpoint into `folder`."""
    tokenizer = _tokenizer()
    if chat:
        tokenizer.chat_template = TEMPLATE
    network(family, vocab_size=len(tokenizer), **settings).save_pretrained(folder)
    tokenizer.save_pretrained(folder)
    return folder


def network(family: str, **settings: object):
    """Make a model with random weights, the same each time."""
    import torch
    import transformers

    torch.manual_seed(0)
    shape = {**SHAPE, **FAMILIES[family], **settings}
    return transformers.AutoModelForCausalLM.from_config(
        transformers.AutoConfig.for_model(family, **shape)
    )


def _tokenizer():
    from tokenizers import Tokenizer, decoders, models, pre_tokenizers, trainers
    from transformers import PreTrainedTokenizerFast

    bytes_level = Tokenizer(models.BPE())
    bytes_level.pre_tokenizer = pre_tokenizers.ByteLevel(add_prefix_space=False)
    bytes_level.decoder = decoders.ByteLevel()
    alphabet = pre_tokenizers.ByteLevel.alphabet()
    trainer = trainers.BpeTrainer(
        vocab_size=600,
        special_tokens=["<s>", "</s>"],
        initial_alphabet=alphabet,
        show_progress=False,
    )
    bytes_level.train_from_iterator([f" {skill}," for skill in SKILLS], trainer)
    return PreTrainedTokenizerFast(tokenizer_object=bytes_level, bos_token="<s>", eos_token="</s>")
