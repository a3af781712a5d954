"""`import alfred`: ALFRED's trials as episodes, or a report of how faithfully they are restored."""

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import Any

from reibench.commands.options import add_json
from reibench.commands.output import say, say_json, table, tell
from reibench.dataset.alfred import episodes_of, find_trials, in_names_of
from reibench.dataset.files import write_episodes
from reibench.errors import ReibenchError
from reibench.household import load_room

PURPOSE = "ALFRED's trials, each annotator's words as an explicit instruction"


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument("folder", type=Path, metavar="DIR", help="where traj_data.json files are")
    command.add_argument("--out", type=Path, help="the episode file (.jsonl) to write")
    command.add_argument("--report", action="store_true", help="restore and play all, and report")
    command.add_argument("--rooms", type=Path, help="dumps of rooms (default: the imported ones)")
    command.add_argument("--workers", type=int, default=1, help="processes that share the report")
    add_json(command)
    command.set_defaults(command=import_command)


def import_command(arguments: Namespace) -> int:
    """Write episodes, or print the report."""
    if arguments.report:
        return _report(arguments)
    if arguments.out is None:
        raise ReibenchError("Say where to write the episodes, --out FILE.jsonl, or --report.")
    trials = find_trials(arguments.folder)
    fitted = [in_names_of(load_room(trial.setup.room).objects, trial) for trial in trials]
    episodes = [episode for trial in fitted for episode in episodes_of(trial)]
    write_episodes(arguments.out, episodes)
    left = sum(trial.goal is None for trial in trials)
    counts = {"trials": len(trials), "two_object_trials": left, "episodes": len(episodes)}
    if arguments.json:
        say_json(counts)
    else:
        say(
            f"{len(episodes)} episodes of {len(trials) - left} trials are in {arguments.out};"
            f" {left} trials about two objects are left out."
        )
    return 0


def _report(arguments: Namespace) -> int:
    # The expert and the rules come with it, which no other import needs.
    from reibench.fidelity import fidelity_report

    trials = find_trials(arguments.folder)
    tell(f"{len(trials)} trials are restored and played …")
    report = fidelity_report(trials, arguments.rooms, arguments.workers)
    if arguments.json:
        say_json(report)
    else:
        _print(report)
    return 0


def _print(report: dict[str, Any]) -> None:
    say(f"{report['trials']} trials, {report['single_object_trials']} of them about one object")
    for kind in ("poses", "parents", "plan", "starts"):
        say(f"{kind}: " + ", ".join(f"{name} {count}" for name, count in report[kind].items()))
    rows = [
        [rules, found["expert_plan_success"], found["expert_success"]]
        for rules, found in report["rules"].items()
    ]
    say(table(rows, ["rules", "the trial's plan", "our expert"]))
    for rules, found in report["rules"].items():
        for who in ("expert_plan", "expert"):
            for failure in found[f"{who}_failures"]:
                say(f"{rules}, {who}: {failure['trial']}, {failure['task']}: {failure['reason']}")
