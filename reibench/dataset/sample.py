"""Choosing episodes: by level, task type, room, id, or a manifest file."""

import hashlib
import json
from collections.abc import Callable, Sequence
from pathlib import Path

from reibench.dataset.files import digest
from reibench.dialogue import CONTEXTS, EXPLICIT_ALONE, LEVELS, REFERENCES
from reibench.episode import Episode, TaskType
from reibench.errors import InvalidEpisode, unknown

Kind = Callable[[Episode], str]
SAMPLES = Path(__file__).parents[2] / "assets" / "samples"
"""The project's own manifests, which may be called by their names."""


def select(episodes: Sequence[Episode], wanted: str) -> list[Episode]:
    """Return the episodes that `--episodes` asks for, in their order.

    Args:
        episodes: all there are.
        wanted: `all`, a manifest (a file, or the name of a shipped one), or comma-separated levels,
            references, contexts, task types, rooms, tasks or episode ids; several of one kind are
            alternatives, kinds intersect.

    Raises:
        UnknownName: for a word that is none of these.
    """
    if wanted == "all":
        return list(episodes)
    if wanted.endswith(".json"):
        return _from_manifest(episodes, Path(wanted))
    if wanted in samples():
        return _from_manifest(episodes, SAMPLES / f"{wanted}.json")
    kinds: dict[str, tuple[Kind, set[str]]] = {}
    for word in filter(None, (part.strip() for part in wanted.split(","))):
        name, kind = _kind_of(episodes, word)
        kinds.setdefault(name, (kind, set()))[1].add(word)
    return [
        episode
        for episode in episodes
        if all(kind(episode) in words for kind, words in kinds.values())
    ]


def samples() -> list[str]:
    """Return the names of the shipped manifests."""
    return sorted(path.stem for path in SAMPLES.glob("*.json"))


def _kind_of(episodes: Sequence[Episode], word: str) -> tuple[str, Kind]:
    kinds: dict[str, tuple[set[str], Kind]] = {
        "level": ({*map(str, LEVELS), str(EXPLICIT_ALONE)}, lambda e: str(e.vagueness)),
        "reference": ({*REFERENCES}, lambda e: e.vagueness.reference),
        "context": ({*CONTEXTS, EXPLICIT_ALONE.context}, lambda e: e.vagueness.context),
        "type": ({t.short for t in TaskType}, lambda e: e.task.goal.task_type.short),
        "room": ({e.task.setup.room for e in episodes}, lambda e: e.task.setup.room),
        "task": ({e.task.id for e in episodes}, lambda e: e.task.id),
        "episode": ({e.id for e in episodes}, lambda e: e.id),
    }
    for name, (words, kind) in kinds.items():
        if word in words:
            return name, kind
    named = (word for words, _ in kinds.values() for word in sorted(words))
    known = [*named, "all", *samples(), "FILE.json"]
    raise unknown("episode, level, task type, room or task", word, known)


def manifest(episodes: Sequence[Episode], **about: object) -> str:
    """Return a manifest as its file holds it: the episodes with their digests, and a hash of all.

    `about` says how they were chosen; it stands in the file and in the hash.
    """
    content = {**about, "episodes": {episode.id: digest(episode) for episode in episodes}}
    text = json.dumps(content, sort_keys=True, ensure_ascii=False)
    sha = hashlib.sha256(text.encode()).hexdigest()
    return json.dumps({"sha256": sha, **content}, ensure_ascii=False, indent=1) + "\n"


def _from_manifest(episodes: Sequence[Episode], path: Path) -> list[Episode]:
    """Return what a manifest lists, refusing episodes that are no longer what it froze."""
    by_id = {episode.id: episode for episode in episodes}
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
        listed = content["episodes"].items()
        stated = content.pop("sha256", "")
    except (OSError, ValueError, KeyError, AttributeError, TypeError) as problem:
        raise InvalidEpisode(f"The manifest {path} cannot be read: {problem}.") from problem
    text = json.dumps(content, sort_keys=True, ensure_ascii=False)
    if stated and hashlib.sha256(text.encode()).hexdigest() != stated:
        raise InvalidEpisode(f"The manifest {path} was changed after it was made.")
    for episode_id, frozen in listed:
        if episode_id not in by_id:
            raise unknown("episode", episode_id, by_id)
        if digest(by_id[episode_id]) != frozen:
            raise InvalidEpisode(f"{episode_id} has changed since the manifest {path} was made.")
    return [by_id[episode_id] for episode_id, _ in listed]
