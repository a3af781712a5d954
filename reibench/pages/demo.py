"""The demo page: widgets and wiring."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields, replace
from typing import Any

import gradio as gr

from reibench import models
from reibench.errors import ReibenchError, StaleStep, UnknownName
from reibench.pages.asking import Ask, actor_called, visitor_token
from reibench.pages.fetching import Fetcher
from reibench.sittings import Sittings
from reibench.view.catalogue import Catalogue
from reibench.view.screens import (
    Screen,
    Setting,
    frame,
    loading,
    model_screen,
    model_step,
    person_screen,
    person_step,
    picker_panel,
    side_screen,
    side_stage,
)
from reibench.view.shelf import shelf
from reibench.view.topbar import ModelStatus
from reibench.watching import Sitting

BUS = """
window.reiTrigger = (name, data) => trigger(name, data);
window.dispatchEvent(new Event("rei:bus"));
// events: 'step' 'done' 'again' 'choose' 'solve' 'watch' 'halt' 'row' 'look' 'fetch'
"""
PARTS = tuple(field.name for field in fields(Screen))
Links = Sequence[tuple[str, str]]
Answer = tuple[Any, ...]


def build(sittings: Sittings, *, links: Links = (("Demo", "/"),), model: str = "") -> gr.Blocks:
    """Return the demo as a Gradio app.

    Args:
        sittings: the episodes, and who is at which.
        links: title and address of the pages the bar leads to, this one first.
        model: the language model planners ask, e.g. `scripted:FILE`; from the shelf if empty.
    """
    demo = Demo(sittings, links, model)
    blocks: gr.Blocks = gr.Blocks(title="REI-Bench", analytics_enabled=False)
    with blocks:
        visitor = gr.BrowserState("", storage_key="reibench-visitor", secret="reibench")
        bus = gr.HTML(frame(), elem_id="bus", js_on_load=BUS, apply_default_css=False)
        reply, parts = _lay_out()
        outputs = [reply, *parts.values()]
        quick: dict[str, Any] = {
            "queue": False,
            "show_progress": "hidden",
            "api_visibility": "private",
            "trigger_mode": "multiple",
        }
        slow = quick | {"queue": True, "concurrency_limit": 8}
        watching = bus.watch(demo.watch, [visitor], outputs, **slow, concurrency_id="watch")
        bus.fetch(demo.fetch, [visitor], outputs, **slow, concurrency_id="fetch")
        for name in ("step", "done", "solve", "row", "halt", "look"):
            getattr(bus, name)(getattr(demo, name), [visitor], outputs, **quick)
        for name in ("choose", "again"):
            # whatever is being watched ends: its answers would overwrite the new choice
            handler = getattr(demo, name)
            getattr(bus, name)(handler, [visitor], outputs, cancels=[watching], **quick)
        blocks.load(demo.restore, [visitor], [visitor, *outputs], **quick)
    return blocks


def _lay_out() -> tuple[gr.HTML, dict[str, gr.HTML]]:
    """Make the page's parts, in the order the focus takes."""

    def part(start: str | None = "", **options: Any) -> gr.HTML:
        return gr.HTML(start or "", apply_default_css=False, **options)

    empty = loading()
    with gr.Column(elem_id="frame"):
        reply = part(elem_id="reply", elem_classes="keeps")
        bar = part(elem_id="bar")
        with gr.Row(elem_id="cols"):
            with gr.Column(elem_classes="part d-dialogue"):
                talk = part(elem_classes="fills")
            with gr.Column(elem_classes="part d-room"):
                room = part(empty.room, elem_classes="fills")
            with gr.Column(elem_classes="part d-actor"):
                part(picker_panel(), elem_id="picker", elem_classes="keeps")
                act = part(elem_classes="fills")
        stage = part(elem_id="stage", elem_classes="fills")
        sheet = part(elem_id="settings", elem_classes="keeps")
    made = {"bar": bar, "talk": talk, "room": room, "act": act, "stage": stage, "sheet": sheet}
    return reply, {name: made[name] for name in PARTS}


