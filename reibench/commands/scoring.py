"""`score`: success and error kinds of every run."""

from argparse import ArgumentParser, Namespace

from reibench.commands.options import add_database, add_json, existing_database
from reibench.commands.output import say, say_json
from reibench.store import Store


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument("--by", default="level", choices=("level", "task_type", "room"))
    command.add_argument("--markdown", action="store_true", help="print a Markdown table")
    add_database(command)
    add_json(command)
    command.set_defaults(command=score_command)


def score_command(arguments: Namespace) -> int:
    """Print every run's success and error kinds with intervals."""
    store = Store(existing_database(arguments))
    return print_scores(arguments, store, None)


def print_scores(arguments: Namespace, store: Store, runs: set[str] | None) -> int:
    """Print the scores of these runs, or of all."""
    # pandas takes half a second to import, and most commands never score.
    from reibench.report import score_markdown, score_report, score_rows

    by = getattr(arguments, "by", "level")
    rows = score_rows(store, runs, by)
    if arguments.json:
        say_json(rows)
    elif getattr(arguments, "markdown", False):
        say(score_markdown(rows, by))
    else:
        say(score_report(rows, by))
    return 0
