"""`bench`: speed and memory, measured here and now."""

import json
from argparse import ArgumentParser, Namespace
from typing import Any

from reibench.bench import bench_world
from reibench.commands.options import add_json
from reibench.commands.output import say, table


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument("what", choices=("world",))
    add_json(command)
    command.set_defaults(command=bench_command)


def bench_command(arguments: Namespace) -> int:
    """Time the embedded world, alone and beside itself over AI2-THOR's wires."""
    result: dict[str, Any] = bench_world()
    if arguments.json:
        say(json.dumps(result))
    else:
        for line in _lines(result):
            say(line)
    return 0


def _lines(result: dict[str, Any]) -> list[str]:
    sizes = [
        [size, rate, result["working_skill_steps_per_second"][size], f"{share:.0%}"]
        for size, rate, share in zip(
            result["skill_steps_per_second"],
            result["skill_steps_per_second"].values(),
            result["share_that_worked"].values(),
            strict=True,
        )
    ]
    sides = [
        [way, each["visits"], each["working"], f"{each['working_to_embedded']:.2%}"]
        for way, each in result["side_by_side"].items()
    ]
    return [
        "The embedded world: visits try what can be done with one thing after another, and many"
        " are refused; working steps are the expert's plan.",
        table(sizes, ["objects", "visits a second", "working steps a second", "visits that work"]),
        f"64 worlds: {result['memory_mb_64_worlds']} MB",
        "",
        f"Side by side with {result['side_by_side_objects']} objects; FIFO and WSGI are the same"
        " world through AI2-THOR's client and the wire stand-in (protocol-verified):",
        table(sides, ["world", "visits a second", "working steps a second", "to embedded"]),
    ]
