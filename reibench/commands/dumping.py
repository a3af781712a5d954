"""`dump`: object metadata of the rooms of a simulator, in files `import ithor` reads."""

import json
from argparse import ArgumentParser, Namespace
from fnmatch import fnmatchcase
from pathlib import Path

from reibench.commands.options import add_json, add_world, default_world
from reibench.commands.output import say, say_json, tell
from reibench.errors import InvalidRoom, ReibenchError, UnknownName, unknown
from reibench.household import room_names
from reibench.household.scenes import scene_name
from reibench.worlds.dumping import ITHOR, dump
from reibench.worlds.naming import create_world
from reibench.worlds.thor import ThorWorld


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument("folder", type=Path, metavar="DIR", help="where the files go")
    add_rooms(command, "all rooms here; of ai2thor, iTHOR's 120")
    add_world(command, default_world())
    add_json(command)
    command.set_defaults(command=dump_command)


def dump_command(arguments: Namespace) -> int:
    """Write a file for each room; exit 1 if one could not be had."""
    world = create_world(arguments.world, announce=tell)
    if not isinstance(world, ThorWorld):
        raise ReibenchError(f"The world {arguments.world!r} has no AI2-THOR metadata to dump.")
    known = ITHOR if arguments.world.startswith("ai2thor") else room_names()
    rooms = chosen_rooms(arguments.rooms, (*known, *room_names()) if arguments.rooms else known)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    refused = []
    try:
        for number, room in enumerate(rooms, start=1):
            try:
                content = dump(world.simulator, room)
            except (UnknownName, InvalidRoom) as problem:
                refused.append(f"{room}: {problem}")
                continue
            path = arguments.folder / f"{scene_name(room)}.json"
            path.write_text(json.dumps(content), encoding="utf-8")
            tell(f"[{number}/{len(rooms)}] {path.name}: {len(content) - 1} objects")
    finally:
        world.close()
    if arguments.json:
        say_json({"rooms": len(rooms) - len(refused), "refused": refused})
    else:
        say(f"{len(rooms) - len(refused)} of {len(rooms)} rooms are in {arguments.folder}.")
        for line in refused:
            tell(line)
    return 1 if refused else 0


def add_rooms(command: ArgumentParser, default: str) -> None:
    """Add the option that chooses rooms."""
    command.add_argument(
        "--rooms", default="", help=f"names or patterns with commas (default: {default})"
    )


def chosen_rooms(chosen: str, known: tuple[str, ...]) -> tuple[str, ...]:
    """Return the known rooms that are chosen, all if nothing is; raises UnknownName."""
    if not chosen:
        return known
    found: dict[str, None] = {}
    for pattern in chosen.split(","):
        names = [name for name in known if fnmatchcase(name, pattern.strip())]
        if not names:
            raise unknown("room", pattern.strip(), known, most=12)
        found |= dict.fromkeys(names)
    return tuple(found)
