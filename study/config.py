"""Studies as data: what a study is, kept word for word in the database."""

import json
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, fields
from functools import lru_cache
from itertools import zip_longest
from random import Random
from typing import Any, Literal, get_args

from reibench.dataset.files import shipped_episodes
from reibench.dataset.sample import select
from reibench.episode import Episode
from reibench.errors import ReibenchError, unknown
from reibench.rollout import MAX_STEPS
from study.texts import fingerprint

Shows = Literal["text", "text and room"]
Kind = Literal["choice", "scale", "text", "object"]
Ending = Literal["completed", "no_consent", "failed_check", "withdrawn"]
ENDINGS: tuple[Ending, ...] = get_args(Ending)


@dataclass(frozen=True)
class Question:
    """Something a participant is asked."""

    name: str
    """What its answers are called in the export."""
    text: str
    kind: Kind = "choice"
    options: tuple[str, ...] = ()
    """For `choice`; for `scale` the words at its two ends."""
    points: int = 5
    """Of a `scale`."""
    right: str = ""
    """The right option of a quiz question, or what an attention check asks for."""
    why: str = ""
    """What is said after a wrong answer in the quiz."""
    optional: bool = False


@dataclass(frozen=True)
class Study:
    """A study as its file says it, with the texts it names."""

    name: str
    """In links and on the command line: letters, digits and hyphens."""
    title: str
    episodes: str = "all"
    """As `--episodes` of `run`: a manifest, levels, task types, ids."""
    tasks: int = 36
    """How many seed tasks are drawn from them, over all types; 0 for every one."""
    trials: int = 9
    """For each participant."""
    people: int = 0
    """How many are planned; 0 for as many as come."""
    design: str = "latin-square"
    shows: Shows = "text and room"
    rules: str = "strict"
    max_steps: int = MAX_STEPS
    trial_minutes: float = 0.0
    """After which a trial ends by itself; 0 for no limit."""
    recent_minutes: float = 90.0
    """How long somebody who does nothing still counts as taking part."""
    reveal_success: bool = False
    """Whether people learn after each trial whether it was solved."""
    seed: int = 1
    practice: tuple[str, ...] = ()
    """Ids of episodes played first, with help; they are in no result."""
    quiz_tries: int = 2
    invited_only: bool = False
    """Whether a code is needed to take part."""
    parameters: tuple[str, ...] = ()
    """Which parameters of the link are kept, e.g. `PROLIFIC_PID`; all others are not."""
    submission: str = ""
    """Which of them is one sitting of one person, e.g. `SESSION_ID`."""
    texts: Mapping[str, str] = field(default_factory=dict)
    """`consent`, `tutorial` and `debrief`, in Markdown."""
    quiz: tuple[Question, ...] = ()
    after_trial: tuple[Question, ...] = ()
    at_end: tuple[Question, ...] = ()
    codes: Mapping[str, str] = field(default_factory=dict)
    """What people are given at the end, by how it ended."""
    links: Mapping[str, str] = field(default_factory=dict)
    """Where they are led then; `{code}` stands for the code."""

    @property
    def version(self) -> str:
        """Twelve hex digits; another for any change, texts included."""
        return fingerprint(self.to_json())

    def to_json(self) -> str:
        """Return everything as JSON, which `from_json` reads."""
        return json.dumps(asdict(self), sort_keys=True, ensure_ascii=False)

    def chosen(self) -> list[Episode]:
        """Return the episodes that trials are drawn from, without those practised."""
        practised = {name.partition(".")[0] for name in self.practice}
        by_task: dict[str, list[Episode]] = defaultdict(list)
        for episode in select(list(all_episodes()), self.episodes):
            if episode.task.id not in practised:
                by_task[episode.task.id].append(episode)
        whole = [
            task for task, found in by_task.items() if not any(e.underdetermined for e in found)
        ]
        drawn = _spread(whole, by_task, self.tasks or len(whole), self.seed)
        return [episode for task in drawn for episode in by_task[task]]


def _spread(
    tasks: Sequence[str], by_task: Mapping[str, Sequence[Episode]], number: int, seed: int
) -> list[str]:
    """Draw tasks so that types come in turn."""
    shuffled = list(tasks)
    Random(seed).shuffle(shuffled)
    by_type: dict[str, list[str]] = defaultdict(list)
    for task in shuffled:
        by_type[by_task[task][0].task.goal.task_type].append(task)
    turns = zip_longest(*(by_type[kind] for kind in sorted(by_type)))
    return [task for turn in turns for task in turn if task][:number]


@lru_cache(maxsize=1)
def all_episodes() -> tuple[Episode, ...]:
    """Return every shipped episode, read once."""
    return tuple(shipped_episodes())


def from_json(text: str) -> Study:
    """Return the study that `Study.to_json` wrote."""
    return from_entries(json.loads(text))


def from_entries(entries: Mapping[str, Any]) -> Study:
    """Return the study of settings by name, unchecked; raises ReibenchError for odd names."""
    known = {one.name: one for one in fields(Study)}
    for name in entries:
        if name not in known:
            raise unknown("setting of a study", name, known)
    values = dict(entries)
    for name in ("quiz", "after_trial", "at_end"):
        values[name] = tuple(_question(entry, name) for entry in values.get(name, ()))
    for name in ("practice", "parameters"):
        values[name] = tuple(values.get(name, ()))
    if missing := {"name", "title"} - set(values):
        raise ReibenchError(f"The study has no {min(missing)!r}; give it one.")
    return Study(**values)


def _question(entry: Mapping[str, Any], where: str) -> Question:
    known = [one.name for one in fields(Question)]
    for name in entry:
        if name not in known:
            raise unknown(f"setting of a question in {where}", name, known)
    if not entry.get("name") or not entry.get("text"):
        raise ReibenchError(f"A question in {where} lacks its name or its text: {dict(entry)}.")
    return Question(**{**entry, "options": tuple(entry.get("options", ()))})
