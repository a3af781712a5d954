"""Graphs of sub-tasks: how they are written, read and carried out."""

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from graphlib import CycleError, TopologicalSorter
from typing import Literal

from reibench.errors import ReibenchError
from reibench.skill import OBJECTS_OF, Skill, Verb

State = Literal["pending", "now", "done", "failed"]

LINE = re.compile(r"^\W*(\d{1,6})\s*[.:)\]\-]*\s*(\D.*)$")
MOST_NODES = 30
"""Sub-tasks a graph may have: the step budget."""


class UnusableGraph(ReibenchError):
    """A graph that cannot be carried out; its text is what the model is told."""


@dataclass(frozen=True)
class Node:
    """One sub-task."""

    id: int
    skill: Skill
    after: tuple[int, ...] = ()
    """Ids of the sub-tasks that must be done before."""
    added: tuple[int, ...] = ()
    """Those of `after` that the model had left out."""
    state: State = "pending"


@dataclass(frozen=True)
class Graph:
    """Sub-tasks in the order they were written."""

    nodes: tuple[Node, ...]

    def next(self) -> Node | None:
        """Return the first sub-task written that waits for nothing: a stable dependency order."""
        done = {node.id for node in self.nodes if node.state == "done"}
        waiting = (node for node in self.nodes if node.state == "pending")
        return next((node for node in waiting if done.issuperset(node.after)), None)

    def marked(self, node_id: int, state: State) -> "Graph":
        """Return the graph with one sub-task in another state."""
        return Graph(
            tuple(replace(node, state=state) if node.id == node_id else node for node in self.nodes)
        )

    def skills(self, *states: State) -> tuple[Skill, ...]:
        """Return the skills of the sub-tasks in any of `states`, as written."""
        return tuple(node.skill for node in self.nodes if node.state in states)

    def written(self) -> str:
        """Return the graph as models write it, one sub-task a line."""
        return "".join(f"{_line(node)}\n" for node in self.nodes)

    def to_json(self) -> str:
        """Return the graph as an artefact keeps it."""
        nodes = [
            {
                "id": node.id,
                "skill": node.skill.text,
                "after": node.after,
                "added": node.added,
                "state": node.state,
            }
            for node in self.nodes
        ]
        return json.dumps({"nodes": nodes})


def _line(node: Node) -> str:
    after = f" after {', '.join(map(str, node.after))}" if node.after else ""
    return f"{node.id}: {node.skill}{after}"


def graph_from_json(text: str, skills: Sequence[Skill]) -> Graph:
    """Return the graph an artefact keeps."""
    by_text = {skill.text: skill for skill in skills}
    return Graph(
        tuple(
            Node(
                node["id"],
                by_text[node["skill"]],
                tuple(node["after"]),
                tuple(node["added"]),
                node["state"],
            )
            for node in json.loads(text)["nodes"]
        )
    )


def read_graph(answer: str, skills: Sequence[Skill]) -> Graph:
    """Return the graph in a model's answer, without sub-tasks if it has none.

    Lines that are no sub-tasks are passed over.

    Raises:
        UnusableGraph: for unknown skills or ids, ids used twice, cycles.
    """
    lines = [found for line in answer.splitlines() if (found := LINE.match(line.strip()))]
    if len(lines) > MOST_NODES:
        raise UnusableGraph(f"There are {len(lines)} sub-tasks, at most {MOST_NODES} can be done.")
    known = {_bare(skill.text): skill for skill in skills}
    graph = Graph(tuple(_node(int(found[1]), found[2], known) for found in lines))
    _check_ids(graph)
    _check_cycles(graph)
    return graph


def _bare(text: str) -> str:
    return re.sub(r"\b(?:an?|the)\s+", "", " ".join(text.lower().split()))


def _node(node_id: int, text: str, known: dict[str, Skill]) -> Node:
    words, _, after = text.partition("after")
    words = words.strip(" ,;.(:")
    skill = known.get(_bare(words))
    if skill is None:
        near = get_close_matches(_bare(words), known, n=1)
        hint = f"; did you mean {known[near[0]].text!r}?" if near else "."
        raise UnusableGraph(f"Sub-task {node_id}, {words!r}, is nothing the robot can do{hint}")
    before = dict.fromkeys(map(int, re.findall(r"\d{1,6}", after)))
    before.pop(node_id, None)  # after itself: means nothing, and small models write it often
    return Node(node_id, skill, tuple(before))


def _check_ids(graph: Graph) -> None:
    ids = [node.id for node in graph.nodes]
    for node in graph.nodes:
        if ids.count(node.id) > 1:
            raise UnusableGraph(f"Two sub-tasks have the number {node.id}.")
        unknown = [each for each in node.after if each not in ids]
        if unknown:
            raise UnusableGraph(
                f"Sub-task {node.id} is after {unknown[0]}, but there is no sub-task {unknown[0]}."
            )


def _check_cycles(graph: Graph) -> None:
    try:
        TopologicalSorter({node.id: node.after for node in graph.nodes}).prepare()
    except CycleError as error:
        cycle = " → ".join(map(str, error.args[1]))
        raise UnusableGraph(f"Sub-tasks wait for each other in a circle: {cycle}.") from None


def graph_of(skills: Sequence[Skill]) -> Graph:
    """Return an example plan as a graph: what it does at a place is a chain.

    A trip that only prepares a device (opens it, turns it on) waits for nothing; every other one
    waits for the step before it, as the robot carries something or needs its hand free.
    """
    nodes: list[Node] = []
    for number, skill in enumerate(skills, 1):
        after = [number - 1] if nodes and not _prepares(skills[number - 1 : number + 1]) else []
        chain = {node.id: list(node.after) for node in nodes}
        held = latest(nodes, (Verb.PICK_UP,), skill.object)
        for each in held if skill.verb is Verb.PUT_DOWN else ():
            if each.id not in after and not leads(each.id, number - 1, chain):
                after.insert(0, each.id)
        nodes.append(Node(number, skill, tuple(after)))
    return Graph(tuple(nodes))


def _prepares(trip: Sequence[Skill]) -> bool:
    goes = trip[0].verb is Verb.FIND
    return goes and len(trip) > 1 and trip[1].verb in (Verb.OPEN, Verb.TURN_ON)


def latest(before: Sequence[Node], verbs: Sequence[Verb], name: str) -> Iterator[Node]:
    """Yield the last of `before` with one of `verbs`, on `name` unless that is empty."""
    for node in reversed(before):
        if node.skill.verb in verbs and node.skill.object == (name or node.skill.object):
            yield node
            return


def leads(first: int, last: int, after: Mapping[int, Sequence[int]]) -> bool:
    """Whether `last` waits for `first`, directly or through others."""
    waiting, seen = [last], {last}
    while waiting:
        for each in after[waiting.pop()]:
            if each == first:
                return True
            if each not in seen:
                seen.add(each)
                waiting.append(each)
    return False


def grammar(skills: Sequence[Skill], *, least: int = 1) -> str:
    """Return a GBNF grammar of graphs with at least so many sub-tasks, ended by `done`."""
    kinds = []
    for verb in OBJECTS_OF:
        names = [skill.text.removeprefix(f"{verb} ") for skill in skills if skill.verb is verb]
        if names:
            options = " | ".join(json.dumps(name) for name in names)
            kinds.append(f'"{verb} " ({options})')
    return "\n".join(
        (
            f'root ::= line{{{least},{MOST_NODES}}} "done"',
            'line ::= id ": " skill (" after " id (", " id){0,3})? "\\n"',
            "id ::= [1-9] [0-9]?",
            f"skill ::= {' | '.join(kinds)}",
        )
    )
