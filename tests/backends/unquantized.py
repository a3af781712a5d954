"""A GGUF file's weights in half numbers, as both backends then compute with them."""

from pathlib import Path

import gguf
import numpy as np

from reibench.backends.transformers.gguf_once import gguf_read_once

STATED_ANEW = ("general.architecture", "general.file_type", "general.quantization_version")


def unquantized(source: Path, target: Path) -> Path:
    """Write the weights of `source` to `target` as they are when they are used, not packed.

    With packed weights llama.cpp rounds what it multiplies them with to eight bits, which
    transformers does not; only unpacked ones are the same to both.
    """
    with gguf_read_once():  # it is the quicker reader, too
        read = gguf.GGUFReader(source)
    written = gguf.GGUFWriter(target, read.fields["general.architecture"].contents())
    for name, field in read.fields.items():
        if not name.startswith("GGUF.") and name not in STATED_ANEW:
            inner = field.types[-1] if field.types[0] is gguf.GGUFValueType.ARRAY else None
            written.add_key_value(name, field.contents(), field.types[0], sub_type=inner)
    for tensor in read.tensors:
        whole = gguf.quants.dequantize(tensor.data, tensor.tensor_type)
        written.add_tensor(tensor.name, whole.astype(np.float16 if whole.ndim > 1 else np.float32))
    written.write_header_to_file()
    written.write_kv_data_to_file()
    written.write_tensors_to_file()
    written.close()
    return target
