"""From nothing to an adapter's file: make the lessons, teach them, write the file."""

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from importlib.metadata import version
from importlib.util import find_spec
from itertools import islice
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Literal

from reibench.errors import ModelUnavailable, ReibenchError
from reibench.tuning.grounds import made_up
from reibench.tuning.lessons import Lesson, lessons
from reibench.tuning.restatements import Restatement, restatements
from reibench.worlds.embedded import embedded_world
from reibench.worlds.rules import RULES

if TYPE_CHECKING:
    from reibench.backends.transformers.loading import Loaded

Kind = Literal["planner", "resolver"]
BASE = "gemma-3-270m"
ROOMS = 60
"""Rooms of each kind to teach in."""
SAMPLES: dict[Kind, int] = {"planner": 3000, "resolver": 1600}
NEEDED = ("torch", "transformers", "peft", "gguf")
INSTALL = "pip install -r requirements-train.txt"

Told = Callable[[str], object]


@dataclass(frozen=True)
class Recipe:
    """How an adapter is taught; the same recipe gives the same lessons."""

    kind: Kind
    samples: int = 0
    """0 for as many as the shipped one had."""
    rooms: int = ROOMS
    seed: int = 1
    rank: int = 16
    alpha: int = 32
    batch: int = 8
    rate: float = 1.5e-3
    """The highest learning rate, after the warm-up; from then on it falls to nothing."""
    warm_up: int = 20
    clip: float = 1.0

    @property
    def lessons(self) -> int:
        """How many lessons there are."""
        return self.samples or SAMPLES[self.kind]


@dataclass(frozen=True)
class Taught:
    """What came of teaching."""

    file: Path
    recipe: Recipe
    seconds: float
    losses: Sequence[float]
    versions: dict[str, str] = field(default_factory=dict)


def lessons_of(recipe: Recipe) -> list[Lesson] | list[Restatement]:
    """Return the lessons of a recipe, made anew."""
    with made_up(recipe.rooms) as rooms:
        if recipe.kind == "resolver":
            return list(islice(restatements(rooms, recipe.seed), recipe.lessons))
        worlds = [embedded_world(rules) for rules in RULES.values()]
        try:
            return list(islice(lessons(rooms, worlds, recipe.seed), recipe.lessons))
        finally:
            for world in worlds:
                world.close()


def teach(recipe: Recipe, folder: Path, tell: Told, base: "Loaded | None" = None) -> Taught:
    """Teach an adapter, going on from what is in `folder`, and write its file there.

    `base` is the model, opened already; it comes back as it was.

    Raises:
        ModelUnavailable: when packages or the model are missing.
        ReibenchError: when `folder` has been begun by another recipe.
    """
    _check(recipe)
    # all of it heavy
    from reibench.backends.transformers.loading import load
    from reibench.backends.transformers.source import Source
    from reibench.tuning import coding, lora_file
    from reibench.tuning.training import Trainer

    _claim(folder, recipe)
    started = perf_counter()
    tell(f"Making {recipe.lessons} lessons for the {recipe.kind} …")
    made = lessons_of(recipe)
    if base is None:
        tell(f"Opening {BASE} …")
    loaded = base or load(Source(BASE, dtype="float32", device="cpu"))
    coded, allowed = coding.coded(made, loaded.tokenizer)
    trainer = Trainer(loaded.model, coded, allowed, recipe, folder)

    def progress(done: int, steps: int, loss: float, left: float) -> None:
        if done % 10 == 0 or done in (1, steps):
            tell(f"[{done}/{steps}] loss {loss:.4f}, about {left / 60:.0f} min left")

    trainer.run(progress)
    file = folder / f"{BASE}-{recipe.kind}.gguf"
    lora_file.write(trainer.weights(), file, name=recipe.kind, alpha=recipe.alpha)
    trainer.close()
    seconds = perf_counter() - started
    versions = {name: version(name) for name in NEEDED}
    taught = Taught(file, recipe, seconds, trainer.losses, versions)
    (folder / "card.json").write_text(_card(taught), encoding="utf-8")
    return taught


def _check(recipe: Recipe) -> None:
    """Refuse what cannot be taught here."""
    if missing := [name for name in NEEDED if find_spec(name) is None]:
        raise ModelUnavailable(
            f"Training needs what is not installed here ({', '.join(missing)}); install it with"
            f" '{INSTALL}'."
        )
    if recipe.lessons < recipe.batch:
        raise ReibenchError(
            f"{recipe.lessons} samples are less than one batch; take at least {recipe.batch}."
        )


def _claim(folder: Path, recipe: Recipe) -> None:
    """Note the recipe in `folder`, or refuse one that has been begun by another."""
    folder.mkdir(parents=True, exist_ok=True)
    noted, text = folder / "recipe.json", json.dumps(asdict(recipe), indent=1)
    if noted.is_file() and noted.read_text(encoding="utf-8") != text:
        raise ReibenchError(
            f"{folder} has been begun by another recipe ({noted.name} says which); name another"
            " folder with --out, or delete it."
        )
    noted.write_text(text, encoding="utf-8")


def _card(taught: Taught) -> str:
    late = taught.losses[-20:]
    facts = {
        "recipe": asdict(taught.recipe),
        "lessons": taught.recipe.lessons,
        "seconds": round(taught.seconds),
        "loss_at_the_end": sum(late) / len(late),
        "versions": taught.versions,
    }
    return json.dumps(facts, indent=1)
