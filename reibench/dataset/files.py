"""Episode files: one JSON object a line, one line an episode."""

import hashlib
import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from reibench.dialogue import Dialogue, ReferringExpression, Utterance, Vagueness
from reibench.episode import (
    Episode,
    Goal,
    ObjectPose,
    Placement,
    SceneSetup,
    Task,
    TaskType,
    Toggle,
)
from reibench.errors import InvalidEpisode, ReibenchError
from reibench.scene import Pose, Vector

SHIPPED = Path(__file__).parents[2] / "assets" / "episodes"
"""Where the project's own episodes are."""


def episode_to_json(episode: Episode) -> dict[str, Any]:
    """Return `episode` as the object an episode file holds."""
    goal, setup = episode.task.goal, episode.task.setup
    return {
        "id": episode.id,
        "task": episode.task.id,
        "level": str(episode.vagueness),
        "goal": {
            "type": str(goal.task_type),
            "object": goal.object,
            "movable_receptacle": goal.movable_receptacle,
            "destination": goal.destination,
            "sliced": goal.sliced,
        },
        "setup": _setup_to_json(setup),
        "candidates": list(episode.candidates),
        "underdetermined": episode.underdetermined,
        "dialogue": [_utterance_to_json(each) for each in episode.dialogue.utterances],
    }


def _setup_to_json(setup: SceneSetup) -> dict[str, Any]:
    """Say only what is set of what came later, so that older episodes keep their digest."""
    entry: dict[str, Any] = {
        "room": setup.room,
        "seed": setup.seed,
        "placements": [[p.object_id, p.receptacle_id] for p in setup.placements],
        "dirty": list(setup.dirty),
    }
    if setup.poses:
        entry["poses"] = [[each.type, *each.position, *each.rotation] for each in setup.poses]
    if setup.toggles:
        entry["toggles"] = [[each.type, each.on] for each in setup.toggles]
    if setup.dirty_and_empty:
        entry["dirty_and_empty"] = True
    if start := setup.start:
        entry["start"] = [*start.position, start.yaw, start.horizon]
    return entry


def _utterance_to_json(utterance: Utterance) -> dict[str, Any]:
    return {
        "speaker": utterance.speaker,
        "text": utterance.text,
        "expressions": [
            [e.start, e.end, e.referent, e.form, "explicit" if e.explicit else "implicit"]
            for e in utterance.expressions
        ],
    }


def episode_from_json(value: Mapping[str, Any]) -> Episode:
    """Read one episode; raises InvalidEpisode naming what is missing or wrong."""
    name = value.get("id", "without an id")
    try:
        goal, setup = value["goal"], value["setup"]
        task = Task(
            id=value["task"],
            setup=_setup_from_json(setup),
            goal=Goal(
                task_type=TaskType(goal["type"]),
                object=goal["object"],
                destination=goal["destination"],
                movable_receptacle=goal["movable_receptacle"],
                sliced=bool(goal["sliced"]),
            ),
        )
        episode = Episode(
            task=task,
            dialogue=Dialogue(tuple(_utterance_from_json(each) for each in value["dialogue"])),
            vagueness=Vagueness.parse(value["level"]),
            candidates=tuple(value["candidates"]),
            underdetermined=bool(value["underdetermined"]),
        )
    except KeyError as missing:
        raise InvalidEpisode(f"Episode {name} has no {missing}.") from missing
    except (TypeError, ValueError, AttributeError, ReibenchError) as problem:
        raise InvalidEpisode(f"Episode {name} cannot be read: {problem}.") from problem
    if value.get("id") != episode.id:
        raise InvalidEpisode(f"Episode {name} should be called {episode.id} (task.level).")
    return episode


def _setup_from_json(value: Mapping[str, Any]) -> SceneSetup:
    start = value.get("start")
    return SceneSetup(
        room=value["room"],
        seed=int(value["seed"]),
        placements=tuple(Placement(*pair) for pair in value["placements"]),
        dirty=tuple(value["dirty"]),
        poses=tuple(_pose_from_json(*each) for each in value.get("poses", ())),
        toggles=tuple(Toggle(kind, bool(on)) for kind, on in value.get("toggles", ())),
        dirty_and_empty=bool(value.get("dirty_and_empty", False)),
        start=None if start is None else _start_from_json(*map(float, start)),
    )


def _pose_from_json(kind: str, *numbers: float) -> ObjectPose:
    x, y, z, *rotation = map(float, numbers)
    return ObjectPose(kind, Vector(x, y, z), Vector(*rotation))


def _start_from_json(x: float, y: float, z: float, yaw: float, horizon: float) -> Pose:
    return Pose(Vector(x, y, z), yaw, horizon)


def _utterance_from_json(value: Mapping[str, Any]) -> Utterance:
    text = value["text"]
    expressions = tuple(
        ReferringExpression(start, end, text[start:end], referent, form, mark == "explicit")
        for start, end, referent, form, mark in value["expressions"]
    )
    return Utterance(value["speaker"], text, expressions)


def read_episodes(path: Path) -> list[Episode]:
    """Read an episode file.

    Raises:
        InvalidEpisode: with file and line, when a line is not a sound episode.
    """
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as problem:
        raise InvalidEpisode(f"The episode file {path} cannot be read: {problem}.") from problem
    episodes: dict[str, Episode] = {}
    for number, line in enumerate(lines, start=1):
        if not line.strip():
            continue
        try:
            episode = episode_from_json(json.loads(line))
        except json.JSONDecodeError as problem:
            raise InvalidEpisode(f"{path}, line {number} is no JSON: {problem}.") from problem
        except InvalidEpisode as problem:
            raise InvalidEpisode(f"{path}, line {number}: {problem}") from problem
        if episode.id in episodes:
            raise InvalidEpisode(f"{path}, line {number}: {episode.id} is there twice.")
        episodes[episode.id] = episode
    if not episodes:
        raise InvalidEpisode(f"The episode file {path} holds no episode.")
    return list(episodes.values())


def write_episodes(path: Path, episodes: Iterable[Episode]) -> None:
    """Write an episode file."""
    lines = [json.dumps(episode_to_json(each), ensure_ascii=False) for each in episodes]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def digest(episode: Episode) -> str:
    """Return 16 hex digits that change when anything about the episode does."""
    text = json.dumps(episode_to_json(episode), sort_keys=True, ensure_ascii=False)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def shipped_episodes() -> list[Episode]:
    """Return the project's own episodes."""
    return [each for path in sorted(SHIPPED.glob("*.jsonl")) for each in read_episodes(path)]
