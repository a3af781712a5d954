"""`compare-rooms`: the rooms that come with the project beside AI2-THOR's real ones."""

from argparse import ArgumentParser, Namespace
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path

from reibench.commands.output import say, say_json, table, tell
from reibench.errors import InvalidRoom
from reibench.household import load_room
from reibench.household.habits import TABLE, format_statistics, real_rooms
from reibench.household.ithor import read_dump
from reibench.household.likeness import likeness, room_rows
from reibench.household.objects import ROOM_KINDS
from reibench.household.plans import PLANS
from reibench.household.rooms import Room
from reibench.household.statistics import KindStatistics, measure, to_json
from reibench.view.rooms_table import rooms_document

Statistics = Mapping[str, KindStatistics]


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument(
        "--real", metavar="DIR", help="dumps of real rooms to measure (default: as measured once)"
    )
    command.add_argument(
        "--save", action="store_true", help="keep what was measured as what rooms are made from"
    )
    form = command.add_mutually_exclusive_group()
    form.add_argument("--json", action="store_true", help="print all statistics as JSON")
    form.add_argument("--markdown", action="store_true", help="print the tables of docs/rooms.md")
    command.set_defaults(command=compare_command)


def compare_command(arguments: Namespace) -> int:
    """Print how alike the rooms are; measure the real ones anew if there are any."""
    real = measure_dumps(Path(arguments.real)) if arguments.real else real_rooms()
    if arguments.save:
        TABLE.write_text(format_statistics(real), encoding="utf-8")
        tell(f"Saved to {TABLE.name}; python -m reibench.household.generate makes the rooms anew.")
        return 0
    made = measure_shipped()
    if arguments.markdown:
        say(rooms_document(made, real).rstrip())
    elif arguments.json:
        say_json({kind: _described(made[kind], real[kind]) for kind in ROOM_KINDS})
    else:
        rows = [
            [kind, row.name, row.first, row.second]
            for kind in ROOM_KINDS
            for row in room_rows((made[kind], real[kind]))
        ]
        say(table(rows, ["kind", "quantity", "made", "real"]))
    return 0


def measure_shipped() -> Statistics:
    """Return the statistics of the rooms that come with the project."""
    return _measure([load_room(name) for name in PLANS])


def measure_dumps(folder: Path) -> Statistics:
    """Return the statistics of a folder of dumps; raises InvalidRoom if some kind has none."""
    measured = _measure([read_dump(path) for path in sorted(folder.glob("*.json"))])
    if lacking := [kind for kind in ROOM_KINDS if kind not in measured]:
        raise InvalidRoom(
            f"The folder {folder} has no dump of any {lacking[0]}; it should have some of each"
            " kind, named like FloorPlan1_physics.json."
        )
    return measured


def _measure(rooms: list[Room]) -> dict[str, KindStatistics]:
    by_kind = {kind: [each.objects for each in rooms if each.kind == kind] for kind in ROOM_KINDS}
    return {kind: measure(found) for kind, found in by_kind.items() if found}


def _described(made: KindStatistics, real: KindStatistics) -> dict[str, object]:
    return {
        "likeness": asdict(likeness((made, real))),
        "made": to_json(made),
        "real": to_json(real),
    }
