"""The participants' page: widgets and wiring."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import gradio as gr

from reibench.errors import ReibenchError, StaleStep, UnknownName
from reibench.pages.asking import visitor_token
from reibench.pages.wiring import QUICK
from reibench.view.icons import sprite
from reibench.view.markup import element, text
from reibench.view.screens import picker_panel
from study import view
from study.enrolment import Enrolment
from study.flow import Flow
from study.stages import BEHIND, STAGES, Page, Stage

BUS = """
window.reiTrigger = (name, data) => trigger(name, data);
window.dispatchEvent(new Event("rei:bus"));
// events: 'consent' 'read' 'step' 'done' 'answer' 'look' 'withdraw'
"""
PARTS = ("where", "bar", "talk", "room", "act", "card", "extra")
Answer = tuple[Any, ...]
NO_STUDY = "There is no such study. Please use the link as it was sent to you."
LATEST = 1e14
"""Milliseconds since the epoch that are no clock's any more."""


@dataclass(frozen=True)
class Sent:
    """What an event from the browser carries; anything odd counts as not given."""

    seq: int
    stage: Stage
    place: int
    expected: int
    attempt: int
    skill: str
    seconds: float | None
    agreed: bool
    answers: Mapping[str, Any]
    times: tuple[float, float, float] | None

    @classmethod
    def read(cls, sent: object) -> "Sent":
        """Read an event; raises StaleStep for a stage there is none of."""
        data: Mapping[str, Any] = sent if isinstance(sent, Mapping) else {}
        stage = next((one for one in STAGES if one == data.get("stage")), None)
        if stage is None:
            raise StaleStep(BEHIND)
        answers = data.get("answers")
        return cls(
            seq=_whole(data.get("seq")),
            stage=stage,
            place=_whole(data.get("place")),
            expected=_whole(data.get("expected")),
            attempt=_whole(data.get("attempt")),
            skill=str(data.get("skill") or "")[:200],
            seconds=_number(data.get("seconds")),
            agreed=data.get("agreed") is True,
            answers=answers if isinstance(answers, Mapping) else {},
            times=_times(data),
        )


def build(enrolment: Enrolment, *, simulated: bool = False) -> gr.Blocks:
    """Return the participants' page as a Gradio app, for every study of the database.

    `simulated` marks everybody who comes to it.
    """
    taking_part = TakingPart(enrolment, simulated=simulated)
    blocks: gr.Blocks = gr.Blocks(title="Study", analytics_enabled=False)
    with blocks:
        visitor = gr.BrowserState({}, storage_key="reibench-study", secret="reibench")
        bus = gr.HTML(_frame(), elem_id="bus", js_on_load=BUS, apply_default_css=False)
        reply, parts = _lay_out()
        outputs = [reply, *parts]
        for name in ("consent", "read", "step", "done", "answer", "look", "withdraw"):
            getattr(bus, name)(getattr(taking_part, name), [visitor], outputs, **QUICK)
        blocks.load(taking_part.arrive, [visitor], [visitor, *outputs], **QUICK)
    return blocks


def _frame() -> str:
    skip = element("a", "To the task", href="#skill", class_="skip")
    live = element("div", id="live", class_="sr", aria_live="polite", role="status")
    return skip + sprite() + live


def _lay_out() -> tuple[gr.HTML, list[gr.HTML]]:
    def part(start: str = "", **options: Any) -> gr.HTML:
        return gr.HTML(start, apply_default_css=False, **options)

    with gr.Column(elem_id="frame"):
        reply = part(elem_id="reply", elem_classes="keeps")
        where = part(elem_classes="keeps")
        bar = part(elem_id="bar")
        with gr.Row(elem_id="cols"):
            with gr.Column(elem_classes="part d-dialogue"):
                talk = part(elem_classes="fills")
            with gr.Column(elem_classes="part d-actor"):
                part(picker_panel(), elem_id="picker", elem_classes="keeps")
                act = part(elem_classes="fills")
            with gr.Column(elem_classes="part d-room"):
                room = part(elem_classes="fills")
        card = part(elem_id="page")
        extra = part(elem_id="extra", elem_classes="keeps")
    return reply, [where, bar, talk, room, act, card, extra]


