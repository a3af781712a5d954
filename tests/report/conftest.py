"""Two small runs that a script plays, scored through the command line; the numbers by hand."""

import json
import sqlite3
from collections.abc import Callable, Iterable
from contextlib import closing
from pathlib import Path

import pytest

from reibench.__main__ import main
from reibench.backends import Generation, Prompt, Selection, Usage
from reibench.backends.scripted import ScriptedBackend
from reibench.methods import Instruction
from reibench.planners.expert import Expert
from reibench.rollout import Rollout, drive
from reibench.run import RunSpec, evaluate
from reibench.store import Store
from reibench.worlds import worlds

BUDGET = 12
"""As long as heating the potato takes, so that nobody gets to say done after it."""
NONE = RunSpec(model="scripted:toy", max_steps=BUDGET)
TOCC = RunSpec(model="scripted:toy", method="tocc", max_steps=BUDGET)


class MeteredBackend(ScriptedBackend):
    """A script whose every answer costs the same."""

    def generate(self, prompt: Prompt, **limits) -> Generation:
        answer = super().generate(prompt, **limits)
        return Generation(answer.text, Usage(40, 10, 8, 0.5), answer.prompt)

    def choose(self, prompt: Prompt, options) -> Selection:
        chosen = super().choose(prompt, options)
        usage = Usage(100, 90, 5, 0.25, 0.001)
        return Selection(chosen.text, usage, chosen.alternatives, chosen.prompt)


@pytest.fixture(scope="session")
def solutions(episodes) -> dict[str, list[str]]:
    """Return the skills that solve the two tasks."""
    found = {}
    for name in ("heat_potato", "pick_keys"):
        task = episodes[f"{name}.explicit-standard"].task
        rollout = Rollout(episodes[f"{name}.explicit-standard"], worlds.create("embedded"))
        rollout.start()
        steps = drive(rollout, Expert(task.goal), Instruction(text="", original=""))
        found[name] = [step.decision.skill.text for step in steps]
    assert len(found["heat_potato"]) == BUDGET
    return found


@pytest.fixture(scope="session")
def play(episodes) -> Callable[[Store, RunSpec, dict[str, list[str]]], None]:
    """Play episodes as a script says, into a database."""

    def played(store: Store, spec: RunSpec, plans: dict[str, list[str]]) -> None:
        answers: Iterable[str] = (text for plan in plans.values() for text in plan)
        backend = MeteredBackend([*answers])
        chosen = [episodes[name] for name in plans]
        list(evaluate(spec, chosen, backend, worlds.create("embedded"), store))

    return played


@pytest.fixture(scope="session")
def played_once(play, solutions, tmp_path_factory) -> Path:
    """Play two tasks at nine levels, without a method and with TOCC.

    In each context, of two episodes a level, solved without: 2, 1, 0; with TOCC: 2, 2, 1. Heating
    is never said done, for lack of steps. What fails without TOCC: at mixed, nothing is done for
    the potato; at implicit a tomato is taken for it, and the keys are picked up and kept. With
    it, at implicit, the potato is picked up and kept.
    """
    heat, keys = solutions["heat_potato"], [*solutions["pick_keys"], "done"]
    tomato = ["find a tomato", "pick up the tomato", "done"]
    kept_keys = [*keys[:2], "done"]
    kept_potato = [*heat[:2], "done"]
    without = {
        "explicit": (heat, keys), "mixed": (["done"], keys), "implicit": (tomato, kept_keys),
    }  # fmt: skip
    with_tocc = {
        "explicit": (heat, keys), "mixed": (heat, keys), "implicit": (kept_potato, keys),
    }  # fmt: skip
    store = Store(tmp_path_factory.mktemp("played") / "records.db")
    play(store, NONE, _at_all_levels(without, []))
    play(store, TOCC, _at_all_levels(with_tocc, ["Do it."]))
    return store.path


@pytest.fixture
def two_runs(played_once, store) -> None:
    """Have these two runs in the test's own database."""
    with (
        closing(sqlite3.connect(played_once)) as source,
        closing(sqlite3.connect(store.path)) as copy,
    ):
        source.backup(copy)


def _at_all_levels(plans, first: list[str]) -> dict[str, list[str]]:
    return {
        f"{task}.{reference}-{context}": [*first, *plan]
        for reference, pair in plans.items()
        for context in ("standard", "noised", "short")
        for task, plan in zip(("heat_potato", "pick_keys"), pair, strict=True)
    }


@pytest.fixture
def score(store, capsys) -> Callable[..., str]:
    """Run `score` over the test's database and return what it prints."""

    def scored(*arguments: str) -> str:
        capsys.readouterr()
        assert main(["score", "--db", str(store.path), *arguments]) == 0
        return capsys.readouterr().out

    return scored


@pytest.fixture
def score_json(score) -> Callable[..., list]:
    return lambda *arguments: json.loads(score(*arguments, "--json"))