class Demo:
    """The page's handlers: each looks up, iterates the engine and shows the outcome.

    Whoever asks, every handler works only on the sittings of the visitor token that came along.
    """

    def __init__(self, sittings: Sittings, links: Links, model: str) -> None:
        self._sittings = sittings
        self._links = links
        self._model = model
        self._catalogue = Catalogue.of(sittings.episodes.values())
        self._fetcher = Fetcher()

    # what a visitor does

    def restore(self, visitor: str, request: gr.Request) -> Answer:
        """Show what this visitor did last, or what the address asks for."""
        token = visitor_token(visitor)
        wanted = request.query_params
        episode = wanted.get("episode") or ""
        current = self._sittings.current(token)
        if episode not in self._sittings.episodes:
            episode = current.episode.id if current else self._catalogue.first.id
        actor = actor_called(wanted.get("actor")) or "me"
        ask = Ask(episode=episode, actor=actor)
        return (token, *self._answer(ask, self._screen(token, ask)))

    def step(self, visitor: str, event: gr.EventData) -> Answer:
        """Carry out a skill."""
        ask = Ask.read(event._data)

        def act() -> Sitting:
            return self._sittings.step(ask.sitting, visitor, ask.skill, ask.expected, ask.seconds)

        return self._answer(ask, self._acted(visitor, ask, act))

    def done(self, visitor: str, event: gr.EventData) -> Answer:
        """End the episode."""
        ask = Ask.read(event._data)

        def act() -> Sitting:
            return self._sittings.done(ask.sitting, visitor, ask.expected)

        return self._answer(ask, self._acted(visitor, ask, act))

    def solve(self, visitor: str, event: gr.EventData) -> Answer:
        """Show or hide the expert's steps."""
        ask = Ask.read(event._data)
        return self._answer(
            ask, self._acted(visitor, ask, lambda: self._sittings.find(ask.sitting, visitor))
        )

    def again(self, visitor: str, event: gr.EventData) -> Answer:
        """Begin the same episode afresh."""
        ask = Ask.read(event._data)
        self._sittings.open(visitor, ask.episode, afresh=True)
        return self._answer(ask, self._screen(visitor, ask))

    def choose(self, visitor: str, event: gr.EventData) -> Answer:
        """Change episode, actor, model or method."""
        ask = Ask.read(event._data)
        self._sittings.stop(visitor)
        current = self._sittings.episodes.get(ask.episode, self._catalogue.first)
        if ask.shuffle is not None:
            chosen = self._catalogue.shuffled(current, ask.shuffle)
        else:
            chosen = self._catalogue.change(current, kind=ask.kind, task=ask.task, level=ask.level)
        ask = replace(ask, episode=chosen.id, actor=ask.as_actor or ask.actor)
        return self._answer(ask, self._screen(visitor, ask, sheet=True))

    # what a planner does

    def watch(self, visitor: str, event: gr.EventData) -> Iterator[Answer]:
        """Let a planner act, or two of them in turn, and show each step."""
        ask = Ask.read(event._data)
        screens = self._watch_both if ask.actor == "side" else self._watch_one
        try:
            for screen in screens(visitor, ask):
                yield self._answer(ask, screen)
        except ReibenchError as problem:
            yield self._answer(ask, self._screen(visitor, ask, notice=str(problem)))

    def _watch_one(self, visitor: str, ask: Ask) -> Iterator[Screen]:
        setting = self._setting(ask)
        method = ask.method if ask.actor == "tocc" else "none"
        sitting = None
        for sitting in self._sittings.watch(visitor, ask.episode, method, self._model_of(ask)):
            yield model_step(setting, ask.actor, sitting.start, sitting, ready=True)
        if sitting is not None:  # the model is loaded by now, which the bar should say
            fresh = self._setting(ask, sitting)
            yield Screen(bar=fresh.bar(sitting.start, ask.actor))

    def _watch_both(self, visitor: str, ask: Ask) -> Iterator[Screen]:
        setting, model = self._setting(ask), self._model_of(ask)
        watches = [
            self._sittings.watch(visitor, ask.episode, method, model)
            for method in ("none", ask.method)
        ]
        runs: list[Sitting | None] = [None, None]
        sitting = None
        going = [0, 1]
        while going:
            for side in tuple(going):
                runs[side] = sitting = next(watches[side], None) or runs[side]
                if sitting is None or sitting.status is not None:
                    going.remove(side)
                yield Screen(stage=side_stage(setting, (runs[0], runs[1])))
        if sitting is not None:
            yield Screen(bar=self._setting(ask, sitting).bar(sitting.start, "side"))

    def halt(self, visitor: str, event: gr.EventData) -> Answer:
        """Stop what this visitor watches after the step it is at."""
        self._sittings.stop(visitor)
        return self._answer(Ask.read(event._data), Screen())

    def row(self, visitor: str, event: gr.EventData) -> Answer:
        """Show the rooms of two runs as they were at one row."""
        ask = Ask.read(event._data)
        runs = (
            self._sittings.find(ask.left, visitor),
            self._sittings.find(ask.right, visitor),
        )
        stage = side_stage(self._setting(ask), runs, row=ask.row)
        return self._answer(ask, Screen(stage=stage))

    # models

    def look(self, visitor: str, event: gr.EventData) -> Answer:
        """Show the shelf as it is now."""
        ask = Ask.read(event._data)
        return self._answer(ask, Screen(sheet=self._sheet(ask)))

    def fetch(self, visitor: str, event: gr.EventData) -> Iterator[Answer]:
        """Fetch a model, and show how far it is."""
        ask = Ask.read(event._data)
        try:
            for _ in self._fetcher.fetch(ask.wanted):
                yield self._answer(ask, Screen(sheet=self._sheet(ask)))
        except UnknownName:
            pass
        yield self._answer(ask, Screen(sheet=self._sheet(ask)))

    # screens

    def _acted(self, visitor: str, ask: Ask, act: Callable[[], Sitting]) -> Screen:
        """Return the page after the visitor acted, and what was in the way if anything."""
        try:
            sitting, notice = act(), ""
        except StaleStep:
            sitting = self._sittings.find(ask.sitting, visitor)
            notice = f"This tab was behind. It now shows step {len(sitting.steps)}."
        except ReibenchError as problem:
            sitting, notice = self._sittings.open(visitor, ask.episode), str(problem)
        solution = self._sittings.solution(sitting.episode.id) if ask.solution else ()
        return person_step(sitting, notice=notice, solution=solution)

    def _screen(self, visitor: str, ask: Ask, *, notice: str = "", sheet: bool = False) -> Screen:
        """Return the whole page for what was chosen."""
        setting = self._setting(ask)
        own = self._sittings.open(visitor, ask.episode)
        watched = self._sittings.watched(visitor, ask.episode)
        plain, told = (
            watched.get(f"saycan+{method}/{self._model_of(ask)}") for method in ("none", ask.method)
        )
        if ask.actor == "me":
            screen = person_screen(setting, own, notice=notice)
        elif ask.actor == "side":
            screen = side_screen(setting, own.start, (plain, told), notice=notice)
        else:
            run = told if ask.actor == "tocc" else plain
            ready = self._sittings.model_ready(self._model_of(ask))
            screen = model_screen(setting, ask.actor, own.start, run, ready=ready, notice=notice)
        return replace(screen, sheet=self._sheet(ask)) if sheet else screen

    def _setting(self, ask: Ask, sitting: Sitting | None = None) -> Setting:
        episode = self._sittings.episode(ask.episode)
        status = self._status(ask, sitting)
        return Setting(self._catalogue, episode, status, ask.method, self._links)

    def _status(self, ask: Ask, sitting: Sitting | None) -> ModelStatus:
        name = self._model_of(ask)
        short = name.split(":", 1)[-1].split("/")[-1]
        if not name:
            return ModelStatus("no model", "get one to watch it act", "warn")
        if not self._sittings.model_ready(name):
            return ModelStatus(short, "loads when first asked", "warn")
        if sitting is None or not sitting.steps:
            return ModelStatus(short, "ready")
        pace = sum(step.seconds for step in sitting.steps) / len(sitting.steps)
        return ModelStatus(short, f"ready · {pace:.1f} s a step")

    def _model_of(self, ask: Ask) -> str:
        """Return the model to ask: the server's own, else the visitor's choice from the shelf."""
        if self._model:
            return self._model
        present = [entry for entry in models.overview() if entry.present]
        chosen = [entry for entry in present if entry.model.name == ask.model] or [
            entry for entry in present if entry.default
        ]
        return f"llama-cpp:{chosen[0].model.name}" if chosen else ""

    def _sheet(self, ask: Ask) -> str:
        name = self._model_of(ask)
        return shelf(
            models.overview(),
            chosen=name.split(":", 1)[-1],
            method=ask.method,
            ready=self._sittings.model_ready(name),
            fetching=self._fetcher.states,
        )

    def _answer(self, ask: Ask, screen: Screen) -> Answer:
        """Return the new values of the page's parts, after the number of what is answered."""
        values = [getattr(screen, name) for name in PARTS]
        stamp = f'<i data-reply="{ask.seq}" hidden></i>'
        return (stamp, *(gr.skip() if value is None else value for value in values))
