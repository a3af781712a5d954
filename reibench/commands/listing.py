"""`list`: what there is of each kind."""

from argparse import ArgumentParser, Namespace
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import asdict
from typing import Any

from reibench.backends import backends
from reibench.commands.options import add_episodes, add_json, chosen_episodes
from reibench.commands.output import say, say_json, table
from reibench.dialogue import LEVELS
from reibench.episode import Episode, TaskType
from reibench.household import Room, load_room, room_names
from reibench.methods import methods
from reibench.models.presets import known
from reibench.planners import planners
from reibench.skill import DONE, SKILLS
from reibench.worlds import worlds
from reibench.worlds.rules import RULES

NAMES: dict[str, Callable[[], Iterable[str]]] = {
    "levels": lambda: map(str, LEVELS),
    "tasks": lambda: (task_type.short for task_type in TaskType),
    "rooms": room_names,
    "skills": lambda: [*(skill.text for skill in SKILLS), DONE],
    "planners": planners.names,
    "methods": methods.names,
    "backends": backends.names,
    "worlds": worlds.names,
    "rules": lambda: RULES,
}


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument("kind", choices=("episodes", "models", *NAMES))
    add_episodes(command)
    add_json(command)
    command.set_defaults(command=list_command)


def list_command(arguments: Namespace) -> int:
    """Print what there is of one kind."""
    kind = arguments.kind
    if kind == "rooms":
        return _list_rooms(arguments)
    if kind == "episodes":
        return _print_list(arguments, [_episode_row(each) for each in chosen_episodes(arguments)])
    if kind == "models":
        return _print_list(arguments, [asdict(model) for model in known()])
    return _print_list(arguments, [{kind.removesuffix("s"): name} for name in NAMES[kind]()])


def _print_list(arguments: Namespace, rows: list[dict[str, Any]]) -> int:
    if arguments.json:
        say_json(rows)
    elif rows and len(rows[0]) > 1:
        say(table([list(row.values()) for row in rows], list(rows[0])))
    else:
        say("\n".join(str(next(iter(row.values()))) for row in rows))
    return 0


def _list_rooms(arguments: Namespace) -> int:
    """Print the rooms; as JSON with how many objects of each type they have."""
    rows = [_room_row(load_room(name)) for name in room_names()]
    if not arguments.json:
        rows = [{**row, "objects": sum(row["objects"].values())} for row in rows]
    return _print_list(arguments, rows)


def _room_row(room: Room) -> dict[str, Any]:
    counts = Counter(thing.type for thing in room.objects)
    return {
        "room": room.name,
        "kind": room.kind,
        "area": round(room.bounds.size.x * room.bounds.size.z, 1),
        "objects": dict(sorted(counts.items())),
    }


def _episode_row(episode: Episode) -> dict[str, Any]:
    goal = episode.task.goal
    return {
        "episode": episode.id,
        "type": goal.task_type.short,
        "room": episode.task.setup.room,
        "object": goal.object,
        "destination": goal.destination,
        "instruction": episode.dialogue.instruction.text,
    }
