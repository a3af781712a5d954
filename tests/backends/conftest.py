"""One small real model for all tests of backends."""

from collections.abc import Iterator

import pytest

from reibench.backends import Backend
from reibench.backends.opening import open_backend


@pytest.fixture(scope="session")
def gemma() -> Iterator[Backend]:
    opened = open_backend("llama-cpp:gemma-3-270m")
    yield opened
    opened.close()
