"""`import ithor`: real rooms, from dumps of their object metadata."""

from argparse import ArgumentParser, Namespace
from collections import Counter
from pathlib import Path

from reibench.commands.options import add_json
from reibench.commands.output import say, say_json, tell
from reibench.errors import InvalidRoom, ReibenchError
from reibench.household.ithor import read_dump
from reibench.household.rooms import ROOMS, Room, imported_rooms, save_room

PURPOSE = "real AI2-THOR rooms, from dumps of their object metadata (see `dump`)"


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument("folder", type=Path, metavar="DIR", help="where the dumps (.json) are")
    add_json(command)
    command.set_defaults(command=import_command)


def import_command(arguments: Namespace) -> int:
    """Read every dump of a folder into a room; exit 1 if one could not be read."""
    paths = sorted(arguments.folder.glob("*.json"))
    if not paths:
        raise ReibenchError(f"There are no dumps (.json) in {arguments.folder}.")
    folder = imported_rooms()
    folder.mkdir(parents=True, exist_ok=True)
    rooms, refused = [], []
    for path in paths:
        try:
            room = _read(path)
        except InvalidRoom as problem:
            refused.append(str(problem))
            continue
        save_room(room, folder / f"{room.name}.json")
        rooms.append(room)
    _report(arguments, rooms, refused)
    return 1 if refused else 0


def _read(path: Path) -> Room:
    room = read_dump(path)
    if (ROOMS / f"{room.name}.json").is_file():
        raise InvalidRoom(f"{path}: {room.name} is the name of a room that comes along.")
    return room


def _report(arguments: Namespace, rooms: list[Room], refused: list[str]) -> None:
    kinds = Counter(room.kind for room in rooms)
    objects = sum(len(room.objects) for room in rooms)
    if arguments.json:
        say_json({"rooms": len(rooms), "kinds": kinds, "objects": objects, "refused": refused})
        return
    for problem in refused:
        tell(problem)
    listed = ", ".join(f"{count} {kind}s" for kind, count in kinds.items())
    say(f"{len(rooms)} rooms ({listed}) with {objects} objects are in {imported_rooms()}.")
    if refused:
        say(f"{len(refused)} of {len(refused) + len(rooms)} files could not be read.")
