"""What methods and planners made on their way, folded so that a long one is no burden."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

from reibench.artefact import Artefact, Kind
from reibench.planners import Closing
from reibench.planners.graph import graph_from_json
from reibench.rollout import Step
from reibench.skill import SKILLS
from reibench.view.graph_drawing import graph_drawing
from reibench.view.icons import mark
from reibench.view.markup import classes, element, text

PICTURED: tuple[Kind, ...] = ("graph", "plan", "memory", "pddl")
"""Kinds with a form of their own, in the order they stand in a panel."""
MARKS = {"done": ("cooked", ""), "now": ("on", "now"), "left": ("no", ""), "to do": ("", "due")}
"""How a line of a plan begins that says how far it is: its mark, its class."""


def artefacts_html(artefacts: Iterable[Artefact]) -> str:
    """Return `artefacts` in order: notes in plain sight, everything else folded."""
    return "".join(map(_artefact, artefacts))


def folded(title: str, content: str, *, class_: str = "") -> str:
    """Return `content` as it was written, behind its title."""
    return _behind(title, element("pre", text(content)), class_)


def made_panel(steps: Sequence[Step], closing: Closing | None = None) -> str:
    """Return the latest graph, plan, memory and PDDL of a planner; nothing if it made none."""
    made = latest(steps, closing)
    parts = [
        element("section", element("h3", text(each.title), class_="label"), pictured(each))
        for each in made
    ]
    if not parts:
        return ""
    return element("div", *parts, class_="made", tabindex="0", role="group", aria_label="Made")


def latest(steps: Sequence[Step], closing: Closing | None = None) -> list[Artefact]:
    """Return the last artefact of each kind that has a form, as it is after the last step."""
    found: dict[Kind, Artefact] = {}
    for step in steps:
        found |= {each.kind: settled(each, step) for each in step.decision.artefacts}
    if closing is not None:
        found |= {each.kind: each for each in closing.artefacts}
    return [found[kind] for kind in PICTURED if kind in found]


def settled(artefact: Artefact, step: Step) -> Artefact:
    """Return a graph with the outcome of the step it was made for; others as they are."""
    if artefact.kind != "graph":
        return artefact
    graph = graph_from_json(artefact.text, SKILLS)
    outcome = "done" if step.event.success else "failed"
    for node in graph.nodes:
        if node.state == "now":
            graph = graph.marked(node.id, "done" if outcome == "done" else "failed")
    return replace(artefact, text=graph.to_json())


def thoughts(step: Step, before: str = "") -> str:
    """Return everything that led to a step, folded: what was made on the way, and its prompt.

    Of the prompt, only what is new since the prompt `before` is written out.
    """
    made = [settled(each, step) for each in step.decision.artefacts]
    parts = artefacts_html(made)
    if step.decision.prompt:
        parts += folded("Prompt", _new(step.decision.prompt, before), class_="prompt")
    if not parts:
        return ""
    return element("details", element("summary", "Why"), parts, class_="thoughts")


def _new(prompt: str, before: str) -> str:
    """Return `prompt` from the line on where it begins to differ from the one before."""
    pairs = enumerate(zip(prompt, before, strict=False))
    common = next((at for at, (one, other) in pairs if one != other), len(before))
    line = prompt.rfind("\n", 0, common) + 1
    return f"… as before, then:\n{prompt[line:]}" if line else prompt


def pictured(artefact: Artefact) -> str:
    """Return an artefact in the form of its kind."""
    match artefact.kind:
        case "graph":
            return graph_drawing(graph_from_json(artefact.text, SKILLS))
        case "memory":
            return _table(artefact.text)
        case "plan":
            return _list(artefact.text)
        case _:
            return element("pre", text(artefact.text))


def _artefact(artefact: Artefact) -> str:
    if artefact.kind != "note":
        return _behind(artefact.title, pictured(artefact), artefact.kind)
    title = element("b", text(artefact.title))
    return element("p", title, " ", text(artefact.text), class_="artefact note small")


def _behind(title: str, content: str, class_: str) -> str:
    summary = element("summary", text(title))
    return element("details", summary, content, class_=f"artefact {class_}".strip())


def _table(entries: str) -> str:
    rows = []
    for line in entries.splitlines():
        heading, _, words = line.partition(": ")
        rows.append(
            element("tr", element("th", text(heading), scope="row"), element("td", text(words)))
        )
    return element("table", *rows, class_="memory")


def _list(plan: str) -> str:
    return element("ol", *map(_planned, plan.splitlines()), class_="planned")


def _planned(line: str) -> str:
    state, colon, words = line.partition(": ")
    if not colon or state not in MARKS:
        return element("li", element("span", text(line)))
    symbol, class_ = MARKS[state]
    sign = element("span", mark(symbol) if symbol else "", class_=classes("mk", no=symbol == "no"))
    said = element("span", f"{state}: ", class_="sr")
    return element("li", sign, said, element("span", text(words)), class_=class_)
