"""Whether a graph of sub-tasks can work, and the dependencies it leaves out."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from reibench.planners.graph import Graph, Node, UnusableGraph, latest, leads
from reibench.skill import Skill, Verb, in_words

SWITCHED = (Verb.OPEN, Verb.CLOSE, Verb.TURN_ON, Verb.TURN_OFF)
KNIVES = ("Knife", "ButterKnife")


def holding(done: Sequence[Skill]) -> str:
    """Return the type of what the robot holds after skills that worked; empty for nothing."""
    for skill in reversed(done):
        if skill.verb is Verb.PUT_DOWN:
            return ""
        if skill.verb is Verb.PICK_UP:
            return skill.object
    return ""


def check_hand(graph: Graph, held: str) -> None:
    """Go through `graph` in its order, with `held` in the hand at first.

    Raises:
        UnusableGraph: for a sub-task that would find the hand empty, or full.
    """
    while node := graph.next():
        thing, verb = in_words(node.skill.object), node.skill.verb
        if verb is Verb.PUT_DOWN and held != node.skill.object:
            raise UnusableGraph(
                f"Sub-task {node.id} puts down the {thing}, but the robot does not hold it then;"
                f" it has to find the {thing} and pick up the {thing} before."
            )
        if verb is Verb.PICK_UP and held:
            raise UnusableGraph(
                f"Sub-task {node.id} picks up the {thing}, but the robot holds the"
                f" {in_words(held)} then; it has to put down the {in_words(held)} before."
            )
        if verb is Verb.SLICE and held not in KNIVES:
            raise UnusableGraph(
                f"Sub-task {node.id} slices the {thing}, but the robot holds no knife then;"
                " it has to find a knife and pick up the knife before."
            )
        held = holding((Skill(Verb.PICK_UP, held),) * bool(held) + (node.skill,))
        graph = graph.marked(node.id, "done")


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
