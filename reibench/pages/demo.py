"""The demo page: widgets and wiring."""

from collections.abc import Iterator
from dataclasses import fields, replace
from functools import partial
from typing import Any

import gradio as gr

from reibench import gallery
from reibench.errors import ReibenchError
from reibench.pages.asking import Ask, visitor_token
from reibench.pages.showing import Links, Showing
from reibench.pages.wiring import QUICK
from reibench.sittings import Sittings
from reibench.view.screens import Screen, frame, loading, picker_panel

BUS = """
window.reiTrigger = (name, data) => trigger(name, data);
window.dispatchEvent(new Event("rei:bus"));
// events: 'step' 'done' 'again' 'choose' 'solve' 'watch' 'halt' 'row' 'look' 'fetch' 'seek'
"""
PARTS = tuple(field.name for field in fields(Screen))
Answer = tuple[Any, ...]


def build(sittings: Sittings, *, links: Links = (("Demo", "/"),), model: str = "") -> gr.Blocks:
    """Return the demo as a Gradio app.

    Args:
        sittings: the episodes, and who is at which.
        links: title and address of the pages the bar leads to, this one first.
        model: the language model planners ask, e.g. `scripted:FILE`; from the shelf if empty.
    """
    demo = Demo(sittings, Showing(sittings, links, model))
    blocks: gr.Blocks = gr.Blocks(title="REI-Bench", analytics_enabled=False)
    with blocks:
        visitor = gr.BrowserState("", storage_key="reibench-visitor", secret="reibench")
        bus = gr.HTML(frame(), elem_id="bus", js_on_load=BUS, apply_default_css=False)
        reply, parts = _lay_out()
        outputs = [reply, *parts.values()]
        slow = QUICK | {"queue": True, "concurrency_limit": 8}
        watching = bus.watch(demo.watch, [visitor], outputs, **slow, concurrency_id="watch")
        bus.fetch(demo.fetch, [visitor], outputs, **slow, concurrency_id="fetch")
        for name in ("step", "done", "solve", "row", "halt", "look", "seek"):
            getattr(bus, name)(getattr(demo, name), [visitor], outputs, **QUICK)
        for name in ("choose", "again"):
            # whatever is being watched ends: its answers would overwrite the new choice
            handler = getattr(demo, name)
            getattr(bus, name)(handler, [visitor], outputs, cancels=[watching], **QUICK)
        blocks.load(demo.restore, [visitor], [visitor, *outputs], **QUICK)
    return blocks


def _lay_out() -> tuple[gr.HTML, dict[str, gr.HTML]]:
    """Make the page's parts in the order the focus takes: keyboards act before the room."""

    def part(start: str | None = "", **options: Any) -> gr.HTML:
        return gr.HTML(start or "", apply_default_css=False, **options)

    empty = loading()
    with gr.Column(elem_id="frame"):
        reply = part(elem_id="reply", elem_classes="keeps")
        bar = part(elem_id="bar")
        with gr.Row(elem_id="cols"):
            with gr.Column(elem_classes="part d-dialogue"):
                talk = part(elem_classes="fills")
            with gr.Column(elem_classes="part d-actor"):
                part(picker_panel(), elem_id="picker", elem_classes="keeps")
                act = part(elem_classes="fills")
            with gr.Column(elem_classes="part d-room"):
                room = part(empty.room, elem_classes="fills")
        stage = part(elem_id="stage", elem_classes="fills")
        sheet = part(elem_id="settings", elem_classes="keeps")
        with gr.Column(elem_id="finder", elem_classes="keeps"):
            made = {"seek": part(), "found": part()}
    made |= {"bar": bar, "talk": talk, "room": room, "act": act, "stage": stage, "sheet": sheet}
    return reply, {name: made[name] for name in PARTS}


