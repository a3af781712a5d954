"""The official REI-Bench split: `rei_bench.json`, read as its own loader's code implies.

Each entry names an ALFRED trial and holds nine dialogues, `memory1-1` (explicit, standard) to
`memory3-3` (implicit, short), each a text of lines `Alice: …` and `Robot: …` whose last human line
is the pending instruction. An empty one falls back to the clear instruction `task_dec`.
"""

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from reibench.dataset.alfred import Trial
from reibench.dialogue import CONTEXTS, REFERENCES, Dialogue, Speaker, Utterance, Vagueness
from reibench.episode import Episode, Task
from reibench.errors import InvalidEpisode

SPLIT = "valid_seen"
"""The only one the official evaluation prepares."""
NEEDED = ("task", "repeat_idx", "task_dec")
SPEAKERS: Mapping[str, Speaker] = {"Alice": "human", "Human": "human", "Robot": "robot"}
MEMORIES = {
    f"memory{row}-{column}": Vagueness(reference, context)
    for row, reference in enumerate(REFERENCES, start=1)
    for column, context in enumerate(CONTEXTS, start=1)
}
"""The fields of the nine levels; an entry may have more fields, but none fewer."""


def read_rei_bench(path: Path, trials: Sequence[Trial]) -> list[Episode]:
    """Read the official split; trials about two objects are left out, as its evaluation does.

    Args:
        path: `rei_bench.json`.
        trials: the ALFRED trials its entries name.

    Raises:
        InvalidEpisode: naming the file and the entry, when something is missing or wrong.
    """
    by_id = {trial.id: trial for trial in trials}
    episodes: list[Episode] = []
    for number, entry in enumerate(_entries(path), start=1):
        name = f"{path}, entry {number}"
        if not isinstance(entry, Mapping):
            raise InvalidEpisode(f"{name} is no JSON object, but {entry!r}.")
        if missing := next((key for key in (*NEEDED, *MEMORIES) if key not in entry), ""):
            raise InvalidEpisode(f"{name} ({entry.get('task', 'of no task')}) has no {missing!r}.")
        trial = by_id.get(str(entry["task"]).rstrip("/").rpartition("/")[2])
        if trial is None:
            raise InvalidEpisode(
                f"{name}: the trial {entry['task']} is not among the {len(trials)} ALFRED trials;"
                " --alfred must name the folder that holds it."
            )
        try:
            episodes += _episodes(entry, trial)
        except (TypeError, ValueError, AttributeError) as problem:
            raise InvalidEpisode(f"{name} ({entry['task']}) cannot be read: {problem}.") from None
    return episodes


def _entries(path: Path) -> Sequence[Any]:
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as problem:
        raise InvalidEpisode(f"{path} cannot be read: {problem}.") from None
    entries = content.get(SPLIT) if isinstance(content, Mapping) else None
    if not isinstance(entries, list) or not entries:
        raise InvalidEpisode(f"{path} has no list {SPLIT!r} with entries.")
    return entries


def _episodes(entry: Mapping[str, Any], trial: Trial) -> Iterator[Episode]:
    if trial.goal is None:
        return
    task = Task(f"{trial.id}-r{int(entry['repeat_idx'])}", trial.setup, trial.goal)
    for field, level in MEMORIES.items():
        yield Episode(task, dialogue_of(entry[field], entry["task_dec"]), level)


def dialogue_of(memory: str, clear: str) -> Dialogue:
    """Return the dialogue a memory field holds; `clear` is the instruction if it is empty.

    A line without a speaker goes on with what was said before it; the official loader loses it.
    """
    turns: list[Utterance] = []
    for line in filter(None, (line.strip() for line in memory.splitlines())):
        speaker, colon, words = line.partition(":")
        if colon and speaker in SPEAKERS:
            turns.append(Utterance(SPEAKERS[speaker], words.strip()))
        elif turns:
            turns[-1] = Utterance(turns[-1].speaker, f"{turns[-1].text} {line}")
        else:
            raise ValueError(f"the line {line[:60]!r} is said by nobody")
    while turns and turns[-1].speaker == "robot":
        turns.pop()  # the last human line is the pending instruction, whatever follows
    return Dialogue(tuple(turns or [Utterance("human", clear.strip())]))
