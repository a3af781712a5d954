"""Writing an adapter as llama.cpp reads it: a GGUF file of its own, beside the base model's."""

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

_PARTS = {
    "self_attn.q_proj": "attn_q",
    "self_attn.k_proj": "attn_k",
    "self_attn.v_proj": "attn_v",
    "self_attn.o_proj": "attn_output",
    "mlp.gate_proj": "ffn_gate",
    "mlp.up_proj": "ffn_up",
    "mlp.down_proj": "ffn_down",
}
_NAME = re.compile(
    r"model\.layers\.(?P<layer>\d+)\.(?P<part>[a-z_.]+)\.lora_(?P<side>[AB])\.weight"
)


def write(weights: Mapping[str, Any], path: Path, *, name: str, alpha: float) -> None:
    """Write an adapter of a Gemma 3 model in float16.

    Args:
        weights: tensors by the names of transformers; A is (rank, in), B is (out, rank).
        path: the file, which appears when it is whole.
        name: what the adapter is called.
        alpha: what its changes are scaled by, times 1 / rank.
    """
    import gguf
    import numpy

    part = path.with_suffix(".part")
    writer = gguf.GGUFWriter(part, "gemma3")
    writer.add_type(gguf.GGUFType.ADAPTER)
    writer.add_string(gguf.Keys.Adapter.TYPE, "lora")
    writer.add_name(name)
    writer.add_float32(gguf.Keys.Adapter.LORA_ALPHA, alpha)
    for key, value in weights.items():
        found = _NAME.fullmatch(key)
        if found is None or found["part"] not in _PARTS:
            raise ValueError(f"{key} is no part of an adapter of Gemma 3")
        tensor = f"blk.{found['layer']}.{_PARTS[found['part']]}.weight.lora_{found['side'].lower()}"
        writer.add_tensor(tensor, value.numpy().astype(numpy.float16))
    writer.write_header_to_file()
    writer.write_kv_data_to_file()
    writer.write_tensors_to_file()
    writer.close()
    part.replace(path)
