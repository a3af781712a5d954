"""Which screen answers what was asked."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from reibench import models
from reibench.errors import ReibenchError, StaleStep
from reibench.pages.asking import Ask
from reibench.pages.fetching import Fetcher
from reibench.sittings import Sittings
from reibench.view.actor_panel import trouble_panel
from reibench.view.catalogue import Catalogue
from reibench.view.choices import usable_method
from reibench.view.finder import Seek, finder, found_list
from reibench.view.screens import (
    Screen,
    Setting,
    model_screen,
    model_step,
    person_screen,
    person_step,
    side_screen,
    side_stage,
)
from reibench.view.shelf import shelf
from reibench.view.topbar import ModelStatus
from reibench.watching import Sitting

Links = Sequence[tuple[str, str]]


class Showing:
    """Makes screens from sittings, for whoever they belong to."""

    def __init__(self, sittings: Sittings, links: Links, model: str) -> None:
        self.catalogue = Catalogue.of(sittings.episodes.values())
        self.fetcher = Fetcher()
        self._sittings = sittings
        self._links = links
        self._model = model

    def finder(self) -> Screen:
        """Return the fields for finding an episode."""
        return Screen(seek=finder(self.catalogue))

    def whole(self, visitor: str, ask: Ask, *, notice: str = "", afresh: bool = False) -> Screen:
        """Return the whole page for what was chosen, or what keeps it from being made."""
        try:
            own = self._sittings.open(visitor, ask.episode, afresh=afresh)
            return self._chosen(visitor, ask, own, notice)
        except ReibenchError as problem:
            return Screen(act=trouble_panel(str(problem)))

    def _chosen(self, visitor: str, ask: Ask, own: Sitting, notice: str) -> Screen:
        setting = self.setting(ask)
        if ask.actor == "me":
            return person_screen(setting, own, notice=notice)
        model = self.model_of(ask)
        self._sittings.prepare(model)
        # recordings are for looking at; who watches a planner wants it to act
        watched = self._sittings.recorded(ask.episode) if ask.actor == "side" else {}
        watched |= self._sittings.watched(visitor, ask.episode)
        plain = watched.get(f"{ask.planner}+none/{model}")
        told = watched.get(f"{ask.planner}+{self.method_of(ask)}/{model}")
        if ask.actor == "side":
            return side_screen(setting, own.start, (plain, told), notice=notice)
        run = told if ask.actor == "tocc" else plain
        ready = self._sittings.model_ready(model)
        return model_screen(setting, ask.actor, own, run, ready=ready, notice=notice)

    def acted(self, visitor: str, ask: Ask, act: Callable[[], Sitting]) -> Screen:
        """Return the page after the visitor acted, and what was in the way if anything."""
        try:
            sitting, notice = act(), ""
        except StaleStep:
            sitting = self._sittings.find(ask.sitting, visitor)
            notice = f"This tab was behind. It now shows step {len(sitting.steps)}."
        except ReibenchError as problem:
            return self.whole(visitor, ask, notice=str(problem))
        solution = self._sittings.solution(sitting.episode.id) if ask.solution else ()
        return person_step(sitting, notice=notice, solution=solution)

    def watching(self, ask: Ask, watch: Iterator[Sitting]) -> Iterator[Screen]:
        """Yield what each thing a planner does changes."""
        setting, sitting, talk = self.setting(ask), None, None
        for sitting in watch:
            screen = model_step(setting, ask.actor, sitting, sitting, ready=True)
            # what somebody has unfolded in an unchanged dialogue stays unfolded
            yield screen if screen.talk != talk else replace(screen, talk=None)
            talk = screen.talk
        if sitting is not None:  # the model is loaded by now, which the bar should say
            yield Screen(bar=self.setting(ask, sitting).bar(sitting.start, ask.actor))

    def watching_both(self, ask: Ask, watches: Sequence[Iterator[Sitting]]) -> Iterator[Screen]:
        """Yield the comparison after each thing that one of two planners, in turn, does."""
        setting, sitting = self.setting(ask), None
        runs: list[Sitting | None] = [None, None]
        going = [0, 1]
        while going:
            for side in tuple(going):
                runs[side] = sitting = next(watches[side], None) or runs[side]
                if sitting is None or sitting.status is not None:
                    going.remove(side)
                yield Screen(stage=side_stage(setting, (runs[0], runs[1])))
        if sitting is not None:
            yield Screen(bar=self.setting(ask, sitting).bar(sitting.start, "side"))

    def row(self, ask: Ask, left: Sitting, right: Sitting) -> Screen:
        """Return the comparison with the rooms as they were at one row."""
        return Screen(stage=side_stage(self.setting(ask), (left, right), row=ask.row))

    def sheet(self, ask: Ask) -> Screen:
        """Return the shelf as it is now."""
        name = self.model_of(ask)
        sheet = shelf(
            models.overview(),
            chosen=name.split(":", 1)[-1],
            planner=ask.planner,
            method=self.method_of(ask),
            ready=self._sittings.model_ready(name),
            fetching=self.fetcher.states,
        )
        return Screen(sheet=sheet)

    def found(self, ask: Ask) -> Screen:
        """Return the episodes that fit what is looked for."""
        current = self._sittings.episode(ask.episode)
        wanted = Seek(ask.kind, ask.room, ask.level, ask.words)
        return Screen(found=found_list(self.catalogue, wanted, current))

    def setting(self, ask: Ask, sitting: Sitting | None = None) -> Setting:
        """Return what is the same on every screen of a choice; `sitting` tells a planner's pace."""
        episode = self._sittings.episode(ask.episode)
        status = self._status(self.model_of(ask), sitting)
        return Setting(
            self.catalogue, episode, status, ask.planner, self.method_of(ask), self._links
        )

    def _status(self, model: str, sitting: Sitting | None) -> ModelStatus:
        if not model:
            return ModelStatus("no model", "get one to watch it act", "warn")
        name = model.split(":", 1)[-1].split("/")[-1]
        if not self._sittings.model_ready(model):
            return ModelStatus(name, "loads when first asked", "warn")
        if sitting is None or not sitting.steps:
            return ModelStatus(name, "ready")
        # What the model took, not the clock: side by side, each planner waits for the other.
        pace = sum(step.decision.usage.seconds for step in sitting.steps) / len(sitting.steps)
        return ModelStatus(name, f"ready · {pace:.1f} s a step")

    def method_of(self, ask: Ask) -> str:
        """Return the method to use: the visitor's choice, if the model can do it."""
        return usable_method(ask.method, self.model_of(ask))

    def model_of(self, ask: Ask) -> str:
        """Return the model to ask: the server's own, else the visitor's choice from the shelf."""
        if self._model:
            return self._model
        present = [entry for entry in models.overview() if entry.present]
        chosen = [entry for entry in present if entry.model.name == ask.model] or [
            entry for entry in present if entry.default
        ]
        return f"llama-cpp:{chosen[0].model.name}" if chosen else ""
