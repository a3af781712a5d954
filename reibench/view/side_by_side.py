"""One episode, two runs: rewritten instruction, steps aligned, rooms and verdicts beside them."""

from collections.abc import Sequence

from reibench.episode import Episode
from reibench.rollout import Step
from reibench.skill import Skill
from reibench.view.actor_panel import WAITING, record_of
from reibench.view.alignment import Row, align, first_difference
from reibench.view.dialogue import utterance_text
from reibench.view.guessing import revealed
from reibench.view.icons import mark
from reibench.view.markup import classes, element, text
from reibench.view.outcome import goal_conditions, verdict, verdict_box
from reibench.view.plan import floor_plan
from reibench.view.plan_geometry import ASIDE
from reibench.view.plan_layout import arrange
from reibench.view.rewrite import told_body, told_heading
from reibench.view.side_controls import comparison_bar, lead
from reibench.view.words import sentence
from reibench.watching import Sitting

SIGNS = {"same": "=", "differs": "≠", "left only": "+", "right only": "+"}


def side_by_side(
    episode: Episode,
    left: Sitting | None,
    right: Sitting | None,
    *,
    planner: str = "SayCan",
    method: str = "TOCC",
    row: int | None = None,
    notice: str = "",
) -> str:
    """Return the comparison of a run without and a run with `method`.

    Args:
        episode: what both were asked.
        left: the run without; None before it began.
        right: the run with.
        planner: what the page calls the planner.
        method: what the page calls the method.
        row: index of the aligned row whose rooms are shown; the last if None.
        notice: something that went wrong.
    """
    rows = align(_skills(left), _skills(right))
    at = len(rows) - 1 if row is None else max(0, min(row, len(rows) - 1))
    running = any(run is not None and run.status is None for run in (left, right))
    over = left is not None and right is not None and not running
    split = first_difference(rows) if left and right else None
    begun, recorded = left is not None, left is not None and left.recorded
    parts = [comparison_bar(episode, method, begun=begun, running=running, recorded=recorded)]
    if recorded:
        parts.append(lead(method))
    if notice:
        parts.append(element("p", text(notice), class_="notice bad", role="alert"))
    parts.append(_instructions(episode, right, method, begun=begun))
    parts.append(
        _stage(left, right, rows, split if over else None, at, (planner, f"{planner} + {method}"))
    )
    parts.append(_verdicts(left, right))
    if over:
        parts.append(revealed(episode))
    return element(
        "section",
        *parts,
        class_=classes("sbs", running=running, over=over, fresh=not begun),
        id="sbs",
        aria_label=f"Without and with {method}",
        data_row=at,
        data_rows=len(rows),
        data_split=-1 if split is None else split,
        data_left=left.id if left else "",
        data_right=right.id if right else "",
        data_running="true" if running else "false",
    )


def _skills(run: Sitting | None) -> list[Skill]:
    return [step.decision.skill for step in run.steps] if run else []


def _instructions(episode: Episode, right: Sitting | None, method: str, *, begun: bool) -> str:
    turns = len(episode.dialogue.context)
    said = element(
        "div",
        element("h2", f"Said after {_turns(turns)}" if turns else "Said", class_="label"),
        # before it began, an audience may still be guessing
        element("p", utterance_text(episode.dialogue.instruction, marked=begun)),
        class_="card show-re",
    )
    told = right.instruction if right else None
    if told is None:
        body = element("p", "Not done yet.", class_="muted")
    else:
        body = told_body(told, turns=turns)
    heading = element("h2", told_heading(told, method), class_="label")
    return element("div", said, element("div", heading, body, class_="card"), class_="instr")


def _turns(count: int) -> str:
    words = "one two three four five six seven eight nine".split()
    number = words[count - 1] if count <= len(words) else str(count)
    return f"{number} turn{'s' if count > 1 else ''} of dialogue"


def _stage(
    left: Sitting | None,
    right: Sitting | None,
    rows: Sequence[Row],
    split: int | None,
    at: int,
    titles: tuple[str, str],
) -> str:
    signs = [_sign(row, index == split) for index, row in enumerate(rows)]
    middle = element("div", *signs, class_="mid", aria_hidden="true")
    return element(
        "div",
        _picture(left, _reached(rows, at, "left")),
        _lane(titles[0], "plain", left, rows, split, at, "left"),
        middle,
        _lane(titles[1], "tocc", right, rows, split, at, "right"),
        _picture(right, _reached(rows, at, "right")),
        class_="stage",
    )


