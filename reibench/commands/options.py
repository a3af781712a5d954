"""Options that several commands share."""

import os
from argparse import ArgumentParser, Namespace, RawDescriptionHelpFormatter
from math import sqrt
from pathlib import Path

from reibench.dataset.files import read_episodes, shipped_episodes
from reibench.dataset.sample import select
from reibench.episode import Episode
from reibench.errors import ReibenchError, StoreUnavailable
from reibench.worlds.naming import world_settings


def add_episodes(command: ArgumentParser) -> None:
    """Add the options that choose episodes."""
    command.add_argument(
        "--episodes", default="all", help="all, levels, types, rooms, ids, gold, rei-1000, FILE"
    )
    command.add_argument("--limit", type=int, help="at most so many, spread evenly over them")
    command.add_argument("--data", action="append", default=[], help="an episode file (.jsonl)")


def add_database(command: ArgumentParser) -> None:
    """Add the option that names the database."""
    default = os.environ.get("REIBENCH_DB", "data/reibench.db")
    command.add_argument("--db", default=default, help="the SQLite file (default: %(default)s)")


def add_json(command: ArgumentParser) -> None:
    """Add the option that asks for JSON."""
    command.add_argument("--json", action="store_true", help="print JSON")


def add_world(command: ArgumentParser, default: str, without: str = "") -> None:
    """Add the option that names the world; `without` says what is used if it is not given."""
    command.add_argument(
        "--world",
        default=default,
        help="embedded, ai2thor, ai2thor:stand-in, ai2thor:PATH or ai2thor:BUILD"
        f" (default: {without or '%(default)s'})",
    )
    command.formatter_class = RawDescriptionHelpFormatter
    command.epilog = "The ai2thor world is set up by environment variables:\n" + "\n".join(
        f"  {name:<30} {meaning}" for name, meaning in world_settings().items()
    )


def default_world() -> str:
    """Return the world used unless another is named."""
    return os.environ.get("REIBENCH_WORLD", "embedded")


def chosen_episodes(arguments: Namespace) -> list[Episode]:
    """Return the chosen episodes; `--limit` takes that many, spread evenly over them."""
    source = [each for path in arguments.data for each in read_episodes(Path(path))]
    chosen = select(source or shipped_episodes(), arguments.episodes)
    limit = arguments.limit
    if limit is not None and limit < 1:
        raise ReibenchError(f"--limit {limit} leaves no episode; it must be at least 1.")
    if not chosen:
        raise ReibenchError(f"No episode is all of {arguments.episodes!r}.")
    if limit is None or limit >= len(chosen):
        return chosen
    # Golden-ratio order: any first few are spread over tasks and levels, and more extend fewer.
    spread = sorted(range(len(chosen)), key=lambda place: place * (sqrt(5) - 1) / 2 % 1)
    return [chosen[place] for place in sorted(spread[:limit])]


def listed(text: str) -> tuple[str, ...]:
    """Return the parts of an option that takes several, with commas."""
    return tuple(part.strip() for part in text.split(",") if part.strip())


def existing_database(arguments: Namespace) -> Path:
    """Return the database's path; an empty one made by a typing error would hide it."""
    path = Path(arguments.db)
    if not path.exists():
        raise StoreUnavailable(f"There is no database {path}; `run` makes one, --db names one.")
    return path
