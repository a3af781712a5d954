"""`run`: let planners play episodes."""

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from contextlib import ExitStack, closing, contextmanager, suppress
from pathlib import Path

from filelock import FileLock, Timeout

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
from reibench.errors import ReibenchError
from reibench.evaluation.conducting import Conductor, Staff
from reibench.evaluation.interrupting import ending_at_the_second
from reibench.evaluation.product import Share, product, share_of
from reibench.evaluation.progress import Progress
from reibench.models import best_present
from reibench.rollout import MAX_STEPS
from reibench.run import RunSpec, needs_model
from reibench.store import Store
from reibench.worlds.naming import check_world, renders


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument(
        "--planner", default="saycan", help="see `list planners`; several with commas"
    )
    command.add_argument(
        "--model",
        help="llama-cpp:NAME, llama-cpp:FILE.gguf …; several with commas (default: the best that"
        " is here)",
    )
    command.add_argument("--method", default="none", help="none, tocc …; several with commas")
    add_world(command, default_world())
    command.add_argument(
        "--frames", action="store_true", help="keep what cameras see, as files beside the database"
    )
    command.add_argument("--rules", default="strict", help="strict or official")
    command.add_argument("--max-steps", type=int, default=MAX_STEPS)
    command.add_argument("--seed", type=int, default=0, help="added to each episode's own seed")
    command.add_argument(
        "--workers",
        type=int,
        default=0,
        metavar="N",
        help="play N episodes at once: threads where the model is a server, else processes, each"
        " with its own copy of the model (default: 1)",
    )
    command.add_argument(
        "--ray",
        default="",
        metavar="ADDRESS",
        help="play on a Ray cluster: HOST:PORT, auto or local (default: one worker a node that"
        " opens a model, else one a processor)",
    )
    command.add_argument("--retry-errors", action="store_true", help="play again what broke before")
    add_episodes(command)
    add_database(command)
    add_json(command)
    command.set_defaults(command=run_command)


def run_command(arguments: Namespace) -> int:
    """Play episodes with each planner, method and model asked for; finished ones are kept."""
    if arguments.workers < 0:
        raise ReibenchError(f"--workers {arguments.workers} is too few; it must be at least 1.")
    specs = _specs(arguments)
    chosen = chosen_episodes(arguments)
    store = Store(arguments.db)
    with ExitStack() as locks:
        for spec in specs:
            locks.enter_context(_alone(spec, store))
        shares = [share_of(spec, chosen, store, retry=arguments.retry_errors) for spec in specs]
        _run(shares, store, Staff(arguments.workers, arguments.ray, arguments.frames))
    return print_scores(arguments, store, {spec.id for spec in specs})


def _specs(arguments: Namespace) -> list[RunSpec]:
    """Return the runs asked for; raises ReibenchError for anything that cannot be had."""
    planners, methods = _listed(arguments.planner), _listed(arguments.method)
    models = _listed(arguments.model or "")
    if not models and any(needs_model(planner) for planner in planners):
        models = [f"llama-cpp:{best_present()}"]
    base = RunSpec(
        world=arguments.world,
        rules=arguments.rules,
        max_steps=arguments.max_steps,
        seed=arguments.seed,
    )
    specs = product(base, planners, methods, models)
    for spec in specs:
        spec.check()
    check_world(arguments.world)
    if arguments.frames and not renders(arguments.world):
        raise ReibenchError(f"The world {arguments.world} renders no frames; ai2thor does.")
    return [spec.versioned() for spec in specs]


def _listed(text: str) -> list[str]:
    return [part.strip() for part in text.split(",") if part.strip()]


@contextmanager
def _alone(spec: RunSpec, store: Store) -> Iterator[None]:
    """Keep a second process off the same run: it would begin again what this one is playing."""
    lock = FileLock(f"{store.path}.{spec.id}.lock", blocking=False)
    try:
        lock.acquire()
    except Timeout:
        raise ReibenchError(
            f"Run {spec.id} ({spec.actor}) is already going on in another process; wait for it, or"
            " name another database with --db."
        ) from None
    try:
        yield
    finally:
        with suppress(OSError):  # where a file in use cannot be removed, it stays
            Path(lock.lock_file).unlink()
        lock.release()


def _run(shares: list[Share], store: Store, staff: Staff) -> None:
    progress = None
    try:
        with ending_at_the_second(tell), closing(Conductor(shares, staff)) as conductor:
            progress = Progress(shares, staff.workers)
            for line in progress.opening():
                tell(line)
            with closing(conductor.perform(store, tell)) as outcomes:
                for spec, record, seconds in outcomes:
                    for line in progress.note(spec, record, seconds):
                        tell(line)
    finally:  # told after Ctrl-C was answered
        if progress and progress.total:
            tell(progress.closing())
