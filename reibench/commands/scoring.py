"""`score`: success, error kinds and costs of runs, as text, tables and figures."""

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from reibench.commands.options import add_database, existing_database, listed
from reibench.commands.output import say, say_json, tell
from reibench.errors import ReibenchError, unknown
from reibench.store import Store

if TYPE_CHECKING:
    import pandas as pd

PAPER = "paper"
LATEX = (
    "errors-by-model",
    "errors-by-method",
    "errors-by-model-all-contexts",
    "errors-by-method-all-contexts",
    "tokens",
    "success",
)


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument(
        "--by",
        action="append",
        metavar="COLUMNS",
        help="what to count by: level (default), reference, context, task_type, room, task;"
        " planner, method, model, world, rules … pool the runs that share it; several with commas"
        " cross them, several --by make several tables",
    )
    command.add_argument("--runs", default="", metavar="IDS", help="only these runs")
    for name in ("planner", "method", "model"):
        command.add_argument(f"--{name}", default="", help="only runs of it; several with commas")
    command.add_argument(
        "--against",
        action="append",
        default=[],
        metavar="RUN",
        help="the run others are compared to on the same episodes (default: the first), or"
        " `paper`: its published numbers beside ours",
    )
    command.add_argument(
        "--figures", metavar="DIR", help="also draw success by level and by method, into DIR"
    )
    form = command.add_mutually_exclusive_group()
    form.add_argument("--json", action="store_true", help="print JSON")
    form.add_argument("--csv", action="store_true", help="print one long table")
    form.add_argument("--markdown", action="store_true", help="print Markdown tables")
    form.add_argument("--latex", choices=LATEX, metavar="TABLE", help=f"print {', '.join(LATEX)}")
    add_database(command)
    command.set_defaults(command=score_command)


def score_command(arguments: Namespace) -> int:
    """Print the chosen runs' success, error kinds and costs with intervals."""
    store = Store(existing_database(arguments))
    # pandas takes half a second to import, and most commands never score.
    from reibench.report import Grouping, score_rows
    from reibench.report.markdown import score_markdown
    from reibench.report.selecting import Choice
    from reibench.report.spreadsheet import score_csv
    from reibench.report.tables import TABLES
    from reibench.report.text import score_report

    grouping = Grouping.parse(arguments.by or ["level"])
    frame = Choice(
        runs=listed(arguments.runs),
        planners=listed(arguments.planner),
        methods=listed(arguments.method),
        models=listed(arguments.model),
    ).of(_records(store))
    paper = PAPER in arguments.against
    first = _compared_to(arguments.against, frame)
    if arguments.figures:
        _draw(frame, Path(arguments.figures), paper=paper)
    if arguments.latex:
        say(TABLES[arguments.latex](frame))
    elif arguments.csv:
        say(score_csv(frame, grouping))
    else:
        rows = score_rows(frame, grouping, against=first, paper=paper)
        if arguments.json:
            say_json(rows)
        else:
            say(score_markdown(rows) if arguments.markdown else score_report(rows))
    return 0


def print_scores(arguments: Namespace, store: Store, runs: set[str]) -> int:
    """Print the scores of these runs by level, as text or as JSON."""
    from reibench.report import score_rows
    from reibench.report.text import score_report

    frame = _records(store)
    rows = score_rows(frame[frame["run"].isin(runs)] if len(frame) else frame)
    if arguments.json:
        say_json(rows)
    else:
        say(score_report(rows))
    return 0


def _records(store: Store) -> "pd.DataFrame":
    from reibench.tally import note_faults, records_frame

    note_faults(store)
    return records_frame(store)


def _compared_to(against: list[str], frame: "pd.DataFrame") -> str | None:
    """Return the run that others are compared to; raises UnknownName."""
    named = [run for run in against if run != PAPER]
    if len(named) > 1:
        raise ReibenchError(f"--against {named[0]} and {named[1]} are two runs; name one.")
    known = set(frame["run"]) if len(frame) else set()
    if named and named[0] not in known:
        raise unknown("chosen run", named[0], [PAPER, *sorted(known)])
    return next(iter(named), None)


def _draw(frame: "pd.DataFrame", folder: Path, *, paper: bool) -> None:
    from reibench.report.figures import draw_figures

    for path in draw_figures(frame, folder, paper=paper):
        tell(f"Drew {path}.")
