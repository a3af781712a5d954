"""`import`: bring in rooms and trials from elsewhere; one source a module of this folder."""

from argparse import ArgumentParser
from importlib import import_module
from pkgutil import iter_modules


def add(command: ArgumentParser) -> None:
    """Add a subcommand for each source.

    A source is a module with `PURPOSE`, one line, and `add`, which adds options and sets the
    command. Its name on the command line is the module's, with hyphens.
    """
    sub = command.add_subparsers(required=True, metavar="SOURCE")
    for found in iter_modules(__path__):
        source = import_module(f"{__name__}.{found.name}")
        name = found.name.replace("_", "-")
        source.add(sub.add_parser(name, help=source.PURPOSE, description=source.PURPOSE))
