"""The tree is the architecture: who may import whom."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
TRAINING = "reibench/tuning/training.py"
ONLY_IN = {
    "gradio": ("app.py", "reibench/pages/"),
    "fastapi": ("app.py", "reibench/pages/", "reibench/bench/cases.py"),
    "ai2thor": ("reibench/worlds/ai2thor/client.py",),
    "torch": ("reibench/backends/transformers/", "reibench/bench/published.py", TRAINING),
    "transformers": ("reibench/backends/transformers/", "reibench/bench/published.py"),
    "peft": (TRAINING,),
    "gguf": ("reibench/tuning/lora_file.py", "reibench/backends/transformers/"),
    "llguidance": ("reibench/backends/transformers/",),
    "guidance": ("reibench/bench/published.py",),
    "openai": ("reibench/backends/openai.py",),
    "httpx2": ("reibench/backends/openai.py",),
    "xllamacpp": ("reibench/backends/llama_server.py",),
    "unified_planning": ("reibench/planners/pddl.py",),
    "up_fast_downward": ("reibench/planners/pddl.py",),
    "sqlite_utils": ("reibench/store/", "reibench/bench/cases.py"),
    "matplotlib": ("reibench/report/figures.py",),
    "ray": ("reibench/evaluation/on_ray.py",),
    "typst": ("reibench/cases/exporting/figure.py",),
}
LEVELS = {
    "errors": 0, "registry": 0,
    "dialogue": 1, "skill": 1, "episode": 1, "scene": 1, "artefact": 1,
    "goals": 2, "household": 2,
    "worlds": 3, "models": 3, "backends": 3,
    "methods": 4, "dataset": 4, "pool": 4,
    "planners": 5,
    "rollout": 6,
    "explanation": 7, "cases": 8,
    "verdict": 7, "faults": 7, "version": 7, "run": 7, "store": 7, "score": 7, "report": 7,
    "tally": 7, "published": 1, "own_words": 7, "gallery": 7,
    "replay": 7, "watching": 7, "sittings": 7, "view": 7, "fidelity": 7, "evaluation": 7,
    "tuning": 8, "bench": 10, "commands": 10, "pages": 9, "__main__": 10,
}  # fmt: skip
MODULES = sorted((ROOT / "reibench").rglob("*.py"))
HEAVY = (
    "torch", "ai2thor", "gradio", "fastapi", "xllamacpp", "transformers", "llguidance", "openai",
    "unified_planning", "up_fast_downward", "matplotlib", "ray", "guidance", "peft", "gguf",
    "typst",
)  # fmt: skip
CATCHING = {"run.py"}
"""Where everything may be caught: an episode that breaks is recorded as an error."""


def name_of(path: Path) -> str:
    return str(path.relative_to(ROOT))


def imported(tree: ast.AST) -> list[str]:
    names = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module:
            names.append(node.module)
    return names


@pytest.mark.parametrize("path", MODULES, ids=name_of)
def test_heavy_packages_stay_in_their_module(path):
    for module in imported(ast.parse(path.read_text())):
        homes = ONLY_IN.get(module.split(".")[0])
        assert homes is None or name_of(path).startswith(homes), module


@pytest.mark.parametrize("path", MODULES, ids=name_of)
def test_modules_say_what_they_are_for(path):
    assert ast.get_docstring(ast.parse(path.read_text()))


@pytest.mark.parametrize("path", MODULES, ids=name_of)
def test_modules_import_only_their_own_and_lower_levels(path):
    parts = path.relative_to(ROOT / "reibench").parts
    if parts == ("__init__.py",):
        return
    here = LEVELS[parts[0].removesuffix(".py")]
    for module in imported(ast.parse(path.read_text())):
        if module.startswith("reibench."):
            assert LEVELS[module.split(".")[1]] <= here, module


def test_the_household_simulator_can_be_used_alone():
    allowed = {"reibench.errors", "reibench.scene"}
    for path in sorted((ROOT / "reibench" / "household").rglob("*.py")):
        for module in imported(ast.parse(path.read_text())):
            if module.startswith("reibench.") and not module.startswith("reibench.household"):
                assert module in allowed, f"{name_of(path)} imports {module}"


def test_importing_the_library_loads_nothing_heavy():
    code = (
        "import sys, reibench, reibench.run, reibench.store, reibench.worlds.embedded;"
        "import reibench.__main__;"
        f"print(*set({HEAVY!r}) & sys.modules.keys())"
    )
    run = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, check=False
    )
    assert run.stdout.strip() == "", run.stdout + run.stderr
    assert run.returncode == 0, run.stderr


def test_only_the_engine_catches_everything():
    catching = {
        path.name
        for path in MODULES
        for node in ast.walk(ast.parse(path.read_text()))
        if isinstance(node, ast.ExceptHandler)
        and (node.type is None or ast.unparse(node.type) in {"Exception", "BaseException"})
        # Handlers that clean up and raise again hide nothing.
        and not any(isinstance(inner, ast.Raise) for inner in ast.walk(node))
    }
    assert catching <= CATCHING


def test_the_repository_names_no_machine_and_no_registry():
    listed = subprocess.run(
        ["git", "ls-files", "*.py", "*.md", "*.toml", "*.txt", "Makefile", ".ci/run"],
        capture_output=True, text=True, cwd=ROOT, check=True,
    )  # fmt: skip
    for name in filter(lambda name: (ROOT / name).exists(), listed.stdout.split()):
        text = (ROOT / name).read_text(encoding="utf-8")
        assert "/ro" + "ot/" not in text, name
        assert "/wo" + "rk/" not in text, name
