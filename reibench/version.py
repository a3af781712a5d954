"""Code versions: a digest of just the code and files that can change what a run does."""

import ast
import hashlib
from collections.abc import Iterable
from functools import lru_cache
from pathlib import Path
from threading import Lock

from reibench.household.rooms import imported_rooms

ROOT = Path(__file__).parents[1]
FILES = (
    "assets/rooms/*",
    "assets/examples/*",
    "assets/models/*.gguf",
    "assets/pddl/*",
    "reibench/household/objects.csv",
)
"""Files that code of a run reads."""


_parsing = Lock()
"""Python 3.11 counts the depth of its parser for all threads together: two that parse at the same
time can end in a SystemError."""


def code_version(*modules: str) -> str:
    """Return 12 hex digits that change when `modules`, or what they import of ours, does.

    So do they when rooms are imported, or imported ones changed.
    """
    with _parsing:
        return _code_version(modules)


@lru_cache(maxsize=64)
def _code_version(modules: tuple[str, ...]) -> str:
    paths = {*_with_imports(modules), *(path for pattern in FILES for path in ROOT.glob(pattern))}
    sha = hashlib.sha256()
    for path in sorted(paths):
        sha.update(str(path.relative_to(ROOT)).encode() + path.read_bytes())
    for path in sorted(imported_rooms().glob("*.json")):
        sha.update(path.name.encode() + path.read_bytes())
    return sha.hexdigest()[:12]


def _with_imports(modules: Iterable[str]) -> set[Path]:
    """Return the files of `modules` and of everything of this library they import."""
    found: dict[str, Path] = {}
    waiting = list(modules)
    while waiting:
        name = waiting.pop()
        stem = ROOT.joinpath(*name.split("."))
        file = next(filter(Path.is_file, (stem.with_suffix(".py"), stem / "__init__.py")), None)
        if name in found or file is None or not name.startswith("reibench"):
            continue
        found[name] = file
        for node in ast.walk(ast.parse(found[name].read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                waiting += [alias.name for alias in node.names]
            elif isinstance(node, ast.ImportFrom) and node.module:
                waiting.append(node.module)
                waiting += [f"{node.module}.{alias.name}" for alias in node.names]
    return set(found.values())
