"""`models`: the model shelf, and fetching a model."""

from argparse import ArgumentParser, Namespace
from dataclasses import asdict
from time import monotonic

from reibench import models
from reibench.commands.output import say, say_json, tell
from reibench.models import presets

REPORT_EVERY = 0.5
"""Seconds between two lines of progress."""


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument("--json", action="store_true", help="print JSON")
    command.set_defaults(command=models_command)
    sub = command.add_subparsers(metavar="get NAME")
    get = sub.add_parser("get", help="fetch a model; a broken download goes on where it stopped")
    get.add_argument("name", help="its name on the shelf")
    get.set_defaults(command=get_command)


def models_command(arguments: Namespace) -> int:
    """Print which models are known, which are here, and which one is used by default."""
    if arguments.json:
        say_json([asdict(shelved) for shelved in models.overview()])
    else:
        say(f"{models.table()}\n\n{presets.table()}")
    return 0


def get_command(arguments: Namespace) -> int:
    """Fetch one model, telling how far it is."""
    last = -REPORT_EVERY

    def progress(done: int, total: int) -> None:
        nonlocal last
        if monotonic() - last >= REPORT_EVERY or done == total:
            last = monotonic()
            share = f" ({done / total:.0%})" if total else ""
            tell(
                f"\r{arguments.name}: {models.in_megabytes(done)} of"
                f" {models.in_megabytes(total)}{share}   ",
                end="",
            )

    try:
        path = models.get(arguments.name, progress)
    finally:
        if last > 0:
            tell("")
    say(f"{arguments.name} is at {path}")
    return 0
