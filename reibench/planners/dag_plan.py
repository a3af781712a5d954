"""DAG-Plan (Gao et al. 2024) as appendix A.1 describes it: a graph of sub-tasks in one answer.

The graph is checked, carried out in dependency order, and written anew when a sub-task fails. Its
own code has not been published; this follows the paper's idea with one robot instead of two arms.
"""

from collections.abc import Generator, Sequence
from typing import Literal

from reibench.artefact import Artefact
from reibench.backends import Backend, Prompt
from reibench.methods import Instruction
from reibench.planners import Decision, Plan, planners
from reibench.planners.attempts import (
    OUTSET,
    Attempt,
    Setback,
    attempts,
    foreseen,
    setbacks,
    with_shut_place,
)
from reibench.planners.checking import check_conditions, mended, situation_after
from reibench.planners.examples import Example, fixed_set, nearest
from reibench.planners.graph import Graph, UnusableGraph, grammar, graph_of, read_graph
from reibench.planners.memory import said_absent
from reibench.planners.notebook import Notebook
from reibench.planners.telling import PENDING, told
from reibench.skill import DONE, Skill
from reibench.worlds import Event

HEADER = """\
A robot works in a home. A human asks it for something, and it writes the graph of sub-tasks that \
does it: one sub-task a line, with a number, and the numbers of those it has to come after. It \
goes to a thing with "find" before it uses it, and has one hand. If a sub-task failed, it writes \
the graph of what remains, with what was missing first. The graph ends with "done".
"""
GRAPH = "Graph:\n"
REMAINING = "Graph of what remains:\n"
STOPS = (DONE, "Human", "\n\n")
ASKED_AGAIN = 2
"""How often the model is told what is wrong with its graph, and asked again."""
REPLANNED = 6
"""How often the graph of what remains is written after a failure."""
LONGEST = 480
"""Tokens of a graph: thirty sub-tasks."""


@planners.register("dag-plan")
class DagPlan:
    """Write the whole plan as a graph, carry it out, and write what remains when it fails."""

    title = "DAG-Plan"
    summary = "a graph of sub-tasks, written at once, and again after a failure"

    def __init__(
        self, backend: Backend, *, examples: Literal["nearest", "fixed"] = "nearest"
    ) -> None:
        """Prepare the prompt; `examples` as in `SayCan`."""
        self._backend = backend
        self._examples = examples

    def plan(self, instruction: Instruction, start: Event, skills: tuple[Skill, ...]) -> Plan:
        """Yield the sub-tasks of one graph after another; reads no scene."""
        shown = nearest(instruction.text) if self._examples == "nearest" else fixed_set()
        notebook = Notebook(self._backend)
        writer = GraphWriter(notebook, introduction(shown), told(instruction), skills)
        done: list[Skill] = []
        graph = writer.first()
        for _ in range(REPLANNED):
            graph, failure = yield from _carried_out(graph, done, notebook)
            if failure is None:
                return notebook.closing(*_shown(graph))
            expected = graph.skills("failed", "pending")
            graph = writer.remaining(Setback(tuple(done), failure, expected))
        graph, failure = yield from _carried_out(graph, done, notebook)
        if failure is not None:
            notebook.note("Given up", f"{REPLANNED} graphs of what remained were tried.")
        return notebook.closing(*_shown(graph))


def _carried_out(
    graph: Graph, done: list[Skill], notebook: Notebook
) -> Generator[Decision, Event, tuple[Graph, Attempt | None]]:
    """Yield the sub-tasks in dependency order, up to one that fails; add to `done`."""
    while node := graph.next():
        event = yield notebook.decision(node.skill, *_shown(graph.marked(node.id, "now")))
        graph = graph.marked(node.id, "done" if event.success else "failed")
        if not event.success:
            return graph, Attempt(node.skill, event.message)
        done.append(node.skill)
    return graph, None


def _shown(graph: Graph) -> tuple[Artefact, ...]:
    return (Artefact("graph", "Graph of sub-tasks", graph.to_json()),) if graph.nodes else ()


