"""The study's command line: `python -m study COMMAND`."""

import sys
from argparse import ArgumentParser, Namespace
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from pathlib import Path
from tempfile import TemporaryDirectory

from reibench.commands.entry import enter
from reibench.commands.options import add_database, add_json, existing_database, listed
from reibench.commands.output import say, say_json, table, tell
from reibench.errors import ReibenchError
from reibench.store import Store
from study.enrolment import RUN_STATES, Enrolment
from study.exporting import export
from study.reading import read_study
from study.status import status_of
from study.texts import FOLDER


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
    status.add_argument("--simulated", action="store_true", help="of simulated people instead")
    add_database(status)
    add_json(status)
    status.set_defaults(command=_status)
    _add_export(sub.add_parser)
    _add_analysis(sub.add_parser)
    _add_power(sub.add_parser)
    _add_simulations(sub.add_parser)
    for state, verb in zip(RUN_STATES, ("open", "pause", "stop"), strict=True):
        change = sub.add_parser(verb, help=f"the study is {state} from now on")
        change.add_argument("study")
        change.add_argument("--reason", default="")
        add_database(change)
        change.set_defaults(command=_change, state=state)
    return top


def _add_export(add: Callable[..., ArgumentParser]) -> None:
    export = add("export", help="tidy tables: CSV, JSONL and a codebook")
    export.add_argument("study")
    export.add_argument("--out", type=Path, required=True, help="the folder to write to")
    export.add_argument(
        "--everybody", action="store_true", help="simulated and rejected people too, marked"
    )
    add_database(export)
    export.set_defaults(command=_export)


def _add_analysis(add: Callable[..., ArgumentParser]) -> None:
    analysis = add("analysis", help="people by level and type, and beside planners' runs")
    analysis.add_argument("study")
    analysis.add_argument(
        "--runs", default="", help="ids of runs to compare with, with commas (default: all)"
    )
    analysis.add_argument(
        "--figures", type=Path, metavar="DIR", help="draw people beside the planners there"
    )
    analysis.add_argument(
        "--everybody", action="store_true", help="count simulated and rejected people in"
    )
    add_database(analysis)
    add_json(analysis)
    analysis.set_defaults(command=_analysis)


def _add_power(add: Callable[..., ArgumentParser]) -> None:
    power = add("power", help="how many people? the analysis, simulated before the study")
    power.add_argument("file", type=Path, help="the study, in TOML")
    power.add_argument(
        "--person", default="0.9", help="expected success: 0.9, or explicit=0.95,mixed=0.9,…"
    )
    power.add_argument("--planner", default="0.7", help="the planner's, likewise")
    power.add_argument("--run", default="", help="or the id of its run in the database")
    power.add_argument("--people", default="9,18,27,36", help="sizes, with commas (%(default)s)")
    power.add_argument("--between-people", type=float, default=0.5, help="spread, in log odds")
    power.add_argument("--between-tasks", type=float, default=0.5, help="likewise")
    power.add_argument("--simulations", type=int, default=200)
    power.add_argument("--seed", type=int, default=1)
    power.add_argument("--figure", type=Path, help="draw the curve: .png, .svg or .pdf")
    add_database(power)
    add_json(power)
    power.set_defaults(command=_power)


def _add_simulations(add: Callable[..., ArgumentParser]) -> None:
    simulate = add("simulate", help="let simulated people take part, marked as such")
    simulate.add_argument("study")
    simulate.add_argument("--n", type=int, default=30, help="how many (default: %(default)s)")
    simulate.add_argument(
        "--skill", type=float, default=0.8, help="share of trials done right (default: %(default)s)"
    )
    simulate.add_argument("--leave", type=float, default=0.02, help="share of trials left at")
    simulate.add_argument("--together", type=int, default=4, help="so many at a time")
    simulate.add_argument("--seed", type=int, default=1)
    simulate.add_argument(
        "--browser", action="store_true", help="in a real Chromium, by Playwright, one by one"
    )
    add_database(simulate)
    simulate.set_defaults(command=_simulate)
    bench = add("bench", help="how fast the pages answer many participants at once")
    bench.add_argument("--participants", type=int, default=50)
    bench.add_argument(
        "--pause", type=float, default=4.0, help="seconds of thought before a click (4); 0: none"
    )
    add_json(bench)
    bench.set_defaults(command=_bench)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status: 2 for a user's mistake."""
    return enter(parser(), arguments)


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


