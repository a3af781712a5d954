"""What planners made is drawn: graphs with their states, memories as tables, plans as lists."""

from dataclasses import replace

import pytest

from reibench.artefact import Artefact
from reibench.planners import Closing
from reibench.planners.graph import graph_of, read_graph
from reibench.skill import SKILLS, parse_skill
from reibench.view.artefacts import made_panel, thoughts
from reibench.view.graph_drawing import arranged, graph_drawing

WHOLE = read_graph(
    "1: find an apple\n2: pick up the apple after 1\n3: find a fridge\n"
    "4: open the fridge after 3\n5: put down the apple after 2, 4\n",
    SKILLS,
)


def shown(graph):
    return Artefact("graph", "Graph of sub-tasks", graph.to_json())


def with_made(step, *artefacts, prompt=""):
    return replace(step, decision=replace(step.decision, artefacts=artefacts, prompt=prompt))


def test_branches_stand_side_by_side_right_above_what_waits_for_them():
    layout = arranged(WHOLE)
    assert layout.places == {1: (0, 0), 2: (0, 1), 3: (1, 0), 4: (1, 1), 5: (0, 2)}


def test_no_sub_task_stands_on_another_or_outside_the_picture():
    skills = [parse_skill(f"find a {name}") for name in ("mug", "cup", "pan", "pot")]
    crowd = graph_of(skills)
    every = read_graph("".join(f"{n}: {s}\n" for n, s in enumerate(skills, 1)), SKILLS)
    for graph in (crowd, every, WHOLE):
        layout = arranged(graph)
        assert len(set(layout.places.values())) == len(graph.nodes)
        width, height = layout.size
        for node in graph.nodes:
            x, y = layout.top_of(node.id)
            assert layout.width / 2 <= x <= width - layout.width / 2
            assert 0 <= y < height


def test_a_drawing_says_in_words_what_it_shows(tags):
    graph = WHOLE.marked(1, "done").marked(2, "failed")
    [picture] = tags(graph_drawing(graph), "svg")
    assert picture["role"] == "img"
    assert "1 find an apple, done; 2 pick up the apple, failed, after 1" in picture["aria-label"]
    states = [each["class"] for each in tags(graph_drawing(graph), "g")]
    assert states == ["node done", "node failed", *["node pending"] * 3]


def test_dependencies_that_were_added_look_different(tags):
    added = replace(WHOLE.nodes[1], added=(1,))
    graph = type(WHOLE)((WHOLE.nodes[0], added, *WHOLE.nodes[2:]))
    edges = [each["class"] for each in tags(graph_drawing(graph), "path") if each.get("class")]
    assert edges.count("edge added") == 1


@pytest.mark.parametrize(
    ("skill", "state"), [("find an apple", "done"), ("open the safe", "failed")]
)
def test_the_panel_shows_the_latest_graph_with_the_outcome_of_the_last_step(
    episode, click, tags, skill, state
):
    [step] = click(episode, skill).steps
    markup = made_panel([with_made(step, shown(WHOLE.marked(1, "now")))])
    assert next(each["class"] for each in tags(markup, "g")) == f"node {state}"
    over = made_panel([step], Closing(artefacts=(shown(WHOLE.marked(5, "done")),)))
    assert [each["class"] for each in tags(over, "g")][-1] == "node done"


def test_a_memory_is_a_table_and_a_plan_a_list_with_marks(episode, click, tags):
    [step] = click(episode, "find an apple").steps
    memory = Artefact("memory", "Memory", "holding: the <apple>\nat: the fridge: the left one")
    plan = Artefact("plan", "Sub-goals", "done: get it\nnow: put it: there\nto do: rest\n(wait)")
    markup = made_panel([with_made(step, memory, plan)])
    tags(markup)
    assert '<th scope="row">holding</th><td>the &lt;apple&gt;</td>' in markup
    assert "<td>the fridge: the left one</td>" in markup
    assert markup.count("<li") == 4
    assert "put it: there" in markup
    assert markup.index("Sub-goals") < markup.index("Memory")


def test_a_planner_that_made_nothing_has_no_panel(episode, click):
    assert made_panel(click(episode, "find an apple").steps) == ""


def test_each_step_tells_why_with_only_what_is_new_of_its_prompt(episode, click, tags):
    [step] = click(episode, "find an apple").steps
    assert thoughts(step) == ""
    note = Artefact("note", "Graph refused", "in a circle: 1 → 2 → 1")
    before = "Examples\nRobot: find"
    markup = thoughts(with_made(step, note, prompt=f"{before} an apple, done"), before)
    tags(markup)
    assert "in a circle: 1 → 2 → 1" in markup
    assert "… as before, then:\nRobot: find an apple, done" in markup
    assert "Examples" not in markup
    assert "Examples" in thoughts(with_made(step, prompt=before))