class GraphWriter:
    """Lets the model write graphs, and tells it what is wrong with them."""

    def __init__(
        self, notebook: Notebook, prefix: str, task: str, skills: tuple[Skill, ...]
    ) -> None:
        self._notebook = notebook
        self._prefix = prefix
        self._task = task
        self._skills = skills
        self._absent: list[str] = []

    def first(self) -> Graph:
        """Return the graph for the whole task; without sub-tasks if the model fails to write it."""
        return self._written(None)

    def remaining(self, setback: Setback) -> Graph:
        """Return the graph of what remains after a failure, which may be nothing."""
        self._absent += said_absent(setback.failed.failure)
        return self._written(setback)

    def _written(self, setback: Setback | None) -> Graph:
        situation, heading = (told_of(setback), REMAINING) if setback else ("", GRAPH)
        minded, doubtful = "", Graph(())
        allowed = grammar(self._skills, least=0 if setback else 1)
        for _ in range(ASKED_AGAIN + 1):
            text = f"{self._prefix}{self._task}{situation}{minded}{heading}"
            prompt = Prompt(text, fixed=len(self._prefix))
            answer = self._notebook.generate(
                prompt, "Graph as written", most=LONGEST, stop=STOPS, grammar=allowed
            )
            try:
                doubtful = self._read(answer, setback)
                check_conditions(doubtful, setback or OUTSET, self._absent)
            except UnusableGraph as problem:
                self._notebook.note("Graph refused", str(problem))
                minded += complaint(problem)
            else:
                return doubtful
        refused = f"{ASKED_AGAIN + 1} graphs in a row were refused"
        if doubtful.nodes:
            self._notebook.note("Tried all the same", f"{refused}; the room may tell why.")
        else:
            self._notebook.note("Given up", f"{refused}.")
        return doubtful

    def _read(self, answer: str, setback: Setback | None) -> Graph:
        graph = read_graph(answer, self._skills)
        if not graph.nodes and not setback:
            raise UnusableGraph("There is no sub-task; they read like '1: find a mug'.")
        whole = mended(graph)
        for node in whole.nodes:
            if node.added:
                after = ", ".join(map(str, node.added))
                self._notebook.note("Graph mended", f"{node.id} has to come after {after}.")
        return whole


def told_of(setback: Setback) -> str:
    """Return what the model is told after a failure."""
    done = ", ".join(skill.text for skill in setback.done) or "nothing"
    expected = ", ".join(skill.text for skill in setback.expected)
    failed = setback.failed
    return (
        f"Done: {done}\nFailed: {failed.skill} ({failed.failure})\nPlanned: {expected}\n"
        f"Now: {situation_after(setback.done)}\n"
    )


def complaint(problem: UnusableGraph) -> str:
    """Return what stands before the question when it is asked again."""
    return f"Mind: {problem}\n"


def introduction(examples: Sequence[Example]) -> str:
    """Return what the prompt begins with, the same for every instruction of a kind."""
    shown = with_shut_place(examples)
    solved = (_solved(one, minding=number % 2 == 1) for number, one in enumerate(shown))
    return "\n".join((HEADER, *solved, ""))


def _solved(example: Example, *, minding: bool) -> str:
    """Return an example as the model meets it, after a complaint if `minding`."""
    tried = attempts(example)
    task = f"{PENDING}{example.instruction}\n"
    graph = graph_of(foreseen(tried))
    text = f"{task}{_minded(graph) if minding else ''}{GRAPH}{graph.written()}{DONE}\n"
    for setback, remaining in setbacks(tried):
        graph = graph_of(remaining)
        text += f"\n{task}{told_of(setback)}{REMAINING}{graph.written()}{DONE}\n"
    return text


def _minded(graph: Graph) -> str:
    """Return the complaint about a graph that forgets how its first thing gets into the hand."""
    try:
        check_conditions(graph_of(graph.skills("pending")[2:]), OUTSET)
    except UnusableGraph as problem:
        return complaint(problem)
    return ""
