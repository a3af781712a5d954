"""One case: what was said, what was made of it, and the runs beside each other."""

from collections.abc import Sequence

from reibench.cases.case import Case, Run
from reibench.cases.views.case_step import step_panel
from reibench.cases.views.words import level_words, outcome_words, run_subtitle, run_title
from reibench.explanation import explain
from reibench.rollout import Step
from reibench.verdict import error_kind
from reibench.view.alignment import Places
from reibench.view.choices import method_title
from reibench.view.dialogue import conversation, utterance_text
from reibench.view.icons import mark
from reibench.view.markup import classes, element, text
from reibench.view.plan import floor_plan
from reibench.view.plan_geometry import ASIDE
from reibench.view.plan_layout import arrange
from reibench.view.rewrite import told_body, told_heading
from reibench.view.topbar import room_name


def case_view(
    case: Case, *, row: int, lane: int, buttons: Sequence[str] = (), kept: str = ""
) -> str:
    """Return the whole case as it is at one row of one run.

    Args:
        case: the case.
        row: index of the row; -1 for the start.
        lane: index of the run whose room is shown.
        buttons: what can be done with the case, as markup.
        kept: tags and note, as markup.
    """
    body = element(
        "div",
        element("div", lanes(case, row=row, lane=lane), strip(case), class_="main"),
        element(
            "aside", step_panel(case, row, lane), class_="side", id="at",
            aria_label="The chosen step",
        ),
        class_="casebody",
    )  # fmt: skip
    return element(
        "article",
        _title(case, buttons),
        kept,
        instructions(case),
        body,
        class_="detail",
        id="case",
        aria_label=case.title,
        data_case=case.episode.id,
        data_runs=",".join(run.id for run in case.runs),
        data_rows=len(case.rows),
        data_lanes=len(case.runs),
        data_row=row,
        data_lane=lane,
        data_split=-1 if case.split is None else case.split,
    )


def _title(case: Case, buttons: Sequence[str]) -> str:
    """Return the goal in one line, its level and room, and what can be done with the case."""
    level = level_words(str(case.episode.vagueness))
    room = room_name(case.episode.task.setup.room)
    chips = (element("span", text(words), class_="chip") for words in (level, room))
    space = element("span", class_="grow")
    return element("div", element("h1", text(case.title)), *chips, space, *buttons, class_="dh")


def instructions(case: Case) -> str:
    """Return what was said, and what the method made of it if there is a run with one."""
    dialogue = case.episode.dialogue
    turns = len(dialogue.context)
    parts = [element("p", utterance_text(dialogue.instruction), class_="show-re")]
    if turns:
        words = f"Dialogue before it, {turns} turn{'s' if turns > 1 else ''}"
        said = element("div", conversation(dialogue), class_="show-re")
        parts.append(element("details", element("summary", words), said, class_="before"))
    boxes = [element("div", element("h2", "Original instruction", class_="label"), *parts)]
    told = next((run for run in case.runs if run.lane == "told"), None)
    if told is not None:
        instruction = told.record.instruction
        if instruction is None:
            body, heading = element("p", "It was not begun.", class_="muted"), "Instruction"
        else:
            body = told_body(instruction, turns=turns)
            heading = told_heading(instruction, method_title(told.method))
        boxes.append(element("div", element("h2", heading, class_="label"), body))
    return element("div", *boxes, class_=classes("ins", single=len(boxes) == 1))


def lanes(case: Case, *, row: int, lane: int) -> str:
    """Return the runs' steps in columns, aligned, with the first divergence marked."""
    number = len(case.runs)
    parts = [_heading(run, place) for place, run in enumerate(case.runs)]
    parts += [_verdict(run) for run in case.runs]
    for index, places in enumerate(case.rows):
        if index == case.split:
            parts.append(element("div", "first divergence", class_="divl"))
        parts += [
            _cell(case, index, places, place, chosen=index == row, front=place == lane)
            for place in range(number)
        ]
    if not case.rows:
        parts.append(element("p", "No step was taken.", class_="muted wholerow"))
    return element("div", *parts, class_=f"lanes n{number}", id="lanes")


def _heading(run: Run, place: int) -> str:
    return element(
        "h2",
        element("i", class_=f"key {'tocc' if run.lane == 'told' else run.lane}"),
        element("span", text(run_title(run)), class_="words"),
        element("small", text(run_subtitle(run)), class_="muted"),
        data_lane=place,
    )


def _verdict(run: Run) -> str:
    record = run.record
    good = record.status == "success"
    kind = error_kind(record)
    title = element(
        "b", text(outcome_words(record.status, kind and str(kind))), class_="g" if good else "b"
    )
    number = f"{len(run.steps)} step{'' if len(run.steps) == 1 else 's'}"
    refused = sum(not step.event.success for step in run.steps)
    if good:
        tail = {0: ".", 1: ", one refused."}.get(refused, f", {refused} refused.")
        unsaid = "" if record.said_done else " Nobody said that it was done."
        return element("p", title, text(f" in {number}{tail}{unsaid}"), class_="vd")
    return element("p", title, ". ", text(explain(record)), class_="vd")


def _cell(case: Case, index: int, places: Places, place: int, *, chosen: bool, front: bool) -> str:
    at = places[place]
    if at is None:
        return element(
            "div", class_=classes("ln gap", cur=chosen and front), data_row=index, data_lane=place
        )
    step: Step = case.runs[place].steps[at]
    refused = element("span", mark("no"), class_="mk no") if not step.event.success else ""
    said = "" if step.event.success else element("span", "refused", class_="sr")
    parted = index == case.split
    return element(
        "button",
        element("span", str(step.number), class_="n"),
        element("span", text(step.decision.skill.text), class_="t"),
        refused,
        said,
        type="button",
        class_=classes(
            "ln", f=not step.event.success, cur=chosen and front, row=chosen,
            x=parted and case.runs[place].record.status != "success",
            o=parted and case.runs[place].record.status == "success",
        ),
        data_row=index,
        data_lane=place,
        tabindex=-1,
        title=step.event.message or None,
    )  # fmt: skip


def strip(case: Case) -> str:
    """Return small pictures of the steps that tell the story, to be jumped to."""
    figures = []
    for lane, done in case.decisive():
        run = case.runs[lane]
        scenes = run.scenes(done)
        ended = done == len(run.steps)
        words = f"{run_title(run)}, {'end' if ended else done}"
        plan = floor_plan(
            scenes[-1], arrange(scenes, ASIDE), focus=case.episode.task.goal.objects, label=words
        )
        figures.append(
            element(
                "button",
                plan,
                element("span", text(words), class_="cap"),
                type="button",
                class_="thumb",
                data_row=case.row_of(lane, done),
                data_lane=lane,
            )
        )
    return element("div", *figures, class_="strip", role="group", aria_label="Decisive steps")
