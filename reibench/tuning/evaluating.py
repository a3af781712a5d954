"""How well an adapter learnt: asked in rooms and of things that nothing was taught with."""

from collections import Counter
from collections.abc import Callable
from contextlib import closing
from itertools import islice
from pathlib import Path
from statistics import median
from typing import Any

from reibench import models
from reibench.backends import Prompt
from reibench.backends.llama_cpp import LlamaCpp
from reibench.errors import ReibenchError
from reibench.methods.restating import grammar
from reibench.planners.saycan import SayCan
from reibench.rollout import Rollout, drive
from reibench.tuning.grounds import HELD_OUT, made_up
from reibench.tuning.lessons import asked_for
from reibench.tuning.restatements import restatements, untaught_lexicon
from reibench.tuning.teaching import BASE
from reibench.worlds.embedded import embedded_world

ROOMS = 8
"""Rooms of each kind to ask in."""

Told = Callable[[str], object]


def evaluate_planner(file: Path, samples: int, seed: int, tell: Told) -> dict[str, Any]:
    """Let the planner's adapter carry out clear requests in new rooms, by the strict rules."""
    solved: Counter[str] = Counter()
    played: Counter[str] = Counter()
    seconds: list[float] = []
    with made_up(ROOMS, HELD_OUT) as rooms, closing(_model("planner", file, samples)) as model:
        world = embedded_world()
        for number, (episode, told) in enumerate(islice(asked_for(rooms, seed), samples), start=1):
            rollout = Rollout(episode, world)
            rollout.start()
            steps = list(drive(rollout, SayCan(model), told))
            seconds += [step.decision.usage.seconds for step in steps]
            kind = episode.task.goal.task_type.short
            played[kind] += 1
            solved[kind] += rollout.status == "success"
            tell(f"[{number}/{samples}] {told.text!r}: {rollout.status}")
    each = {kind: f"{solved[kind]} of {played[kind]}" for kind in sorted(played)}
    return {
        "solved": f"{solved.total()} of {played.total()}",
        **each,
        "median_seconds_a_step": round(median(seconds), 3),
    }


def evaluate_resolver(file: Path, samples: int, seed: int, tell: Told) -> dict[str, Any]:
    """Let the resolver's adapter restate requests with expressions that were kept back."""
    right: Counter[str] = Counter()
    with made_up(ROOMS, HELD_OUT) as rooms, closing(_model("resolver", file, samples)) as model:
        asked = restatements(rooms, seed, untaught_lexicon())
        for number, one in enumerate(islice(asked, samples), start=1):
            prompt = Prompt(one.asked, adapter="resolver")
            said = model.generate(prompt, max_tokens=40, stop=("\n",), grammar=grammar()).text
            right["restated"] += said.strip() == one.answer.strip()
            tell(f"[{number}/{samples}] {said.strip()} (meant: {one.answer.strip()})")
    return {"restated_right": f"{right['restated']} of {samples}"}


def _model(adapter: str, file: Path, samples: int) -> LlamaCpp:
    if samples < 1:
        raise ReibenchError(f"--samples {samples} asks nothing; it must be at least 1.")
    return LlamaCpp(models.path_of(BASE), adapters={adapter: file})
