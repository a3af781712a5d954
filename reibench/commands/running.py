"""`run`: let a planner play episodes."""

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from time import perf_counter

from filelock import FileLock, Timeout

from reibench.backends import Backend
from reibench.backends.opening import open_backend
from reibench.commands.options import (
    add_database,
    add_episodes,
    add_json,
    add_world,
    chosen_episodes,
    default_world,
)
from reibench.commands.output import tell
from reibench.commands.scoring import print_scores
from reibench.episode import Episode
from reibench.errors import ReibenchError
from reibench.models import best_present
from reibench.rollout import MAX_STEPS
from reibench.run import RunSpec, evaluate, make_world, needs_model
from reibench.store import Store
from reibench.verdict import error_kind
from reibench.worlds.naming import check_world, renders, verified


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument("--planner", default="saycan", help="see `list planners`")
    command.add_argument(
        "--model", help="llama-cpp:NAME, llama-cpp:FILE.gguf … (default: the best that is here)"
    )
    command.add_argument("--method", default="none", help="none, tocc …; several with commas")
    add_world(command, default_world())
    command.add_argument(
        "--frames", action="store_true", help="keep what cameras see, as files beside the database"
    )
    command.add_argument("--rules", default="strict", help="strict or official")
    command.add_argument("--max-steps", type=int, default=MAX_STEPS)
    command.add_argument("--seed", type=int, default=0, help="added to each episode's own seed")
    add_episodes(command)
    add_database(command)
    add_json(command)
    command.set_defaults(command=run_command)


def run_command(arguments: Namespace) -> int:
    """Play episodes with each planner, method and model asked for; finished ones are kept."""
    model = ""
    if needs_model(arguments.planner):
        model = arguments.model or f"llama-cpp:{best_present()}"
    specs = [
        RunSpec(
            planner=arguments.planner,
            method=method,
            model=model,
            world=arguments.world,
            rules=arguments.rules,
            max_steps=arguments.max_steps,
            seed=arguments.seed,
        )
        for method in arguments.method.split(",")
    ]
    for spec in specs:
        spec.check()
    check_world(arguments.world)
    if arguments.frames and not renders(arguments.world):
        raise ReibenchError(f"The world {arguments.world} renders no frames; ai2thor does.")
    specs = [spec.versioned() for spec in specs]
    chosen = chosen_episodes(arguments)
    store = Store(arguments.db)
    backend = open_backend(specs[0].model) if specs[0].model else None
    for spec in specs:
        with _alone(spec, store):
            _run(spec, chosen, backend, store, frames=arguments.frames)
    ids = {spec.id for spec in specs}
    return print_scores(arguments, store, ids)


@contextmanager
def _alone(spec: RunSpec, store: Store) -> Iterator[None]:
    """Keep a second process off the same run: it would begin again what this one is playing."""
    lock = FileLock(f"{store.path}.{spec.id}.lock", blocking=False)
    try:
        with lock:
            yield
        Path(lock.lock_file).unlink(missing_ok=True)
    except Timeout:
        raise ReibenchError(
            f"Run {spec.id} ({spec.actor}) is already going on in another process; wait for it, or"
            " name another database with --db."
        ) from None


def _run(
    spec: RunSpec,
    chosen: list[Episode],
    backend: Backend | None,
    store: Store,
    *,
    frames: bool,
) -> None:
    before = store.finished(spec)
    left = [episode for episode in chosen if episode.id not in before]
    note = f" ({verified(spec.world)})" if verified(spec.world) else ""
    tell(f"{spec.actor}{note}: {len(chosen)} episodes, {len(chosen) - len(left)} finished before")
    world = make_world(spec, frames=frames, announce=tell)
    begun = perf_counter()
    for number, record in enumerate(evaluate(spec, left, backend, world, store), start=1):
        taken = perf_counter() - begun
        remaining = taken / number * (len(left) - number)
        kind = error_kind(record)
        outcome = record.status if kind is None else f"{record.status}, {kind}"
        tell(
            f"[{number}/{len(left)}] {record.episode.id}: {outcome}, {len(record.steps)} steps;"
            f" {taken:.0f} s, about {remaining:.0f} s left"
        )
    world.close()
