"""`import rei-bench`: the official split, each entry at its nine levels."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from reibench.commands.options import add_json
from reibench.commands.output import say, say_json
from reibench.dataset.alfred import find_trials, in_names_of
from reibench.dataset.files import write_episodes
from reibench.dataset.rei_bench import read_rei_bench
from reibench.household import load_room

PURPOSE = "the official REI-Bench split, over the ALFRED trials it names"


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument("file", type=Path, metavar="FILE", help="rei_bench.json")
    command.add_argument("--alfred", type=Path, required=True, help="where the trials are")
    command.add_argument("--out", type=Path, required=True, help="the episode file to write")
    add_json(command)
    command.set_defaults(command=import_command)


def import_command(arguments: Namespace) -> int:
    """Write the split's episodes."""
    trials = find_trials(arguments.alfred)
    fitted = [in_names_of(load_room(trial.setup.room).objects, trial) for trial in trials]
    episodes = read_rei_bench(arguments.file, fitted)
    write_episodes(arguments.out, episodes)
    counts = {"episodes": len(episodes), "tasks": len({each.task.id for each in episodes})}
    if arguments.json:
        say_json(counts)
    else:
        say(f"{counts['episodes']} episodes of {counts['tasks']} tasks are in {arguments.out}.")
    return 0
