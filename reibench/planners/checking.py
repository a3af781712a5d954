"""Whether a graph of sub-tasks can work, and the dependencies it leaves out."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from reibench.planners.attempts import Attempt, Setback
from reibench.planners.graph import Graph, Node, UnusableGraph, latest, leads
from reibench.skill import Skill, Verb, in_words

SWITCHED = (Verb.OPEN, Verb.CLOSE, Verb.TURN_ON, Verb.TURN_OFF)
SHUT = re.compile(r"^(?:.* in )?the ([\w ]+?)(?:, which)? is closed$")
KNIVES = ("Knife", "ButterKnife")


def check_conditions(graph: Graph, setback: Setback, absent: Sequence[str] = ()) -> None:
    """Go through `graph` in its order, from the situation after `setback`.

    Raises:
        UnusableGraph: for a sub-task that would find the hand empty, or full, or the thing not
            found yet, for what was said to be closed and is not opened, and for what was said to
            be `absent`.
    """
    wanted = [in_words(skill.object) for skill in graph.skills("pending")]
    problems = [
        f"There is no {name} in this room; what is meant must be called otherwise."
        for name in absent
        if name in wanted
    ]
    problems += _not_opened(graph, setback.failed)
    done, before = list(setback.done), None
    while node := graph.next():
        problem = _unmet(node.skill, done)
        if node.skill.verb is Verb.FIND and node.skill == before:
            problem = "the robot is there already"
        if problem:
            problems.append(f"Sub-task {node.id}, {node.skill}, cannot work: {problem}.")
            break
        done.append(node.skill)
        before = node.skill
        graph = graph.marked(node.id, "done")
    if problems:
        raise UnusableGraph(" ".join(problems))


def _not_opened(graph: Graph, failed: Attempt) -> Iterator[str]:
    """Yield what was said to be closed and is not opened, if anything."""
    shut = SHUT.search(failed.failure)
    if shut and graph.nodes and f"open the {shut[1]}" not in map(str, graph.skills("pending")):
        yield f"The {shut[1]} is closed; it has to open the {shut[1]} first."


def situation_after(done: Sequence[Skill]) -> str:
    """Return in words what the robot holds and where it is after skills that worked."""
    held = holding(done)
    at = next((each.object for each in reversed(done) if each.verb is Verb.FIND), "")
    place = f"is at the {in_words(at)}" if at else "has gone nowhere yet"
    return f"the robot {place} and holds {f'the {in_words(held)}' if held else 'nothing'}"


def _unmet(skill: Skill, done: Sequence[Skill]) -> str:
    """Return what `skill` would lack after the skills `done`; empty if nothing is known."""
    thing, held = in_words(skill.object), holding(done)
    if skill.verb is Verb.PUT_DOWN and held and held != skill.object:
        return f"the robot holds the {in_words(held)} then; it has to put down that"
    if skill.verb is Verb.PUT_DOWN and not held:
        return (
            f"the robot does not hold the {thing} then; it has to find the {thing} and pick up the"
            f" {thing} before"
        )
    if skill.verb is Verb.PICK_UP and held:
        return (
            f"the robot holds the {in_words(held)} then; it has to put down the"
            f" {in_words(held)} before"
        )
    if skill.verb is Verb.PICK_UP and skill.object not in {each.object for each in done}:
        return f"the robot is not near the {thing} then; it has to find the {thing} before"
    if skill.verb is Verb.SLICE and held not in KNIVES:
        return "the robot holds no knife then; it has to find a knife and pick it up before"
    return ""


def holding(done: Sequence[Skill]) -> str:
    """Return the type of what the robot holds after skills that worked; empty for nothing."""
    for skill in reversed(done):
        if skill.verb is Verb.PUT_DOWN:
            return ""
        if skill.verb is Verb.PICK_UP:
            return skill.object
    return ""


def mended(graph: Graph) -> Graph:
    """Return `graph` with the dependencies that the skills themselves imply and it leaves out.

    A thing is used after the robot went to it, put down after it was picked up, and a door or
    switch is used after what was done with it before.
    """
    after = {node.id: list(node.after) for node in graph.nodes}
    added: dict[int, list[int]] = {node.id: [] for node in graph.nodes}
    for at, node in enumerate(graph.nodes):
        for needed in _implied(node.skill, graph.nodes[:at]):
            if not leads(needed.id, node.id, after) and not leads(node.id, needed.id, after):
                after[node.id].append(needed.id)
                added[node.id].append(needed.id)
    return Graph(
        tuple(
            replace(node, after=tuple(after[node.id]), added=tuple(added[node.id]))
            for node in graph.nodes
        )
    )


def _implied(skill: Skill, before: Sequence[Node]) -> Iterator[Node]:
    """Yield the latest of the sub-tasks written `before` that `skill` needs, by each rule."""
    if skill.verb is not Verb.FIND:
        yield from latest(before, (Verb.FIND,), "")
    if skill.verb is Verb.PUT_DOWN:
        yield from latest(before, (Verb.PICK_UP,), skill.object)
    if skill.verb in SWITCHED:
        yield from latest(before, SWITCHED, skill.object)
