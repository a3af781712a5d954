"""Reading a GGUF file once instead of three times, and faster.

transformers reads the whole file for the configuration, for the tokenizer and for the weights; and
the reader of the package gguf cuts its two million small pieces out of a memory map, whose slices
cost several times those of a plain array. For Gemma 3 270M both together are most of a minute.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from threading import Lock
from typing import Any

_one_at_a_time = Lock()


@contextmanager
def gguf_read_once() -> Iterator[None]:
    """While this holds, whoever asks the package gguf for a reader of the same file shares one."""
    import gguf
    import numpy as np

    class PlainReader(gguf.GGUFReader):  # type: ignore[misc]
        @property
        def data(self) -> Any:
            return self._plain

        @data.setter
        def data(self, mapped: Any) -> None:
            self._plain = mapped.view(np.ndarray)  # the same memory without the map's bookkeeping

    with _one_at_a_time:
        usual = gguf.GGUFReader
        gguf.GGUFReader = cache(PlainReader)
        try:
            yield
        finally:
            gguf.GGUFReader = usual
