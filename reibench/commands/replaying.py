"""`replay`: play records again, and verify that they come out the same."""

from argparse import ArgumentParser, Namespace
from contextlib import closing
from dataclasses import asdict

from reibench.commands.options import add_database, add_json, add_world, existing_database
from reibench.commands.output import say, say_json, tell
from reibench.replay import Replay, replay
from reibench.rollout import Record
from reibench.run import RunSpec, make_world
from reibench.store import Entry, Store


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument("record", nargs="?", default="all", help="a record's id, or all")
    command.add_argument("--verify", action="store_true", help="exit 1 if anything differs")
    add_world(command, "", without="the world each record was made in")
    add_database(command)
    add_json(command)
    command.set_defaults(command=replay_command)


def replay_command(arguments: Namespace) -> int:
    """Replay records; with --verify, exit 1 if anything came out otherwise."""
    store = Store(existing_database(arguments))
    if arguments.record == "all":
        entries = store.entries()
    else:
        store.episode_of(arguments.record)
        entries = store.entries("id = ?", [arguments.record])
    replays = [_replay(store, entry, arguments) for entry in entries]
    differing = [result for result in replays if result.differences]
    if arguments.json:
        say_json([asdict(result) for result in replays])
    else:
        steps = sum(result.steps for result in replays)
        say(
            f"{len(replays)} records, {steps} steps replayed:"
            f" {len(replays) - len(differing)} came out the same, {len(differing)} did not."
        )
    return 1 if arguments.verify and differing else 0


def _replay(store: Store, entry: Entry, arguments: Namespace) -> Replay:
    record = store.record(entry.id)
    spec = RunSpec(rules=entry.rules, world=arguments.world or entry.world)
    with closing(make_world(spec, announce=tell)) as world:
        result = replay(record, world)
    if arguments.record != "all" and not arguments.json:
        _print_steps(record)
    for difference in result.differences:
        tell(f"{entry.id} {result.episode}, {difference}")
    return result


def _print_steps(record: Record) -> None:
    say(f"{record.episode.id}, {record.actor}: {record.episode.dialogue.instruction.text}")
    if record.instruction and record.instruction.rewritten:
        say(f"restated: {record.instruction.text}")
    for step in record.steps:
        outcome = "" if step.event.success else f"  ✗ {step.event.message}"
        say(f"{step.number:3}  {step.decision.skill.text}{outcome}")
    say(f"{record.status}{f': {record.error}' if record.error else ''}")