def _reached(rows: Sequence[Row], at: int, side: str) -> int:
    """Return how many steps of one run are done at row `at`."""
    indexes = [getattr(row, side) for row in rows[: at + 1]]
    return sum(index is not None for index in indexes)


def _sign(row: Row, divides: bool) -> str:
    if divides:
        return element("div", element("span", "first<br>difference"), class_="div")
    return element("div", SIGNS[row.kind], class_="ne" if row.kind == "differs" else "")


def _lane(
    title: str,
    colour: str,
    run: Sitting | None,
    rows: Sequence[Row],
    split: int | None,
    at: int,
    side: str,
) -> str:
    count = f"{len(run.steps)} steps" if run else ""
    heading = element(
        "h2",
        element("i", class_=f"key {colour}"),
        element("span", text(title), class_="words"),
        element("span", class_="grow"),
        element("span", count, class_="muted small num"),
    )
    cells = [
        _cell(run, getattr(row, side), row, index, divides=index == split, here=index == at)
        for index, row in enumerate(rows)
    ]
    if run is not None and run.status is None and run.phase in WAITING:
        pulse = element("span", class_="pulse", aria_hidden="true")
        cells.append(element("div", pulse, f"{WAITING[run.phase]} …", class_="ln waiting"))
    return element("section", heading, *cells, class_=f"lane {side}", aria_label=title)


def _cell(
    run: Sitting | None, index: int | None, row: Row, number: int, *, divides: bool, here: bool
) -> str:
    if run is None or index is None:
        return element("div", class_=classes("ln gap", here=here), data_row=number)
    step = run.steps[index]
    differs = row.kind == "differs"
    words = _underlined(step) if differs else text(step.decision.skill.text)
    refused = element("span", mark("no"), class_="mk no", title=step.event.message)
    tone = ("good" if run.status == "success" else "bad") if divides else ""
    return element(
        "div",
        element("span", str(step.number), class_="n"),
        element("span", words, class_="words"),
        "" if step.event.success else refused,
        class_=classes("ln", tone, same=row.kind == "same", here=here),
        data_row=number,
        title=step.event.message,
    )


def _underlined(step: Step) -> str:
    """Return a step's words with its object underlined, which is where two runs differ."""
    skill = step.decision.skill
    thing = skill.text.removeprefix(f"{skill.verb} ").split(" ", 1)[-1]
    return text(skill.text[: len(skill.text) - len(thing)]) + element("u", text(thing))


def _picture(run: Sitting | None, reached: int) -> str:
    if run is None:
        return element("div", class_="aside")
    events = [run.start, *(step.event for step in run.steps[:reached])]
    focus = run.episode.task.goal.objects
    plan = floor_plan(
        events[-1].scene, arrange([event.scene for event in events], ASIDE), focus=focus
    )
    figure = element(
        "figure",
        element("div", plan, class_="pl"),
        element("figcaption", _caption(run, reached)),
        class_="pic",
    )
    goals = goal_conditions(run.start, run.steps[:reached])
    return element("div", figure, goals, class_="aside")


def _caption(run: Sitting, reached: int) -> str:
    if reached == 0:
        return f"{element('b', 'Start.')} Nothing done yet."
    step = run.steps[reached - 1]
    ended = run.status is not None and reached == len(run.steps)
    label = "End." if ended else f"Step {step.number}."
    message = sentence(step.event.message or f"{step.decision.skill.text}: done")
    return f"{element('b', label)} {text(message)}"


def _verdicts(left: Sitting | None, right: Sitting | None) -> str:
    boxes = []
    for run in (left, right):
        if run is not None and run.status is not None:
            found = verdict(record_of(run), budget=run.max_steps)
            boxes.append(verdict_box(found, wide=True))
        else:
            boxes.append(element("div", class_="verdict none"))
    return element("div", *boxes, class_="verd") if any(boxes) else ""
