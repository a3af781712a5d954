"""Studies as data: a TOML file, read once, checked, and kept word for word in the database."""

import json
import tomllib
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, fields
from functools import lru_cache
from itertools import zip_longest
from pathlib import Path
from random import Random
from typing import Any, Literal, get_args

from reibench.dataset.files import shipped_episodes
from reibench.dataset.sample import select
from reibench.episode import Episode
from reibench.errors import ReibenchError, unknown
from reibench.rollout import MAX_STEPS
from reibench.worlds.rules import rules_called
from study.designs import designs
from study.texts import fingerprint, read_text

Shows = Literal["text", "text and room"]
Kind = Literal["choice", "scale", "text", "object"]
Ending = Literal["completed", "no_consent", "failed_check", "withdrawn"]
MOST_POINTS = 11
"""Of a scale: more do not fit on a phone."""
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
    return _build(json.loads(text))


def read_study(path: Path) -> Study:
    """Read a study's file and the texts it names.

    Raises:
        ReibenchError: saying what is wrong and what would be right.
    """
    try:
        entries = tomllib.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise ReibenchError(f"There is no study file {path}.") from None
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as problem:
        raise ReibenchError(f"The study {path} cannot be read as TOML: {problem}.") from None
    names = {"consent": "consent.md", "tutorial": "tutorial.md", "debrief": "debrief.md"}
    names |= entries.get("texts", {})
    if odd := set(names) - {"consent", "tutorial", "debrief"}:
        raise unknown("text of a study", min(odd), ("consent", "tutorial", "debrief"))
    entries["texts"] = {what: read_text(name, path.parent) for what, name in names.items()}
    study = _build(entries)
    check(study)
    return study


def _build(entries: Mapping[str, Any]) -> Study:
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


def check(study: Study) -> None:
    """Refuse what cannot work; raises ReibenchError."""
    if not study.name or not study.name.replace("-", "").isalnum() or not study.name.isascii():
        raise ReibenchError(
            f"A study cannot be called {study.name!r}; its name is in links, so it should have"
            " letters, digits and hyphens only."
        )
    _check_kinds(study)
    _check_choice("design", study.design, designs.names())
    _check_choice("way to show", study.shows, get_args(Shows))
    rules_called(study.rules)
    for name, least in (
        ("trials", 1),
        ("max_steps", 1),
        ("quiz_tries", 1),
        ("people", 0),
        ("tasks", 0),
    ):
        value = getattr(study, name)
        if not isinstance(value, int) or value < least:
            raise ReibenchError(f"{name} = {value!r} should be a whole number from {least} up.")
    _check_endings(study)
    if study.submission and study.submission not in study.parameters:
        raise ReibenchError(
            f"submission = {study.submission!r} is none of the parameters that are kept; add it to"
            " parameters."
        )
    for question in (*study.quiz, *study.after_trial, *study.at_end):
        _check_question(question)
    for question in study.quiz:
        if question.right not in question.options:
            raise ReibenchError(
                f"The right answer to the quiz question {question.name!r} is none of its options."
            )
    for question in (*study.after_trial, *study.at_end):
        if question.right and question.kind == "choice" and question.right not in question.options:
            raise ReibenchError(
                f"The right answer to {question.name!r}, {question.right!r}, is none of its"
                " options, so nobody could give it."
            )
    _check_names(study)
    _check_episodes(study)


def _check_kinds(study: Study) -> None:
    """Refuse what is of another kind than it should be: "no" is not false, "5" is not 5."""
    for one in fields(Study):
        value, default = getattr(study, one.name), one.default
        if isinstance(default, bool):
            fits, kind = isinstance(value, bool), "true or false, without quotes"
        elif isinstance(default, int | float):
            fits = isinstance(value, int | float) and not isinstance(value, bool)
            kind = "a number, without quotes"
        elif one.name in ("name", "title") or isinstance(default, str):
            fits, kind = isinstance(value, str), "text in quotes"
        else:
            continue
        if not fits:
            raise ReibenchError(f"{one.name} = {value!r} should be {kind}.")
    if not isinstance(study.seed, int):
        raise ReibenchError(f"seed = {study.seed!r} should be a whole number.")
    if study.trial_minutes < 0:
        raise ReibenchError(f"trial_minutes = {study.trial_minutes:g} should be 0 (none) or more.")
    if study.recent_minutes < 1:
        raise ReibenchError(f"recent_minutes = {study.recent_minutes:g} should be 1 or more.")


def _check_endings(study: Study) -> None:
    for ending in (*study.codes, *study.links):
        _check_choice("ending", ending, ENDINGS)
    for ending, address in study.links.items():
        if not address.startswith(("https://", "http://")):
            raise ReibenchError(
                f"The link for {ending!r} is {address!r}; it should begin with https://."
            )
    codes = list(study.codes.values())
    if twice := {code for code in codes if codes.count(code) > 1}:
        raise ReibenchError(
            f"Two endings have the code {min(twice)!r}; it could not be told how a study ended."
        )


def _check_choice(what: str, value: str, known: Sequence[str]) -> None:
    if value not in known:
        raise unknown(what, value, known)


def _check_question(question: Question) -> None:
    _check_choice("kind of question", question.kind, get_args(Kind))
    least = {"choice": 2, "scale": 2}.get(question.kind, 0)
    if len(question.options) < least:
        raise ReibenchError(
            f"The question {question.name!r} has {len(question.options)} options; one of the kind"
            f" {question.kind!r} needs at least {least}."
        )
    if question.kind == "scale" and not 2 <= question.points <= MOST_POINTS:
        raise ReibenchError(
            f"The question {question.name!r} has {question.points} points; a scale should have 2"
            f" to {MOST_POINTS}."
        )


def _check_names(study: Study) -> None:
    for where in ("quiz", "after_trial", "at_end"):
        names = [question.name for question in getattr(study, where)]
        if twice := {name for name in names if names.count(name) > 1}:
            raise ReibenchError(f"Two questions in {where} are called {min(twice)!r}.")


def _check_episodes(study: Study) -> None:
    shipped = {episode.id for episode in all_episodes()}
    for name in study.practice:
        if name not in shipped:
            raise unknown("episode to practise", name, shipped)
    practised = [name.partition(".")[0] for name in study.practice]
    if twice := {task for task in practised if practised.count(task) > 1}:
        raise ReibenchError(
            f"Two practice tasks are of the seed task {min(twice)!r}; nobody meets the same one"
            " twice, so choose episodes of different tasks."
        )
    pool = study.chosen()
    designs.create(study.design).check(pool)
    tasks = {episode.task.id for episode in pool}
    if len(tasks) < study.tasks:
        raise ReibenchError(
            f"tasks = {study.tasks}, but {study.episodes!r} has {len(tasks)} that can be drawn;"
            " take 0 for every one."
        )
    if len(tasks) < study.trials:
        raise ReibenchError(
            f"{study.trials} trials need as many different tasks, but {study.episodes!r} has"
            f" {len(tasks)}; choose more episodes or fewer trials."
        )
