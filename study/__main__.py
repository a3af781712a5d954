"""The study's command line: `python -m study COMMAND`."""

import logging
import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from pathlib import Path

from reibench.commands.options import add_database, add_json, existing_database
from reibench.commands.output import say, say_json, table, tell
from reibench.errors import ReibenchError
from reibench.store import Store
from study.config import read_study
from study.enrolment import RUN_STATES, Enrolment
from study.status import status_of


def parser() -> ArgumentParser:
    """Return the parser of all commands."""
    top = ArgumentParser(prog="python -m study", description="The human study.")
    sub = top.add_subparsers(required=True, metavar="COMMAND")
    create = sub.add_parser("create", help="keep a study, or a new version of it")
    create.add_argument("file", type=Path, help="a study in TOML, e.g. assets/study/study.toml")
    add_database(create)
    create.set_defaults(command=_create)
    invite = sub.add_parser("invite", help="make invite codes, one a person")
    invite.add_argument("study")
    invite.add_argument("--n", type=int, default=1, help="how many (default: %(default)s)")
    invite.add_argument("--link", default="http://127.0.0.1:7860", help="where the app is served")
    add_database(invite)
    invite.set_defaults(command=_invite)
    status = sub.add_parser("status", help="who is where, and how full the cells are")
    status.add_argument("study", nargs="?", help="one study (default: a line for each)")
    add_database(status)
    add_json(status)
    status.set_defaults(command=_status)
    for state, verb in zip(RUN_STATES, ("open", "pause", "stop"), strict=True):
        change = sub.add_parser(verb, help=f"the study is {state} from now on")
        change.add_argument("study")
        change.add_argument("--reason", default="")
        add_database(change)
        change.set_defaults(command=_change, state=state)
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status: 2 for a user's mistake."""
    logging.basicConfig(level=logging.ERROR, format="%(message)s")
    parsed = parser().parse_args(arguments)
    try:
        status: int = parsed.command(parsed)
    except ReibenchError as problem:
        tell(str(problem))
        return 2
    except BrokenPipeError:
        sys.stderr.close()
        return 0
    return status


def _enrolment(arguments: Namespace) -> Enrolment:
    return Enrolment(Store(existing_database(arguments)))


def _create(arguments: Namespace) -> int:
    study = read_study(arguments.file)
    changed = Enrolment(Store(arguments.db)).create(study)
    tasks = len({episode.task.id for episode in study.chosen()})
    what = "is kept" if changed else "was there already, unchanged"
    say(
        f"Study {study.name!r}, version {study.version}, {what}: {study.trials} of {tasks} tasks"
        f" each, design {study.design}. People take part at /s/{study.name} of the app."
    )
    return 0


def _invite(arguments: Namespace) -> int:
    for code in _enrolment(arguments).invite(arguments.study, arguments.n):
        say(f"{arguments.link.rstrip('/')}/s/{arguments.study}?invite={code}")
    return 0


def _change(arguments: Namespace) -> int:
    _enrolment(arguments).set_state(arguments.study, arguments.state, arguments.reason)
    say(f"Study {arguments.study!r} is {arguments.state}.")
    return 0


def _status(arguments: Namespace) -> int:
    enrolment = _enrolment(arguments)
    if arguments.study is None:
        rows = enrolment.studies()
        if arguments.json:
            say_json(rows)
        else:
            say(table([list(row.values()) for row in rows], ["study", "version", "state", "since"]))
        return 0
    status = status_of(enrolment, arguments.study)
    if arguments.json:
        say_json(status)
        return 0
    say(f"{arguments.study}, version {status['version']}, {status['state']}")
    say(table(list(status["people"].items()), ["people", "number"]))
    say(table(list(status["cells"].items()), ["level", "trials held"]))
    return 0


if __name__ == "__main__":
    sys.exit(main())
