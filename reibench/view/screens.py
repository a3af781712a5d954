"""Whole screens of the demo: what stands in each part of the page."""

from collections.abc import Sequence
from dataclasses import dataclass

from reibench.episode import Episode
from reibench.methods import Instruction
from reibench.scene import Scene
from reibench.skill import SKILLS, Skill
from reibench.view.actor_panel import model_panel, person_panel
from reibench.view.cameras import camera_strip
from reibench.view.catalogue import Catalogue
from reibench.view.choices import method_title, planner_title
from reibench.view.dialogue import conversation
from reibench.view.guessing import guessing
from reibench.view.icons import sprite
from reibench.view.markup import element
from reibench.view.picker import picker
from reibench.view.rewrite import told_box
from reibench.view.room_panel import room_loading, room_panel
from reibench.view.side_by_side import side_by_side
from reibench.view.topbar import Actor, ModelStatus, topbar
from reibench.watching import Sitting
from reibench.worlds import Event


@dataclass(frozen=True)
class Screen:
    """The parts of the page; None leaves a part as it is."""

    bar: str | None = None
    talk: str | None = None
    room: str | None = None
    act: str | None = None
    stage: str | None = None
    sheet: str | None = None
    seek: str | None = None
    found: str | None = None


@dataclass(frozen=True)
class Setting:
    """What is the same on every screen of one visitor's choice."""

    catalogue: Catalogue
    episode: Episode
    model: ModelStatus
    planner: str
    method: str
    links: Sequence[tuple[str, str]]

    def bar(self, start: Event, actor: Actor) -> str:
        """Return the top of the page."""
        scene = start.scene
        method = method_title(self.method)
        return topbar(
            self.catalogue, self.episode, scene, actor, self.model, self.links, method=method
        )


def frame() -> str:
    """Return what is sent once: symbols, the live region, the way past the top of the page."""
    skip = element("a", "To the next action", href="#skill", class_="skip")
    live = element("div", id="live", class_="sr", aria_live="polite", role="status")
    title = element("h1", "REI-Bench demo", class_="sr")
    return skip + title + sprite() + live


def picker_panel() -> str:
    """Return the picker with all skills; it never changes."""
    header = element(
        "header",
        element("h2", "Next action"),
        element("span", class_="grow"),
        element("span", f"{len(SKILLS) + 1} skills", class_="xs muted num"),
    )
    return element("section", header, picker(SKILLS), aria_label="Next action")


def talk_panel(episode: Episode, told: Instruction | None = None, method: str = "") -> str:
    """Return what was said, and what a method made of it."""
    marks = element(
        "button",
        "Expressions <kbd>E</kbd>",
        type="button",
        class_="btn sm marks",
        data_do="marks",
        aria_pressed="true",
    )
    header = element("header", element("h2", "Dialogue"), element("span", class_="grow"), marks)
    turns = len(episode.dialogue.context)
    made = told_box(told, method, turns=turns) if told is not None and method else ""
    return element(
        "section",
        header,
        conversation(episode.dialogue),
        made,
        class_="talking",
        aria_label="Dialogue",
    )


def loading() -> Screen:
    """Return the page before anything is known of the visitor."""
    return Screen(room=room_loading())


def scenes_of(sitting: Sitting) -> list[Scene]:
    """Return the room at the start and after each step."""
    return [sitting.start.scene, *(step.event.scene for step in sitting.steps)]


def person_screen(
    setting: Setting, sitting: Sitting, *, notice: str = "", solution: Sequence[Skill] = ()
) -> Screen:
    """Return the page of a visitor who acts."""
    step = person_step(sitting, notice=notice, solution=solution)
    return Screen(
        bar=setting.bar(sitting.start, "me"),
        talk=talk_panel(sitting.episode),
        room=step.room,
        act=step.act,
        stage="",
    )


def person_step(sitting: Sitting, *, notice: str = "", solution: Sequence[Skill] = ()) -> Screen:
    """Return what a step of one's own changes."""
    return Screen(
        room=room_panel(
            scenes_of(sitting), live=sitting.status is None, cameras=camera_strip(sitting)
        ),
        act=person_panel(sitting, notice=notice, solution=solution),
    )


def planner_name(actor: Actor, planner: str, method: str) -> str:
    """Return what the page calls the planner that acts."""
    title = planner_title(planner)
    return f"{title} + {method_title(method)}" if actor == "tocc" else title


def model_screen(
    setting: Setting,
    actor: Actor,
    own: Sitting,
    run: Sitting | None,
    *,
    ready: bool,
    notice: str = "",
) -> Screen:
    """Return the page of a visitor who watches a planner, before, during or after its run."""
    step = model_step(setting, actor, own, run, ready=ready, notice=notice)
    return Screen(
        bar=setting.bar(own.start, actor), talk=step.talk, room=step.room, act=step.act, stage=""
    )


def model_step(
    setting: Setting,
    actor: Actor,
    own: Sitting,
    run: Sitting | None,
    *,
    ready: bool,
    notice: str = "",
) -> Screen:
    """Return what a planner's step changes."""
    method = method_title(setting.method) if actor == "tocc" else ""
    scenes = scenes_of(run) if run else [own.start.scene]
    cameras = camera_strip(run) if run else camera_strip(own, step=0)
    title = planner_name(actor, setting.planner, setting.method)
    panel = model_panel(title, setting.model.name, run, ready=ready, notice=notice)
    told = run.instruction if run else None
    return Screen(
        talk=talk_panel(setting.episode, told, method),
        room=room_panel(scenes, live=False, cameras=cameras),
        act=panel,
    )


def side_screen(
    setting: Setting,
    start: Event,
    runs: tuple[Sitting | None, Sitting | None],
    *,
    row: int | None = None,
    notice: str = "",
) -> Screen:
    """Return the comparison of two runs; before they begin, an audience may guess."""
    guess = guessing(setting.episode, start.scene) if runs[0] is None else ""
    return Screen(
        bar=setting.bar(start, "side"),
        stage=side_stage(setting, runs, row=row, notice=notice) + guess,
    )


def side_stage(
    setting: Setting,
    runs: tuple[Sitting | None, Sitting | None],
    *,
    row: int | None = None,
    notice: str = "",
) -> str:
    """Return the comparison alone."""
    method, planner = method_title(setting.method), planner_title(setting.planner)
    return side_by_side(
        setting.episode, *runs, planner=planner, method=method, row=row, notice=notice
    )
