"""The chosen step of a case: the room, what changed, the goal over time, and what led to it."""

from reibench.cases.case import Case, Run
from reibench.cases.views.words import run_title
from reibench.methods import Instruction
from reibench.rollout import Step
from reibench.view.artefacts import artefacts_html, folded, settled
from reibench.view.changes import changes
from reibench.view.markup import classes, element, number, text
from reibench.view.plan import floor_plan
from reibench.view.plan_geometry import ASIDE
from reibench.view.plan_layout import arrange
from reibench.view.words import sentence

SHORT = {"person": "Person", "plain": "Plain", "told": "Method"}
RUNNERS_UP = 5


def step_panel(case: Case, row: int, lane: int) -> str:
    """Return what is to be seen at one row of one run."""
    run = case.runs[lane]
    done = case.reached(row, lane)
    step = run.steps[done - 1] if done else None
    return "".join(
        [
            _controls(case, row),
            _tabs(case, lane),
            _room(case, run, done),
            _told(run, step, done),
            goal_over_time(run, done),
            _runners_up(step),
            _prompt(run, step),
            _insides(step),
            _costs(run, step),
        ]
    )


def _controls(case: Case, row: int) -> str:
    total = len(case.rows)
    words = f"Row {row + 1} of {total}" if row >= 0 else f"Start · {total} rows"

    def button(what: str, sign: str, label: str, class_: str = "btn sm icon") -> str:
        return element(
            "button", sign, type="button", class_=class_, data_do=what, aria_label=label,
            title=label,
        )  # fmt: skip

    split = ""
    if case.split is not None:
        split = button("split", "≠", "To the first divergence (V)")
    return element(
        "div",
        button("back", "◀", "Row before (←)"),
        element("b", words, class_="grow num", id="where"),
        button("forward", "▶", "Next row (→)"),
        split,
        button("play", "Play", "Play (Space)", "btn sm play"),
        class_="row controls",
    )


def _tabs(case: Case, lane: int) -> str:
    if len(case.runs) < 2:
        return ""
    tabs = [
        element(
            "button",
            text(SHORT[run.lane]),
            type="button",
            role="tab",
            aria_selected="true" if place == lane else "false",
            title=f"{run_title(run)} ({place + 1})",
            data_tab=place,
        )
        for place, run in enumerate(case.runs)
    ]
    return element("div", *tabs, class_="seg sm", role="tablist", aria_label="Whose room")


def _room(case: Case, run: Run, done: int) -> str:
    scenes = run.scenes(done)
    if not scenes:
        return element("p", "The room could not be set up.", class_="muted")
    label = f"The room of {run_title(run)} after {done} steps"
    plan = floor_plan(
        scenes[-1], arrange(scenes, ASIDE), focus=case.episode.task.goal.objects, label=label
    )
    return element("div", plan, class_="pl")


def _told(run: Run, step: Step | None, done: int) -> str:
    if step is None:
        return element("p", "Nothing done yet.", class_="muted")
    scenes = run.scenes(done)
    refused = not step.event.success
    said = f"Refused. {sentence(step.event.message)}" if refused else ""
    changed = changes(scenes[-2], scenes[-1])
    return element(
        "p",
        element("b", text(f"{step.number}. {step.decision.skill.text}")),
        " ",
        element("span", text(said), class_="b") if said else "",
        " " if said else "",
        text("" if refused and changed == "Nothing changed." else changed),
        class_="changed",
    )


def goal_over_time(run: Run, done: int) -> str:
    """Return for each goal condition after which steps it holds, as a bar of ticks."""
    last = run.steps[-1].event.goals if run.steps else ()
    lines = []
    for condition in last:
        holds = [
            any(each.name == condition.name and each.holds for each in step.event.goals)
            for step in run.steps
        ]
        ticks = [
            element("i", class_=classes(y=held, now=place == done))
            for place, held in enumerate(holds, start=1)
        ]
        first = next((place for place, held in enumerate(holds, start=1) if held), None)
        if holds[-1]:
            # how long it has held without a break
            broken = max((n for n, held in enumerate(holds, start=1) if not held), default=0)
            words = f"true from step {broken + 1}"
        else:
            words = "never true" if first is None else "lost again"
        label = element("span", text(condition.text), class_="grow")
        lines.append(
            element(
                "li",
                element("div", label, element("span", words, class_="muted xs"), class_="row"),
                element("div", *ticks, class_="tr", aria_hidden="true"),
            )
        )
    return element("ul", *lines, class_="gt", aria_label="Goal conditions over the steps")


def _runners_up(step: Step | None) -> str:
    options = step.decision.alternatives if step else ()
    if step is None or not options:
        return ""
    rows = []
    for option in options[:RUNNERS_UP]:
        chosen = option.text.strip() == step.decision.skill.text
        width = f"width:{number(100 * option.probability)}%"
        rows += [
            element("b" if chosen else "span", text(option.text.strip())),
            element("span", element("i", style=width, class_=classes(on=chosen)), class_="b"),
            element("span", f"{option.probability:.2f}".removeprefix("0"), class_="num"),
        ]
    table = element("div", *rows, class_="pb")
    return element("details", element("summary", "Runners-up"), table, open=True)


def _prompt(run: Run, step: Step | None) -> str:
    if step is None or not step.decision.prompt:
        return _asked(run.record.instruction) if step is None else ""
    answer = step.decision.skill.text
    body = element("pre", text(step.decision.prompt)) + element(
        "p", element("b", "Answer: "), text(answer)
    )
    return element("details", element("summary", "Prompt and raw answer"), body)


def _asked(told: Instruction | None) -> str:
    if told is None or not told.prompt:
        return ""
    return folded("Asked of the model before planning", told.prompt) + folded(
        "Its raw answer", told.answer
    )


def _insides(step: Step | None) -> str:
    if step is None or not step.decision.artefacts:
        return ""
    return artefacts_html(settled(each, step) for each in step.decision.artefacts)


def _costs(run: Run, step: Step | None) -> str:
    told = run.record.instruction
    lines = []
    if step is not None:
        usage = step.decision.usage
        lines.append(f"This step: {step.seconds:.2f} s of thought")
        if usage.prompt_tokens:
            lines.append(
                f"{usage.prompt_tokens} tokens in ({usage.cached_tokens} of them kept from before),"
                f" {usage.completion_tokens} out, {usage.seconds:.2f} s in the model"
            )
    if told is not None and told.usage.prompt_tokens:
        lines.append(
            f"Restating, before the first step: {told.usage.prompt_tokens} tokens in,"
            f" {told.usage.completion_tokens} out, {told.usage.seconds:.2f} s"
        )
    total = sum(each.seconds for each in run.steps)
    lines.append(f"Whole run: {len(run.steps)} steps, {total:.1f} s of thought")
    body = element("ul", *(element("li", text(line)) for line in lines), class_="costs")
    return element("details", element("summary", "Tokens and seconds"), body)