class Demo:
    """The page's handlers: each looks up, iterates the engine and shows the outcome.

    Whoever asks, every handler works only on the sittings of the visitor token that came along.
    """

    def __init__(self, sittings: Sittings, showing: Showing) -> None:
        self._sittings = sittings
        self._showing = showing
        self._gallery = gallery.cases()

    # what a visitor does

    def restore(self, visitor: str, request: gr.Request) -> Answer:
        """Show what this visitor did last, or what the address asks for."""
        token, wanted = visitor_token(visitor), request.query_params
        episode = wanted.get("episode") or ""
        asked = {k: wanted.get(k) for k in ("actor", "model", "planner", "method")}
        if not self._sittings.knows(episode):
            current = self._sittings.current(token)
            if current is None and self._gallery and not asked["actor"]:
                # a first visitor sees at once what this is about
                episode, asked["actor"] = self._gallery[0].episode, "side"
            else:
                episode = current.episode.id if current else self._showing.catalogue.first.id
        ask = Ask.read({"episode": episode} | asked)
        screen = replace(self._showing.whole(token, ask), seek=self._showing.finder().seek)
        return (token, *answer(ask, screen))

    def step(self, visitor: str, event: gr.EventData) -> Answer:
        """Carry out a skill."""
        ask = Ask.read(event._data)
        act = partial(
            self._sittings.step, ask.sitting, visitor, ask.skill, ask.expected, ask.seconds
        )
        return answer(ask, self._showing.acted(visitor, ask, act))

    def done(self, visitor: str, event: gr.EventData) -> Answer:
        """End the episode."""
        ask = Ask.read(event._data)
        act = partial(self._sittings.done, ask.sitting, visitor, ask.expected)
        return answer(ask, self._showing.acted(visitor, ask, act))

    def solve(self, visitor: str, event: gr.EventData) -> Answer:
        """Show or hide the expert's steps."""
        ask = Ask.read(event._data)
        look = partial(self._sittings.find, ask.sitting, visitor)
        return answer(ask, self._showing.acted(visitor, ask, look))

    def again(self, visitor: str, event: gr.EventData) -> Answer:
        """Begin the same episode afresh."""
        ask = Ask.read(event._data)
        return answer(ask, self._showing.whole(visitor, ask, afresh=True))

    def choose(self, visitor: str, event: gr.EventData) -> Answer:
        """Change episode, actor, model or method."""
        ask = Ask.read(event._data)
        self._sittings.stop(visitor)
        catalogue = self._showing.catalogue
        known = self._sittings.knows(ask.episode)
        current = self._sittings.episode(ask.episode) if known else catalogue.first
        if ask.shuffle is not None:
            chosen = catalogue.shuffled(current, ask.shuffle)
        else:
            chosen = catalogue.change(current, kind=ask.kind, task=ask.task, level=ask.level)
        ask = replace(ask, episode=chosen.id, actor=ask.as_actor or ask.actor)
        screen = self._showing.whole(visitor, ask)
        return answer(ask, replace(screen, sheet=self._showing.sheet(ask).sheet))

    def seek(self, visitor: str, event: gr.EventData) -> Answer:
        """Show the episodes that fit what is looked for."""
        ask = Ask.read(event._data)
        return answer(ask, self._showing.found(ask))

    # what a planner does

    def watch(self, visitor: str, event: gr.EventData) -> Iterator[Answer]:
        """Let a planner act, or two of them in turn, and show each step."""
        ask = Ask.read(event._data)
        watch = partial(self._sittings.watch, visitor, ask.episode)
        model, planner = self._showing.model_of(ask), ask.planner
        told = self._showing.method_of(ask)
        try:
            if ask.actor == "side":
                both = [watch(method, model, planner) for method in ("none", told)]
                screens = self._showing.watching_both(ask, both)
            else:
                method = told if ask.actor == "tocc" else "none"
                screens = self._showing.watching(ask, watch(method, model, planner))
            for screen in screens:
                yield answer(ask, screen)
        except ReibenchError as problem:
            yield answer(ask, self._showing.whole(visitor, ask, notice=str(problem)))

    def halt(self, visitor: str, event: gr.EventData) -> Answer:
        """Stop what this visitor watches after the step it is at."""
        self._sittings.stop(visitor)
        return answer(Ask.read(event._data), Screen())

    def row(self, visitor: str, event: gr.EventData) -> Answer:
        """Show the rooms of two runs as they were at one row."""
        ask = Ask.read(event._data)
        try:
            left, right = (self._sittings.find(each, visitor) for each in (ask.left, ask.right))
        except ReibenchError as problem:
            return answer(ask, self._showing.whole(visitor, ask, notice=str(problem)))
        return answer(ask, self._showing.row(ask, left, right))

    # models

    def look(self, visitor: str, event: gr.EventData) -> Answer:
        """Show the shelf as it is now."""
        ask = Ask.read(event._data)
        return answer(ask, self._showing.sheet(ask))

    def fetch(self, visitor: str, event: gr.EventData) -> Iterator[Answer]:
        """Fetch a model, and show how far it is."""
        ask = Ask.read(event._data)
        if ask.wanted in self._showing.fetcher.known():
            for _ in self._showing.fetcher.fetch(ask.wanted):
                yield answer(ask, self._showing.sheet(ask))
        yield answer(ask, self._showing.sheet(ask))


def answer(ask: Ask, screen: Screen) -> Answer:
    """Return the new values of the page's parts, after the number of what is answered."""
    values = [getattr(screen, name) for name in PARTS]
    stamp = f'<i data-reply="{ask.seq}" hidden></i>'
    return (stamp, *(gr.skip() if value is None else value for value in values))