class TakingPart:
    """The page's handlers: each looks up who it is by their token, and lets the flow decide."""

    def __init__(self, enrolment: Enrolment, *, simulated: bool = False) -> None:
        """Serve the studies of a database; `simulated` marks everybody who comes."""
        self._enrolment = enrolment
        self.flow = Flow(enrolment)
        self._simulated = simulated

    def arrive(self, known: object, request: gr.Request) -> Answer:
        """Take somebody in, or show who came before where they were."""
        wanted = {key: str(value)[:200] for key, value in request.query_params.items()}
        name, invite = wanted.get("study", ""), wanted.get("invite", "")
        tokens = dict(known) if isinstance(known, Mapping) else {}
        try:
            token = self._token(tokens.get(name), name, invite, wanted)
            page = self.flow.page(token)
        except UnknownName:  # the names of others are nobody's business
            return (gr.skip(), *_answer(0, None, NO_STUDY))
        except ReibenchError as problem:
            return (gr.skip(), *_answer(0, None, str(problem)))
        return ({**tokens, name: token}, *_answer(0, page))

    def _token(self, known: object, name: str, invite: str, parameters: Mapping[str, str]) -> str:
        token = known if isinstance(known, str) and visitor_token(known) == known else ""
        if token and self._enrolment.is_same(token, name, parameters, invite):
            return token
        return self._enrolment.arrive(
            name, parameters, invite=invite, simulated=self._simulated
        ).token

    def consent(self, known: object, event: gr.EventData) -> Answer:
        """Agree, or not."""
        return self._do(
            known, event, lambda token, sent: self.flow.consent(token, agreed=sent.agreed)
        )

    def read(self, known: object, event: gr.EventData) -> Answer:
        """Have read the instructions."""
        return self._do(
            known, event, lambda token, sent: self.flow.read(token, sent.stage, sent.place)
        )

    def step(self, known: object, event: gr.EventData) -> Answer:
        """Carry out a skill."""
        return self._do(
            known,
            event,
            lambda token, sent: self.flow.step(
                token, sent.stage, sent.place, sent.skill, sent.expected, sent.seconds
            ),
        )

    def done(self, known: object, event: gr.EventData) -> Answer:
        """Say that the wish is carried out."""
        return self._do(
            known,
            event,
            lambda token, sent: self.flow.done(token, sent.stage, sent.place, sent.expected),
        )

    def answer(self, known: object, event: gr.EventData) -> Answer:
        """Answer questions."""
        return self._do(
            known,
            event,
            lambda token, sent: self.flow.answer(
                token, sent.stage, sent.place, sent.answers, sent.attempt
            ),
        )

    def look(self, known: object, event: gr.EventData) -> Answer:
        """Show where somebody is now: their time may be up."""
        return self._do(known, event, lambda token, sent: self.flow.page(token))

    def withdraw(self, known: object, event: gr.EventData) -> Answer:
        """Leave the study."""
        return self._do(known, event, lambda token, sent: self.flow.withdraw(token))

    def _do(
        self,
        known: object,
        event: gr.EventData,
        act: Callable[[str, Sent], Page],
    ) -> Answer:
        """Let somebody do something, and show where they are then, and what was in the way."""
        data = event._data if isinstance(event._data, Mapping) else {}
        seq, name = _whole(data.get("seq")), str(data.get("study") or "")
        stands = False
        token = known.get(name) if isinstance(known, Mapping) else None
        if not isinstance(token, str):
            return _answer(seq, None, "Please open the link to the study again.")
        notice = ""
        try:
            sent = Sent.read(data)
            page = act(token, sent)
            if sent.times:  # only of what was accepted, so a doubled click leaves no second page
                self.flow.timed(token, sent.stage, sent.place, sent.expected, sent.times)
            # within a task, what was said and the bar are on the page already
            stands = sent.expected > 0 and (page.stage, page.place) == (sent.stage, sent.place)
        except ReibenchError as problem:
            notice = BEHIND if isinstance(problem, StaleStep) else str(problem)
            try:
                page = self.flow.page(token)
            except ReibenchError:
                return _answer(seq, None, "Please open the link to the study again.")
        return _answer(seq, page, notice, stands=stands)


def _answer(seq: int, page: Page | None, notice: str = "", *, stands: bool = False) -> Answer:
    """Return the new values of the page's parts, after the number of what is answered.

    `stands` says that the page shows this very task already.
    """
    stamp = f'<i data-reply="{seq}" hidden></i>'
    if page is None:
        told = element("main", element("p", text(notice), role="alert"), class_="card", id="card")
        return (stamp, "", "", "", "", "", told, "")
    playing = page.sitting
    may_leave = page.stage != "over" or page.stopped
    extra = view.leaving() + view.helping(page.study) if may_leave else ""
    if playing is None:
        return (
            stamp, view.where(page), view.header(page), "", "", "", view.card(page, notice), extra,
        )  # fmt: skip
    room = view.room(playing) if page.study.shows == "text and room" else ""
    where, actions = view.where(page), view.actions(page, playing, notice)
    if stands:
        return (stamp, where, gr.skip(), gr.skip(), room, actions, gr.skip(), gr.skip())
    return (stamp, where, view.header(page), view.talk(playing), room, actions, "", extra)


def _whole(value: object) -> int:
    return value if isinstance(value, int) and not isinstance(value, bool) else 0


def _number(value: object) -> float | None:
    usable = isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value < 1e6
    return float(value) if usable and isinstance(value, int | float) else None


def _times(data: Mapping[str, Any]) -> tuple[float, float, float] | None:
    found = [data.get(name) for name in ("shown", "left", "hidden")]
    numbers = [float(e) for e in found if isinstance(e, int | float) and 0 <= e < LATEST]
    return (numbers[0], numbers[1], numbers[2]) if len(numbers) == 3 else None
