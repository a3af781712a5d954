"""The tables that set made-up rooms beside real ones, as a Markdown document."""

from collections.abc import Iterable, Mapping

from reibench.household.likeness import (
    Likeness,
    Row,
    content_rows,
    likeness,
    room_rows,
    size_rows,
    state_rows,
    type_rows,
)
from reibench.household.statistics import KindStatistics

COMMAND = "python -m reibench compare-rooms --markdown"
HEAD = f"""\
# Made-up rooms beside real ones

Made by `{COMMAND}`. *Made* are the 120 rooms that come with this
project, *real* those 116 of AI2-THOR's 120 iTHOR rooms whose object metadata was at hand. Of the
real rooms the project keeps these numbers and no room.

Numbers over the rooms of a kind are least / middle / most. An area is that of the rectangle round
everything but windows, curtains, pictures, mirrors and the floor itself; free is the share of it
nothing stands on. Boxes are parallel to the axes, and so what goes round a corner has a larger one
than it takes up: of the real kitchens' 68 counter tops 18 are boxed over 1.3 m deep, and in
bathrooms 5 of 12 shower panes and 9 of 29 toilets over 0.85 m; made-up ones stand straight, in
pieces. Most of why real kitchens and bathrooms seem to have less free floor is that.
"""
SECTIONS = (
    ("Rooms", "quantity", room_rows),
    ("How many rooms have it, and how many a room has", "type", type_rows),
    ("How much lies there, and what most often", "receptacle", content_rows),
    ("Length × depth × height in cm, the middle ones", "type", size_rows),
    ("States", "type and state", state_rows),
)


def rooms_document(made: Mapping[str, KindStatistics], real: Mapping[str, KindStatistics]) -> str:
    """Return a Markdown document: how alike the rooms are, and a table for each question."""
    pairs = {kind: (made[kind], real[kind]) for kind in made}
    parts = [HEAD, "## How alike\n", _summary({kind: likeness(p) for kind, p in pairs.items()})]
    for kind, pair in pairs.items():
        parts.append(f"## {kind.capitalize()}: {pair[0].rooms} made, {pair[1].rooms} real\n")
        for title, of, rows in SECTIONS:
            parts += [f"### {title}\n", _table(of, rows(pair))]
    return "\n".join(parts)


def _summary(found: Mapping[str, Likeness]) -> str:
    lines = [
        "| kind | objects, made and real | m², made and real | free floor | share of rooms with"
        " each type: r | number of each type: r | same places | contents of each receptacle: r |",
        "|---" * 8 + "|",
    ]
    for kind, each in found.items():
        pairs = [
            f"{each.objects[0]:.1f}, {each.objects[1]:.1f}",
            f"{each.area[0]:.1f}, {each.area[1]:.1f}",
            f"{each.free[0]:.0%}, {each.free[1]:.0%}",
        ]
        rates = [f"{each.shares:.3f}", f"{each.counts:.3f}"]
        rates += [f"{each.places:.0%}", f"{each.contents:.3f}"]
        lines.append(f"| {kind} | {' | '.join(pairs + rates)} |")
    return "\n".join(lines) + "\n"


def _table(of: str, rows: Iterable[Row]) -> str:
    lines = [f"| {of} | made | real |", "|---|---|---|"]
    lines += [f"| {row.name} | {row.first} | {row.second} |" for row in rows]
    return "\n".join(lines) + "\n"
