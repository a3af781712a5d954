"""Finding each script a room: where what it speaks of is, and its distractors too."""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from random import Random

from reibench.dataset.levels import said
from reibench.dataset.scripts import Script
from reibench.dialogue import Vagueness
from reibench.episode import SceneSetup, Task
from reibench.errors import InvalidEpisode
from reibench.household import Room

SHORT = Vagueness("implicit", "short")
MISSED = 1.0
"""What a distractor costs that the room lacks: a decoy, or a rival that the talk rules out."""
RIDDLE = 2.0
"""What a rival costs that would leave the request undecided at implicit-short."""
USED = 0.7
"""What it costs that another script is in the room already."""


def house(
    scripts: Sequence[Script],
    rooms: Sequence[Room],
    seed: int,
    solvable: Callable[[Task], bool],
    taken: Sequence[str] = (),
) -> list[Script]:
    """Give each script a room of the kind its `room` names, and say which rivals are there.

    Args:
        scripts: with a kind of room, e.g. `living-room`, in place of a room.
        rooms: where they may go; they are used evenly.
        seed: decides among equals.
        solvable: whether a task works out in its room.
        taken: names of rooms that other scripts have already, once for each.

    Raises:
        InvalidEpisode: when there is no room for a script.
    """
    choose = Random(seed)
    used = Counter(taken)
    housed = []
    for script in scripts:
        for room in sorted(_fitting(script, rooms), key=lambda r: _cost(script, r, used, choose)):
            setup = SceneSetup(room.name, script.setup.seed)
            if solvable(Task(script.id, setup, script.goal)):
                used[room.name] += 1
                housed.append(_settle(replace(script, setup=setup), types_of(room)))
                break
        else:
            raise InvalidEpisode(f"No room of kind {script.setup.room} takes {script.id}.")
    return housed


def types_of(room: Room) -> frozenset[str]:
    """Return the types of the room's objects."""
    return frozenset(thing.type for thing in room.objects)


def _fitting(script: Script, rooms: Sequence[Room]) -> Iterator[Room]:
    """Yield the rooms of the right kind that hold what the task needs."""
    goal = script.goal
    needed = {goal.object, goal.destination, *filter(None, [goal.movable_receptacle])}
    for room in rooms:
        if room.kind.replace(" ", "-") == script.setup.room and needed <= types_of(room):
            yield room


def _cost(script: Script, room: Room, used: Counter[str], choose: Random) -> float:
    present = types_of(room)
    left = set(_undecided(script))
    wanted = {script.decoy, *script.rivals} - left
    cost = MISSED * len(wanted - present) + RIDDLE * len(left & present)
    return cost + USED * used[room.name] + choose.random() / 2


def _undecided(script: Script) -> list[str]:
    """Return the rivals that nothing rules out once the short context has left its part out."""
    rivals = script.rivals.items()
    return [name for name, words in rivals if not (words and said(script, words, SHORT))]


def _settle(script: Script, present: frozenset[str]) -> Script:
    """Keep the rivals that are in the room, and say where they leave the request undecided."""
    rivals = {name: words for name, words in script.rivals.items() if name in present}
    kept = replace(script, rivals=rivals)
    left = _undecided(kept)
    candidates = {SHORT: (script.goal.object, *left)} if left else {}
    return replace(kept, candidates=candidates)
