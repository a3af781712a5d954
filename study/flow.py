"""The participant's way: which stage comes next, decided on the server for every click.

A stage is left only by what belongs to it, and each change is one transaction, so a reload, a
second tab or a restarted server finds everybody where they were.
"""

import threading
from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime

from sqlite_utils import Database

from reibench.backends import Backend
from reibench.errors import ModelUnavailable, ReibenchError, StaleStep
from reibench.run import RunSpec
from reibench.sittings import Sittings
from reibench.store.schema import now
from reibench.watching import Sitting
from study.answering import Answers, checked, keep_answers, wrong_answers
from study.config import Question, Study, all_episodes
from study.enrolment import Assignment, Closed, Enrolment, Participant
from study.stages import (
    BEHIND,
    Page,
    Stage,
    after_playing,
    after_questions,
    after_quiz,
    after_trial,
    after_tutorial,
    end,
    ending_of,
    go,
    questions_at,
    refuse_elsewhere,
    see,
    stage_of,
    wipe,
)

LOCKS = 64


class Flow:
    """Everybody's way through the studies of one database."""

    def __init__(self, enrolment: Enrolment) -> None:
        self.enrolment = enrolment
        self._store = enrolment.store
        self._sittings: dict[tuple[str, int], Sittings] = {}
        self._locks = tuple(threading.RLock() for _ in range(LOCKS))

    def page(self, token: str) -> Page:
        """Return where a participant is; raises UnknownName for a token nobody has."""
        with self._lock(token):
            return self._page(self.enrolment.participant(token))

    # what a participant does

    def consent(self, token: str, *, agreed: bool) -> Page:
        """Agree to take part, or not."""

        def note(database: Database, who: Participant) -> None:
            if agreed:
                go(database, who, "tutorial")
            else:
                wipe(database, who)
                end(database, who, "no_consent")

        return self._move(token, "consent", 0, note)

    def read(self, token: str, stage: Stage = "tutorial", place: int = 0) -> Page:
        """Have read the tutorial, or how a trial came out."""
        if stage not in ("tutorial", "outcome"):
            raise StaleStep(BEHIND)

        def note(database: Database, who: Participant) -> None:
            study = self.enrolment.study(who.study, who.version)
            go_on = after_tutorial if stage == "tutorial" else after_trial
            go_on(database, who, study)

        return self._move(token, stage, place, note)

    def step(
        self, token: str, stage: Stage, place: int, skill: str, expected: int, seconds: float | None
    ) -> Page:
        """Carry out a skill in the practice task or trial of that place.

        Raises:
            StaleStep: when the participant is elsewhere, or the episode at another step.
            UnknownSkill: for text that is no skill.
        """
        with self._lock(token):
            page = self._playing(token, stage, place)
            assert page.sitting is not None
            sittings = self._sittings_of(page.study)
            sittings.step(page.sitting.id, page.participant.code, skill, expected, seconds)
            with self._store.writing() as database:
                see(database, page.participant)
            return self.page(token)

    def done(self, token: str, stage: Stage, place: int, expected: int) -> Page:
        """Say that the request is carried out."""
        with self._lock(token):
            page = self._playing(token, stage, place)
            assert page.sitting is not None
            sittings = self._sittings_of(page.study)
            sittings.done(page.sitting.id, page.participant.code, expected)
            return self.page(token)

    def answer(
        self, token: str, stage: Stage, place: int, answers: Answers, attempt: int = 0
    ) -> Page:
        """Answer the questions of the quiz, after a trial, or at the end.

        `attempt` says how many tries at the quiz there were when the page was shown, so that a
        doubled click is not taken for a second one.

        Raises:
            StaleStep: when the participant is elsewhere, or has answered meanwhile.
            ReibenchError: naming the question whose answer is missing or none of its options.
        """
        if stage not in ("quiz", "after", "end"):
            raise ReibenchError(f"Nothing is asked at the stage {stage!r}.")

        def note(database: Database, who: Participant) -> None:
            if stage == "quiz" and attempt != who.quiz_tries:
                raise StaleStep("This was answered already. The page now shows where you are.")
            study = self.enrolment.study(who.study, who.version)
            asked = questions_at(study, stage)
            given = checked(asked, answers)
            keep_answers(database, who.code, stage, place, who.quiz_tries + 1, asked, given)
            if stage == "quiz":
                after_quiz(database, who, study, wrong_answers(asked, given))
            elif stage == "end":
                end(database, who, "completed")
            else:
                after_questions(database, who, study)

        return self._move(token, stage, place, note)

    def withdraw(self, token: str) -> Page:
        """Leave: what was answered and done is deleted, that somebody was here is not."""
        with self._lock(token):
            who = self.enrolment.participant(token)
            if who.state == "withdrawn":
                return self._page(who)
            records = self._store.entries("visitor = ? and origin = 'study'", [who.code])
            with self._store.writing() as database:
                wipe(database, who)
                self._store.forget(database, [one.id for one in records])
                end(database, who, "withdrawn")
            return self.page(token)

    def timed(
        self, token: str, stage: Stage, place: int, step: int, times: tuple[float, float, float]
    ) -> None:
        """Note when a page was shown and left by the client's clock, and how long it was hidden.

        `times` are milliseconds since the epoch, twice, and a duration in milliseconds.
        """
        with self._lock(token), self._store.writing() as database:
            who = self.enrolment.participant(token)
            if who.state not in ("active", "finished", "failed_check"):
                return  # nothing more is kept of them
            database.execute(
                "insert into page_times values (?, ?, ?, ?, ?, ?, ?, ?)",
                [who.code, stage, place, step, *times, now()],
            )

    # helpers

    def _lock(self, token: str) -> threading.RLock:
        return self._locks[hash(token) % LOCKS]

    def _sittings_of(self, study: Study) -> Sittings:
        key = (study.rules, study.max_steps)
        if key not in self._sittings:
            spec = RunSpec(rules=study.rules, max_steps=study.max_steps)
            self._sittings[key] = Sittings(
                all_episodes(), self._store, _no_model, spec=spec, origin="study"
            )
        return self._sittings[key]

    def _move(
        self,
        token: str,
        stage: Stage,
        place: int,
        change: Callable[[Database, Participant], None],
    ) -> Page:
        """Change where a participant is, if they are still where the page says."""
        with self._lock(token):
            with self._store.writing() as database:
                who = self.enrolment.participant(token)
                refuse_elsewhere(who, stage, place)
                self._refuse_stopped(who)
                change(database, who)
            return self.page(token)

    def _refuse_stopped(self, who: Participant) -> None:
        if who.state == "active" and self.enrolment.is_stopped(who.study):
            raise Closed("This study has been stopped. What you have done is kept. Thank you.")

    def _playing(self, token: str, stage: Stage, place: int) -> Page:
        who = self.enrolment.participant(token)
        refuse_elsewhere(who, stage, place)
        self._refuse_stopped(who)
        page = self.page(token)
        if (page.stage, page.place) != (stage, place) or page.sitting is None:
            raise StaleStep("This task is over. The page now shows where you are.")
        return page

    def _page(self, who: Participant) -> Page:
        """Return the page of a participant, ending first what has ended."""
        study = self.enrolment.study(who.study, who.version)
        stage = stage_of(who)
        page = Page(who, study, stage, who.place)
        if who.state == "active" and self.enrolment.is_stopped(who.study):
            return replace(page, stage="over", stopped=True)
        if stage in ("practice", "trial"):
            sitting = self._sitting(who, study, stage)
            left = self._seconds_left(study, stage, sitting)
            if sitting.status is None and left is not None and left <= 0:
                sitting = self._sittings_of(study).expire(sitting.id, who.code)
            if sitting.status is None:
                return replace(page, sitting=sitting, seconds_left=left)
            return self._page(self._played(who, study))
        if stage == "over":
            ending = ending_of(who)
            code = study.codes.get(ending or "", "")
            link = study.links.get(ending or "", "").replace("{code}", code)
            return replace(page, ending=ending, code=code, link=link)
        asked = questions_at(study, stage)
        wrong = self._wrong(who, asked) if stage == "quiz" else ()
        if stage not in ("after", "outcome"):
            return replace(page, questions=asked, wrong=wrong)
        given = self._given(who, "trial")
        [entry] = self._store.entries("id = ?", [given.record])
        if stage == "outcome":
            return replace(page, solved=entry.status == "success")
        record = self._store.record(entry.id)
        request = record.episode.dialogue.instruction.text
        page = replace(page, questions=asked, room=given.room, request=request)
        if record.said_done:
            return page
        return replace(page, spent="time" if record.expired else "steps")

    def _played(self, who: Participant, study: Study) -> Participant:
        """Let somebody go on whose task is over, unless they were turned away meanwhile."""
        with self._store.writing() as database:
            now = self.enrolment.participant(who.token)
            if (now.state, now.stage, now.place) == (who.state, who.stage, who.place):
                after_playing(database, now, study)
        return self.enrolment.participant(who.token)

    def _sitting(self, who: Participant, study: Study, stage: Stage) -> Sitting:
        """Return the episode that is being played, begun if need be."""
        sittings = self._sittings_of(study)
        given = self._given(who, stage)
        if given.record:
            return sittings.find(given.record, who.code)
        sitting = sittings.open(who.code, given.episode)
        with self._store.writing() as database:
            database.execute(
                "update assignments set record = ?"
                " where participant = ? and kind = ? and place = ?",
                [sitting.id, who.code, stage, who.place],
            )
        return sitting

    def _given(self, who: Participant, stage: Stage) -> Assignment:
        return self.enrolment.assignments(who.code, stage)[who.place]

    def _seconds_left(self, study: Study, stage: Stage, sitting: Sitting) -> float | None:
        """Return how long a trial may still last, by the server's clock; None without a limit."""
        if not study.trial_minutes or stage != "trial":
            return None
        [row] = self._store.query("select started from records where id = ?", [sitting.id])
        passed = datetime.now(UTC) - datetime.fromisoformat(row["started"])
        return 60 * study.trial_minutes - passed.total_seconds()

    def _wrong(self, who: Participant, asked: tuple[Question, ...]) -> tuple[Question, ...]:
        rows = self._store.query(
            "select question from answers where participant = ? and stage = 'quiz'"
            " and attempt = ? and right = 0",
            [who.code, who.quiz_tries],
        )
        names = {row["question"] for row in rows}
        return tuple(question for question in asked if question.name in names)


def _no_model(name: str) -> Backend:
    raise ModelUnavailable(f"A study asks no language model, not {name} either.")
