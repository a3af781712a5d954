"""The rooms adapters are taught in: made up for it, and none of those that are shipped."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from reibench.errors import InvalidRoom
from reibench.household import Room
from reibench.household.generate import generate_home
from reibench.household.objects import ROOM_KINDS
from reibench.household.plans import PLANS
from reibench.household.rooms import save_room

FIRST = 1_000_000
"""The least seed of a training room; those of shipped rooms are far below."""
HELD_OUT = 2_000_000
"""The least seed of a room that nothing is taught in and results are measured in."""


@contextmanager
def made_up(number: int, first: int = FIRST) -> Iterator[Sequence[Room]]:
    """Make `number` rooms of each kind; they are gone when this ends.

    Their names are the paths of their files, so that any world can load them.
    """
    assert all(plan.seed < FIRST for plan in PLANS.values())
    with TemporaryDirectory(prefix="reibench-rooms-") as folder:
        rooms: list[Room] = []
        for kind in ROOM_KINDS:
            seed = first
            while len([room for room in rooms if room.kind == kind]) < number:
                name = Path(folder) / f"{kind.replace(' ', '-')}-{seed}.json"
                seed += 1
                try:
                    room = generate_home(kind, seed, name=str(name))
                except InvalidRoom:
                    continue
                save_room(room, name)
                rooms.append(room)
        yield rooms
