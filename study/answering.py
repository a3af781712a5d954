"""Answers: whether they fit their questions, and keeping them."""

from collections.abc import Mapping, Sequence
from typing import Any

from sqlite_utils import Database

from reibench.errors import ReibenchError
from reibench.household.objects import object_types
from reibench.store.schema import now
from study.config import Question

Answers = Mapping[str, Any]
LONGEST = 2000
"""Characters of a free answer that are kept."""


def checked(asked: Sequence[Question], answers: Answers) -> dict[str, str]:
    """Return the answer to each question as text; raises ReibenchError if one does not fit."""
    given: dict[str, str] = {}
    for question in asked:
        answer = answers.get(question.name)
        text = answer.strip() if isinstance(answer, str) else ""
        if not text:
            if not question.optional:
                raise ReibenchError(f"Please answer: {question.text}")
            continue
        if not _fits(question, text):
            raise ReibenchError(f"{text[:60]!r} is no answer to: {question.text}")
        given[question.name] = text[:LONGEST]
    return given


def _fits(question: Question, text: str) -> bool:
    if question.kind == "choice":
        return text in question.options
    if question.kind == "scale":
        return text in {str(point) for point in range(1, question.points + 1)}
    if question.kind == "object":
        return text in object_types()
    return True


def wrong_answers(asked: Sequence[Question], given: Mapping[str, str]) -> tuple[Question, ...]:
    """Return the questions with a right answer that were given another."""
    return tuple(one for one in asked if one.right and given.get(one.name) != one.right)


def keep_answers(
    database: Database,
    participant: str,
    stage: str,
    place: int,
    attempt: int,
    asked: Sequence[Question],
    given: Mapping[str, str],
) -> None:
    """Keep answers, and whether they are right where a question says what is."""
    right_of = {question.name: question.right for question in asked}
    for name, answer in given.items():
        right = answer == right_of[name] if right_of[name] else None
        number = attempt if stage == "quiz" else 1
        database.execute(
            "insert into answers values (?, ?, ?, ?, ?, ?, ?, ?)",
            [
                participant,
                stage,
                place,
                name,
                number,
                answer,
                right,
                now(),
            ],
        )
