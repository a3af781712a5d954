"""`bench`: speed and memory, measured here and now."""

import json
from argparse import ArgumentParser, Namespace

from reibench.bench import bench_world
from reibench.commands.options import add_json
from reibench.commands.output import say, table


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument("what", choices=("world",))
    add_json(command)
    command.set_defaults(command=bench_command)


def bench_command(arguments: Namespace) -> int:
    """Time the embedded world."""
    result = bench_world()
    if arguments.json:
        say(json.dumps(result))
    else:
        rates = result["skill_steps_per_second"]
        if isinstance(rates, dict):
            say(table(list(rates.items()), ["objects", "skill steps per second"]))
        say(f"64 worlds: {result['memory_mb_64_worlds']} MB")
    return 0
