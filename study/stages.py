"""The stages of a study, what is on the page at each, and how somebody gets to the next."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, get_args

from sqlite_utils import Database

from reibench.errors import StaleStep
from reibench.store.schema import now
from reibench.watching import Sitting
from study.config import Ending, Question, Study
from study.enrolment import Participant, log

Stage = Literal[
    "consent", "tutorial", "practice", "quiz", "trial", "after", "outcome", "end", "over"
]
STAGES: tuple[Stage, ...] = get_args(Stage)
BEHIND = "This page was behind. It now shows where you are."
"""What somebody is told who clicked on what is not there any more."""


@dataclass(frozen=True)
class Page:
    """What a participant is to see now."""

    participant: Participant
    study: Study
    stage: Stage
    place: int = 0
    """Which practice task or trial, from 0."""
    sitting: Sitting | None = None
    """The episode being played; never shown whole, see `study.pages`."""
    questions: tuple[Question, ...] = ()
    wrong: tuple[Question, ...] = ()
    """Those of the quiz that were answered wrongly at the last try."""
    ending: Ending | None = None
    stopped: bool = False
    """Whether it is over because the whole study was stopped."""
    code: str = ""
    """To be given back to whoever sent the participant."""
    link: str = ""
    room: str = ""
    """Where the task was that questions are asked about."""
    request: str = ""
    """What was asked for in it."""
    spent: Literal["", "steps", "time"] = ""
    """What ended it, where that was not the participant."""
    solved: bool | None = None
    """Whether it was carried out; only where the study reveals it."""
    seconds_left: float | None = None
    """Of a trial with a time limit."""


def questions_at(study: Study, stage: Stage) -> tuple[Question, ...]:
    """Return what is asked at a stage."""
    asked = {"quiz": study.quiz, "after": study.after_trial, "end": study.at_end}
    return asked.get(stage, ())


def stage_of(who: Participant) -> Stage:
    """Return where somebody is; who was turned away is through."""
    if who.state == "rejected":
        return "over"
    return next(stage for stage in STAGES if stage == who.stage)


def ending_of(who: Participant) -> Ending | None:
    """Return how the study ended for somebody; nothing for who was turned away on the way."""
    known: Mapping[str, Ending] = {
        "no_consent": "no_consent", "failed_check": "failed_check", "withdrawn": "withdrawn",
        "finished": "completed",
    }  # fmt: skip
    # who was turned away after the end keeps the code of how it ended
    return known.get((who.before or "") if who.state == "rejected" else who.state)


def refuse_elsewhere(who: Participant, stage: Stage, place: int) -> None:
    """Raise StaleStep unless somebody is at that stage and place."""
    if who.state != "active" or who.stage != stage or who.place != place:
        raise StaleStep(BEHIND)


def see(database: Database, who: Participant) -> None:
    """Note that somebody has just done something, which keeps their place for them."""
    database.execute("update participants set seen = ? where code = ?", [now(), who.code])


def go(database: Database, who: Participant, stage: Stage, place: int = 0) -> None:
    """Let somebody go on to a stage."""
    database.execute(
        "update participants set stage = ?, place = ?, seen = ? where code = ?",
        [stage, place, now(), who.code],
    )


def end(database: Database, who: Participant, ending: Ending) -> None:
    """Let somebody be through, and note how."""
    state = "finished" if ending == "completed" else ending
    database.execute(
        "update participants set stage = 'over', place = 0, state = ?, seen = ?, ended = ?"
        " where code = ?",
        [state, now(), now(), who.code],
    )
    log(database, who.study, who.code, ending)


def wipe(database: Database, who: Participant) -> None:
    """Delete what is known of somebody but for the code and the times of coming and going."""
    for table in ("answers", "page_times"):
        database.execute(f"delete from {table} where participant = ?", [who.code])
    database.execute("update assignments set record = null where participant = ?", [who.code])
    database.execute("update participants set parameters = '{}' where code = ?", [who.code])


def after_tutorial(database: Database, who: Participant, study: Study) -> None:
    """Let somebody go on who has read the instructions."""
    go(database, who, "practice" if study.practice else "quiz" if study.quiz else "trial")


def after_playing(database: Database, who: Participant, study: Study) -> None:
    """Let somebody go on whose practice task or trial is over."""
    if who.stage == "practice":
        if who.place + 1 < len(study.practice):
            go(database, who, "practice", who.place + 1)
        else:
            go(database, who, "quiz" if study.quiz else "trial")
    elif study.after_trial:
        go(database, who, "after", who.place)
    else:
        after_questions(database, who, study)


def after_quiz(
    database: Database, who: Participant, study: Study, wrong: tuple[Question, ...]
) -> None:
    """Let somebody go on, try again or be through, after the quiz."""
    tries = who.quiz_tries + 1
    database.execute("update participants set quiz_tries = ? where code = ?", [tries, who.code])
    if not wrong:
        go(database, who, "trial")
    elif tries >= study.quiz_tries:
        end(database, who, "failed_check")


def after_questions(database: Database, who: Participant, study: Study) -> None:
    """Let somebody go on who has answered what is asked after a trial; now they may be told."""
    if study.reveal_success:
        go(database, who, "outcome", who.place)
    else:
        after_trial(database, who, study)


def after_trial(database: Database, who: Participant, study: Study) -> None:
    """Let somebody go on who is through with a trial and all that belongs to it."""
    if who.place + 1 < study.trials:
        go(database, who, "trial", who.place + 1)
    elif study.at_end:
        go(database, who, "end")
    else:
        end(database, who, "completed")