def _export(arguments: Namespace) -> int:
    enrolment = _enrolment(arguments)
    for file in export(enrolment, arguments.study, arguments.out, everybody=arguments.everybody):
        say(str(file))
    return 0


def _analysis(arguments: Namespace) -> int:
    from study.analysis import analyse, draw  # pandas takes a second to import
    from study.telling import lines

    runs, enrolment = listed(arguments.runs), _enrolment(arguments)
    found = analyse(enrolment, arguments.study, runs, everybody=arguments.everybody)
    if arguments.figures:
        draw(enrolment, arguments.study, arguments.figures, runs, everybody=arguments.everybody)
    if arguments.json:
        say_json(found)
    else:
        say("\n".join(lines(found)))
    return 0


def _power(arguments: Namespace) -> int:
    from study import power  # pandas takes a second to import

    sizes = listed(arguments.people)
    if not sizes or not all(size.isdecimal() and int(size) for size in sizes):
        raise ReibenchError(f"--people {arguments.people!r} should be numbers with commas: 9,18.")
    if arguments.simulations < 1 or min(arguments.between_people, arguments.between_tasks) < 0:
        raise ReibenchError("--simulations must be at least 1, and spreads at least 0.")
    planner: dict[str, bool | float] = {**power.by_reference(arguments.planner, "--planner")}
    if arguments.run:
        planner |= power.outcomes_of(Store(existing_database(arguments)), arguments.run)
    expected = power.Expected(
        power.by_reference(arguments.person, "--person"),
        planner,
        arguments.between_people,
        arguments.between_tasks,
    )
    found = power.power(
        read_study(arguments.file),
        expected,
        [int(size) for size in sizes],
        simulations=arguments.simulations,
        seed=arguments.seed,
        tell=tell,
    )
    if arguments.figure:
        power.draw_curve(found, arguments.figure)
    if arguments.json:
        say_json([asdict(one) for one in found])
    else:
        heads = ["people", "trials", "power (McNemar)", "interval by task", "points"]
        say(table(power.table_rows(found), heads))
    return 0


def _simulate(arguments: Namespace) -> int:
    from study.simulating import Character, Simulation  # gradio takes seconds to import

    if not 0 <= arguments.skill <= 1 or not 0 <= arguments.leave <= 1:
        raise ReibenchError("--skill and --leave are shares, from 0 to 1.")
    if arguments.n < 1 or arguments.together < 1:
        raise ReibenchError("--n and --together must be at least 1.")
    character = Character(skill=arguments.skill, leave=arguments.leave)
    simulation = Simulation(_enrolment(arguments), arguments.study, character, arguments.seed)
    if arguments.browser:
        outcomes = simulation.in_a_browser(arguments.n, tell=tell)
    else:
        outcomes = simulation.run(arguments.n, together=arguments.together, tell=tell)
    say(table(sorted(Counter(one.state for one in outcomes).items()), ["people", "number"]))
    return 0


def _bench(arguments: Namespace) -> int:
    from study.simulating import bench

    if arguments.participants < 1:
        raise ReibenchError("--participants must be at least 1.")
    if not 0 <= arguments.pause <= 60:
        raise ReibenchError(f"--pause {arguments.pause} should be from 0 to 60 seconds.")
    with TemporaryDirectory(prefix="reibench-study-") as folder:
        enrolment = Enrolment(Store(Path(folder) / "bench.db"))
        study = replace(read_study(FOLDER / "study.toml"), people=0)
        enrolment.create(study)
        result = bench(enrolment, study.name, arguments.participants, arguments.pause, tell)
    if arguments.json:
        say_json(result)
    else:
        say(table(list(result.items()), ["measured", "value"]))
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
    status = status_of(enrolment, arguments.study, simulated=arguments.simulated)
    if arguments.json:
        say_json(status)
        return 0
    say(f"{arguments.study}, version {status['version']}, {status['state']}")
    say(table(list(status["people"].items()), ["people", "number"]))
    say(table(list(status["cells"].items()), ["level", "trials held"]))
    return 0


if __name__ == "__main__":
    sys.exit(main())
