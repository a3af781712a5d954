"""Names of parts."""

import sys
from concurrent.futures import ThreadPoolExecutor

from reibench.registry import Registry

PART = """
from time import sleep
from parts import registry
sleep(0.05)
registry.register("{name}")(dict)
"""


def test_threads_that_ask_first_all_find_every_part(tmp_path, monkeypatch):
    folder = tmp_path / "parts"
    folder.mkdir()
    (folder / "__init__.py").write_text(
        "from reibench.registry import Registry\nregistry = Registry('part', __name__)\n"
    )
    for name in ("one", "two"):
        (folder / f"{name}.py").write_text(PART.format(name=name))
    monkeypatch.syspath_prepend(tmp_path)
    from parts import registry  # type: ignore[import-not-found]

    assert isinstance(registry, Registry)
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda _: registry.names(), range(4)))
    assert found == [["one", "two"]] * 4
    for module in [name for name in sys.modules if name.split(".")[0] == "parts"]:
        del sys.modules[module]
