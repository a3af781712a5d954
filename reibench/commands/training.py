"""`train`: teach the packaged model to plan or to restate, and see how well it learnt."""

import shutil
from argparse import ArgumentParser, Namespace
from dataclasses import asdict
from pathlib import Path

from reibench import models
from reibench.commands.building.realised import solvable
from reibench.commands.options import add_json
from reibench.commands.output import say, say_json, tell
from reibench.dataset.files import write_episodes
from reibench.errors import ReibenchError
from reibench.tuning.evaluating import evaluate_planner, evaluate_resolver
from reibench.tuning.held_out import held_out_episodes
from reibench.tuning.teaching import BASE, ROOMS, SAMPLES, Recipe, teach

FOLDER = Path("data/training")


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    sub = command.add_subparsers(required=True, metavar="WHAT")
    for kind in SAMPLES:
        taught = sub.add_parser(kind, help=f"teach the {kind}; goes on where it was stopped")
        taught.add_argument("--samples", type=int, default=SAMPLES[kind])
        taught.add_argument("--rooms", type=int, default=ROOMS, help="of each kind (%(default)s)")
        taught.add_argument("--seed", type=int, default=1)
        taught.add_argument("--out", type=Path, help=f"folder (default: {FOLDER}/{kind})")
        taught.add_argument(
            "--save", action="store_true", help="put it in place of the shipped one"
        )
        add_json(taught)
        taught.set_defaults(command=_teach, kind=kind)
    tested = sub.add_parser("evaluate", help="ask an adapter what it was not taught")
    tested.add_argument("kind", choices=SAMPLES)
    tested.add_argument("file", type=Path, nargs="?", help="a .gguf (default: the shipped one)")
    tested.add_argument("--samples", type=int, default=60)
    tested.add_argument("--seed", type=int, default=2)
    add_json(tested)
    tested.set_defaults(command=_evaluate)
    made = sub.add_parser("episodes", help="write the made-up episodes that nothing was taught on")
    made.add_argument("--out", type=Path, required=True, help="the episode file (.jsonl) to write")
    made.add_argument("--n", type=int, default=54, help="how many, spread over the nine levels")
    made.add_argument("--seed", type=int, default=1)
    made.set_defaults(command=_episodes)


def _teach(arguments: Namespace) -> int:
    if arguments.samples < 1 or arguments.rooms < 1:
        raise ReibenchError("--samples and --rooms must be at least 1.")
    recipe = Recipe(
        arguments.kind, samples=arguments.samples, rooms=arguments.rooms, seed=arguments.seed
    )
    taught = teach(recipe, arguments.out or FOLDER / arguments.kind, tell)
    if arguments.save:
        models.ADAPTERS.mkdir(exist_ok=True)
        shutil.copyfile(taught.file, models.ADAPTERS / taught.file.name)
    if arguments.json:
        said = {"file": str(taught.file), "seconds": taught.seconds, "losses": list(taught.losses)}
        say_json({**said, "recipe": asdict(recipe)})
    else:
        say(f"{taught.file}: {taught.file.stat().st_size:,} bytes, {taught.seconds / 60:.0f} min")
    return 0


def _evaluate(arguments: Namespace) -> int:
    file = arguments.file or models.ADAPTERS / f"{BASE}-{arguments.kind}.gguf"
    evaluate = evaluate_planner if arguments.kind == "planner" else evaluate_resolver
    result = evaluate(file, arguments.samples, arguments.seed, tell)
    if arguments.json:
        say_json(result)
    else:
        for name, value in result.items():
            say(f"{name.replace('_', ' ')}: {value}")
    return 0


def _episodes(arguments: Namespace) -> int:
    episodes = held_out_episodes(arguments.n, arguments.seed, solvable)
    write_episodes(arguments.out, episodes)
    say(f"{len(episodes)} episodes are in {arguments.out}.")
    return 0
