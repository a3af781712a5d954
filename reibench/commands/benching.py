"""`bench`: speed and memory, measured here and now."""

import json
from argparse import ArgumentParser, Namespace
from typing import Any

from reibench.bench.planner import STEPS, bench_planner
from reibench.bench.worlds import bench_world
from reibench.commands.options import add_json
from reibench.commands.output import say, table
from reibench.errors import ReibenchError


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument("what", choices=("world", "planner", "cases"))
    command.add_argument(
        "--model", default="gemma-3-270m", help="planner: a model on the shelf (%(default)s)"
    )
    command.add_argument("--threads", type=int, default=0, help="planner (default: as in `run`)")
    command.add_argument(
        "--steps", type=int, default=STEPS, help="planner: at most so many an episode (%(default)s)"
    )
    command.add_argument(
        "--records", type=int, default=50_000, help="cases: in the database (%(default)s)"
    )
    add_json(command)
    command.set_defaults(command=bench_command)


def bench_command(arguments: Namespace) -> int:
    """Time worlds, alone and over AI2-THOR's wires, or a planner beside the published way."""
    result: dict[str, Any]
    if arguments.what == "world":
        result, show = bench_world(), _world_lines
    elif arguments.what == "cases":
        result, show = _bench_cases(arguments.records), _cases_lines
    else:
        result = bench_planner(arguments.model, threads=arguments.threads, steps=arguments.steps)
        show = planner_lines
    for line in [json.dumps(result)] if arguments.json else show(result):
        say(line)
    return 0


def _bench_cases(records: int) -> dict[str, Any]:
    from reibench.bench.cases import bench_cases  # the web server takes a second to import

    if records < 1:
        raise ReibenchError(f"--records {records} fills no database; ask for at least 1.")
    return bench_cases(records)


def _cases_lines(result: dict[str, Any]) -> list[str]:
    return [table(list(result.items()), ["measured", "value"])]


def _world_lines(result: dict[str, Any]) -> list[str]:
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


def planner_lines(result: dict[str, Any]) -> list[str]:
    """Return what was measured of a planner in sentences."""
    theirs = (
        f"guidance.select, evaluating each prompt anew, {result['guidance_seconds_per_step']:.2f} s"
        f" ({result['ratio']} times as long), and with a state mended to keep the examples"
        f" {result['guidance_mended_seconds_per_step']:.2f} s ({result['ratio_mended']} times);"
        f" {result['guidance']}."
        if result["ratio"]
        else result["guidance"]
    )
    return [
        f"SayCan with {result['model']} on {result['machine']['threads']} threads (load"
        f" {result['machine']['load_average'][0]}), {result['steps_measured']} warm steps:",
        f"a warm step takes {result['warm_seconds_per_step']:.3f} s, one of the first episode"
        f" {result['first_episode_seconds_per_step']:.3f} s;",
        theirs,
        f"Of a step's tokens {result['tokens_new_per_step']} are new and"
        f" {result['tokens_evaluated_per_step']} are evaluated.",
        f"In a new process the model is open after {result['open_after_restart_seconds']:.1f} s,"
        f" and the first step takes {result['first_step_after_restart_seconds']:.2f} s.",
    ]
