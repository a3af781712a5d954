"""`view`: pages to look at, written to a file."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from reibench.commands.dumping import add_rooms, chosen_rooms
from reibench.commands.output import say
from reibench.household import Controller, load_room, room_names
from reibench.view.contact_sheet import Exhibit, contact_sheet


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    sub = command.add_subparsers(required=True, metavar="WHAT")
    purpose = "a contact sheet of all rooms, shipped and imported, as floor plans"
    rooms = sub.add_parser("rooms", help=purpose, description=purpose)
    rooms.add_argument("--out", type=Path, default=Path("rooms.html"), metavar="FILE")
    add_rooms(rooms, "all")
    rooms.set_defaults(command=rooms_command)


def rooms_command(arguments: Namespace) -> int:
    """Write one HTML file that stands alone."""
    names = chosen_rooms(arguments.rooms, room_names())
    rooms = [load_room(name) for name in names]
    sheet = contact_sheet([Exhibit(room.kind, Controller(room).snapshot()) for room in rooms])
    arguments.out.write_text(sheet, encoding="utf-8")
    say(f"{len(rooms)} rooms are in {arguments.out}.")
    return 0
