"""The command line: `python -m reibench COMMAND`."""

import sys
from argparse import ArgumentParser
from collections.abc import Sequence

from reibench.commands import (
    benching,
    building,
    checking,
    comparing,
    dumping,
    importing,
    listing,
    replaying,
    running,
    sampling,
    scoring,
    shelving,
    showing,
    training,
    viewing,
)
from reibench.commands.entry import enter

COMMANDS = {
    "list": (listing, "what there is: episodes, rooms, skills, planners …"),
    "models": (shelving, "the model shelf: what is there, and fetching more"),
    "run": (running, "let a planner play episodes; goes on where it was stopped"),
    "score": (scoring, "success and error kinds of every run, with intervals"),
    "replay": (replaying, "play records again, and verify that they come out the same"),
    "sample": (sampling, "a balanced choice of episodes, frozen in a manifest"),
    "build-dataset": (building, "episodes from scripts, and scripts from seeds"),
    "import": (importing, "bring in rooms and trials from elsewhere"),
    "compare-rooms": (comparing, "the shipped rooms beside AI2-THOR's real ones, in numbers"),
    "dump": (dumping, "write object metadata of a simulator's rooms, for `import ithor`"),
    "view": (viewing, "write pages to look at: all rooms on a contact sheet"),
    "check-dataset": (checking, "are the episodes sound, and can they be solved?"),
    "train": (training, "teach the packaged model to plan, or to restate"),
    "gallery": (showing, "the recorded runs that come along"),
    "bench": (benching, "measure speed and memory"),
}


def parser() -> ArgumentParser:
    """Return the parser of all commands."""
    top = ArgumentParser(prog="python -m reibench", description="REI-Bench on the command line.")
    sub = top.add_subparsers(required=True, metavar="COMMAND")
    for name, (module, purpose) in COMMANDS.items():
        module.add(sub.add_parser(name, help=purpose, description=purpose))
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status: 2 for a user's mistake."""
    return enter(parser(), arguments)


if __name__ == "__main__":
    sys.exit(main())
