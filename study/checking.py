"""Whether a study can work, said before anybody takes part."""

from collections.abc import Sequence
from dataclasses import fields
from typing import get_args

from reibench.errors import ReibenchError, unknown
from reibench.worlds.rules import rules_called
from study.config import ENDINGS, Kind, Question, Shows, Study, all_episodes
from study.designs import designs

TEXTS = ("name", "title", "text")
"""Settings without a default that are texts."""
MOST_POINTS = 11
"""Of a scale: more do not fit on a phone."""


def check(study: Study) -> None:
    """Refuse what cannot work; raises ReibenchError."""
    if not study.name or not study.name.replace("-", "").isalnum() or not study.name.isascii():
        raise ReibenchError(
            f"A study cannot be called {study.name!r}; its name is in links, so it should have"
            " letters, digits and hyphens only."
        )
    _check_kinds(study, "")
    _check_times(study)
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
    _check_right_answers(study)
    _check_names(study)
    _check_episodes(study)


def _check_kinds(entry: Study | Question, whose: str) -> None:
    """Refuse what is of another kind than it should be: "no" is not false, "5" is not 5."""
    for one in fields(entry):
        value, default = getattr(entry, one.name), one.default
        if isinstance(default, bool):
            fits, kind = isinstance(value, bool), "true or false, without quotes"
        elif isinstance(default, float):
            fits = isinstance(value, int | float) and not isinstance(value, bool)
            kind = "a number, without quotes"
        elif isinstance(default, int):
            fits = isinstance(value, int) and not isinstance(value, bool)
            kind = "a whole number, without quotes"
        elif one.name in TEXTS or isinstance(default, str):
            fits, kind = isinstance(value, str), "text in quotes"
        else:
            continue
        if not fits:
            raise ReibenchError(f"{one.name} = {value!r}{whose} should be {kind}.")


def _check_times(study: Study) -> None:
    if study.trial_minutes < 0:
        raise ReibenchError(f"trial_minutes = {study.trial_minutes:g} should be 0 (none) or more.")
    if study.recent_minutes < 1:
        raise ReibenchError(f"recent_minutes = {study.recent_minutes:g} should be 1 or more.")


def _check_endings(study: Study) -> None:
    for ending in (*study.codes, *study.links):
        _check_choice("ending", ending, ENDINGS)
    for name, value in (*study.codes.items(), *study.links.items()):
        if not isinstance(value, str):
            raise ReibenchError(f"{name} = {value!r} should be text in quotes.")
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
    _check_kinds(question, f" of the question {question.name!r}")
    if not all(isinstance(option, str) for option in question.options):
        raise ReibenchError(f"The options of the question {question.name!r} should be texts.")
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


def _check_right_answers(study: Study) -> None:
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
