"""`build-dataset --realise`: plain dialogues without end, for training."""

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from itertools import islice

from reibench.commands.checking import unsolved
from reibench.commands.output import tell
from reibench.dataset.files import stream_episodes
from reibench.dataset.levels import derive
from reibench.dataset.lexicon import Lexicon, held_out
from reibench.dataset.realise.compose import Realiser
from reibench.dataset.realise.tasks import tasks
from reibench.dialogue import LEVELS, Dialogue, Utterance, Vagueness
from reibench.episode import Episode, Task
from reibench.errors import InvalidEpisode, ReibenchError
from reibench.household import load_room, room_names

UNSAID = Dialogue((Utterance("human", ""),))
"""What the expert is told: nothing, since it knows the goal."""


def add(command: ArgumentParser) -> None:
    """Add the options of the realiser."""
    group = command.add_argument_group("the realiser, for training material (marked `realised`)")
    group.add_argument("--realise", type=int, metavar="N", help="make N scripts")
    group.add_argument("--levels", help="only these levels, comma-separated (default: all nine)")
    group.add_argument("--rooms", help="only these rooms, comma-separated (default: all)")
    group.add_argument(
        "--exclude-lexicon",
        type=float,
        default=0.0,
        metavar="FRACTION",
        help="hold out this part of each type's expressions; which, --seed decides",
    )


def build(arguments: Namespace) -> int:
    """Write realised episodes as they are made."""
    if arguments.realise < 1:
        raise ReibenchError(f"--realise {arguments.realise} makes no script; ask for at least 1.")
    levels = wanted_levels(arguments.levels)
    count = stream_episodes(arguments.out, _episodes(arguments, levels))
    tell(f"{arguments.out}: {count} episodes from {arguments.realise} realised scripts")
    return 0


def wanted_levels(text: str | None) -> tuple[Vagueness, ...]:
    """Return the levels that `--levels` asks for; raises UnknownName."""
    if text is None:
        return LEVELS
    return tuple(Vagueness.parse(name.strip()) for name in text.split(","))


def solvable(task: Task) -> bool:
    """Whether the expert solves `task`, in a room where it can stand at all."""
    try:
        return not unsolved(Episode(task, UNSAID, LEVELS[0]))
    except InvalidEpisode:
        return False


def kept_lexicon(arguments: Namespace) -> Lexicon:
    """Return the lexicon without what `--exclude-lexicon` holds out."""
    return held_out(arguments.exclude_lexicon, arguments.seed)[0]


def _episodes(arguments: Namespace, levels: tuple[Vagueness, ...]) -> Iterator[Episode]:
    realiser = Realiser(kept_lexicon(arguments))
    names = arguments.rooms.split(",") if arguments.rooms else room_names()
    rooms = [load_room(name.strip()) for name in names]
    for seed in islice(tasks(rooms, arguments.seed, solvable), arguments.realise):
        script = realiser.realise(seed.task, seed.present, seed.task.id)
        yield from derive(script, levels)
