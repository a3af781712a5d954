"""How a command line is entered and left: exit statuses, and sentences instead of tracebacks."""

import logging
import sys
from argparse import ArgumentParser
from collections.abc import Sequence

from reibench.commands.output import tell
from reibench.errors import ReibenchError


def enter(parser: ArgumentParser, arguments: Sequence[str] | None) -> int:
    """Run one command of `parser` and return its exit status: 2 for a user's mistake."""
    logging.basicConfig(level=logging.ERROR, format="%(message)s")
    parsed = parser.parse_args(arguments)
    try:
        status: int = parsed.command(parsed)
    except ReibenchError as problem:
        tell(str(problem))
        return 2
    except KeyboardInterrupt:
        tell("Stopped. What was finished is kept; the same command goes on from there.")
        return 130
    except BrokenPipeError:
        sys.stderr.close()
        return 0
    return status
