"""A case as a figure like those of papers: dialogue, rooms at the decisive steps, outcome.

The only home of typst, which sets the page and writes SVG and PDF.
"""

import json
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Literal

from reibench.cases.case import Case, Run
from reibench.cases.views.words import level_words, outcome_words, run_subtitle, run_title
from reibench.dialogue import Utterance
from reibench.explanation import explain
from reibench.verdict import error_kind
from reibench.view.choices import method_title
from reibench.view.dialogue import referent
from reibench.view.plan_geometry import ASIDE
from reibench.view.plan_layout import arrange
from reibench.view.plan_picture import plan_picture
from reibench.view.topbar import room_name

TEMPLATE = Path(__file__).parents[3] / "assets" / "figures" / "case.typ"
PICTURES = 4
"""Rooms in a row."""
Format = Literal["svg", "pdf", "png"]


def figure(case: Case, form: Format) -> bytes:
    """Return the figure of a case as a file of that format."""
    # importing it takes a while, and most cases are never printed
    import typst

    made: object = typst.compile(
        str(TEMPLATE),
        format=form,
        ppi=200.0,
        font_paths=[str(_fonts())],
        sys_inputs={"case": json.dumps(_told(case))},
    )
    assert isinstance(made, bytes)
    return made


def _fonts() -> Path:
    """Return where matplotlib keeps DejaVu Sans, which has every sign we need."""
    found = find_spec("matplotlib")
    assert found is not None
    assert found.origin
    return Path(found.origin).parent / "mpl-data" / "fonts" / "ttf"


def _told(case: Case) -> dict[str, Any]:
    """Return what the template needs of a case."""
    dialogue = case.episode.dialogue
    level = level_words(str(case.episode.vagueness))
    told = next((run for run in case.runs if run.lane == "told"), None)
    instruction = told.record.instruction if told else None
    rewritten = instruction is not None and instruction.rewritten
    return {
        "title": case.title,
        "about": f"{level} · {room_name(case.episode.task.setup.room)}",
        "dialogue": [
            {"who": turn.speaker, "words": list(_words(turn))} for turn in dialogue.context
        ],
        "instruction": list(_words(dialogue.instruction)),
        "told": instruction.text if instruction and rewritten else "",
        "told_by": method_title(told.method) if told else "",
        "runs": [_run(case, place, run) for place, run in enumerate(case.runs)],
    }


def _words(turn: Utterance) -> Iterator[dict[str, str]]:
    """Yield the words of a turn, those of vague expressions with what they stand for."""
    at = 0
    for one in sorted(turn.expressions, key=lambda each: each.start):
        if one.explicit or one.start < at:
            continue
        yield {"text": turn.text[at : one.start], "referent": ""}
        yield {"text": one.text, "referent": referent(one)}
        at = one.end
    yield {"text": turn.text[at:], "referent": ""}


def _run(case: Case, place: int, run: Run) -> dict[str, Any]:
    record = run.record
    kind = error_kind(record)
    return {
        "lane": run.lane,
        "title": run_title(run),
        "subtitle": run_subtitle(run),
        "solved": record.status == "success",
        "outcome": f"{outcome_words(record.status, kind and str(kind))}.",
        "why": explain(record),
        "pictures": [_picture(case, run, done) for done in _shown(case, place, run)],
    }


def _shown(case: Case, place: int, run: Run) -> list[int]:
    """Return after how many steps rooms are shown: where the runs part, between, at the end."""
    last = len(run.steps)
    first = case.reached(case.split, place) if case.split is not None else min(1, last)
    telling = [
        step.number
        for step in run.steps
        if step.number > first
        and (not step.event.success or str(step.decision.skill.verb) in ("pick up", "put down"))
    ]
    between = telling[:: max(1, len(telling) // max(PICTURES - 2, 1))]
    shown = list(dict.fromkeys([first, *between]))[: PICTURES - 1]
    return list(dict.fromkeys([*shown, last])) if run.record.start else []


def _picture(case: Case, run: Run, done: int) -> dict[str, Any]:
    scenes = run.scenes(done)
    step = run.steps[done - 1] if done else None
    focus = case.episode.task.goal.objects
    return {
        "svg": plan_picture(scenes[-1], arrange(scenes, ASIDE), focus=focus),
        "number": str(done) if done else "",
        "words": step.decision.skill.text if step else "start",
        "refused": step is not None and not step.event.success,
    }
