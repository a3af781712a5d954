"""Graphs of sub-tasks as drawings: layers from the top down, arrows, and how far each one is."""

from dataclasses import dataclass
from graphlib import TopologicalSorter

from reibench.planners.graph import Graph, Node
from reibench.view.markup import classes, element, text

WIDTH_OF_LETTER = 6.1
MARGIN = 3.0
HEIGHT = 25.0
GAP = 15.0
ASIDE = 12.0
"""Between two branches."""
SIGNS = {
    "pending": "",
    "now": "M-3-4l5 4-5 4",
    "done": "M-4 0l3 3.500 5.500-7",
    "failed": "M-3.500-3.500l7 7M3.500-3.500l-7 7",
}
WORDS = {"pending": "to do", "now": "being done", "done": "done", "failed": "failed"}


@dataclass(frozen=True)
class Layout:
    """Where sub-tasks stand: columns from the left, layers from the top."""

    places: dict[int, tuple[int, int]]
    """Column and layer by id."""
    width: float
    """Of one sub-task."""

    def top_of(self, node_id: int) -> tuple[float, float]:
        """Return the middle of a sub-task's upper edge."""
        column, layer = self.places[node_id]
        x = MARGIN + column * (self.width + ASIDE) + self.width / 2
        return x, MARGIN + layer * (HEIGHT + GAP)

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the whole drawing."""
        columns = 1 + max(column for column, _ in self.places.values())
        layers = 1 + max(layer for _, layer in self.places.values())
        width = columns * self.width + (columns - 1) * ASIDE
        return width + 2 * MARGIN, layers * HEIGHT + (layers - 1) * GAP + 2 * MARGIN


def graph_drawing(graph: Graph) -> str:
    """Return `graph` as a picture; what it shows is also in its label, for those who hear it."""
    if not graph.nodes:
        return element("p", "No sub-task is left.", class_="muted small")
    layout = arranged(graph)
    width, height = layout.size
    edges = [_edge(layout, node, one) for node in graph.nodes for one in node.after]
    return element(
        "svg",
        *edges,
        *(_node(layout, node) for node in graph.nodes),
        viewbox=f"0 0 {width:.0f} {height:.0f}",
        width=round(width),
        height=round(height),
        role="img",
        aria_label=spoken(graph),
        class_="graph",
    )


def spoken(graph: Graph) -> str:
    """Return `graph` in words."""
    said = [
        f"{node.id} {node.skill}, {WORDS[node.state]}"
        + (f", after {' and '.join(map(str, node.after))}" if node.after else "")
        for node in graph.nodes
    ]
    return f"Graph of {len(graph.nodes)} sub-tasks: {'; '.join(said)}."


def arranged(graph: Graph) -> Layout:
    """Place sub-tasks in layers, each right above what waits for it, branches side by side."""
    layers = _layers(graph)
    places: dict[int, tuple[int, int]] = {}
    for node in sorted(graph.nodes, key=lambda each: layers[each.id]):
        wanted = [places[one][0] for one in node.after]
        column = min(wanted, default=0)
        while (column, layers[node.id]) in places.values() or _passed(column, node, places, layers):
            column += 1
        places[node.id] = (column, layers[node.id])
    longest = max(len(node.skill.text) for node in graph.nodes)
    return Layout(places, longest * WIDTH_OF_LETTER + 46)


def _passed(
    column: int, node: Node, places: dict[int, tuple[int, int]], layers: dict[int, int]
) -> bool:
    """Whether a sub-task that begins a branch would stand on an arrow down that column."""
    if node.after:
        return False
    here = layers[node.id]
    return any(at == column and layer < here for at, layer in places.values())


def _layers(graph: Graph) -> dict[int, int]:
    """Return the layer of each sub-task: as late as what waits for it allows."""
    before = {node.id: node.after for node in graph.nodes}
    order = list(TopologicalSorter(before).static_order())
    depth: dict[int, int] = {}
    for each in order:
        depth[each] = 1 + max((depth[one] for one in before[each]), default=-1)
    for each in reversed(order):
        waiting = [depth[node.id] for node in graph.nodes if each in node.after]
        depth[each] = min(waiting, default=depth[each] + 1) - 1
    first = min(depth.values())
    return {each: layer - first for each, layer in depth.items()}


def _edge(layout: Layout, node: Node, before: int) -> str:
    (x0, y0), (x1, y1) = layout.top_of(before), layout.top_of(node.id)
    y0 += HEIGHT
    bend = max(GAP / 2, min(24.0, (y1 - y0) / 2))
    line = f"M{x0:.1f} {y0:.1f}C{x0:.1f} {y0 + bend:.1f} {x1:.1f} {y1 - bend:.1f} {x1:.1f} {y1:.1f}"
    head = f"M{x1:.1f} {y1:.1f}l-4-7h8z"
    added = before in node.added
    return element("path", d=line, class_=classes("edge", added=added)) + element(
        "path", d=head, class_="head"
    )


def _node(layout: Layout, node: Node) -> str:
    x, y = layout.top_of(node.id)
    left, middle = x - layout.width / 2, y + HEIGHT / 2
    box = element("rect", x=left, y=y, width=layout.width, height=HEIGHT, rx=7)
    number = element("text", str(node.id), x=left + 7, y=middle + 4, class_="id")
    words = element("text", text(node.skill), x=left + 24, y=middle + 4.2)
    place = f"translate({left + layout.width - 12:.1f} {middle:.1f})"
    sign = element("path", d=SIGNS[node.state], transform=place, class_="sign")
    drawn = sign if SIGNS[node.state] else ""
    return element("g", box, number, words, drawn, class_=f"node {node.state}")
