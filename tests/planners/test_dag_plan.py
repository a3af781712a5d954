"""DAG-Plan: a graph of sub-tasks, checked, carried out in order, written anew after a failure."""

import json

import pytest

from reibench.backends import Generation, Usage
from reibench.backends.scripted import ScriptedBackend
from reibench.planners.dag_plan import ASKED_AGAIN, REPLANNED, DagPlan
from reibench.planners.examples import examples

FETCH = "1: find an apple\n2: pick up the apple after 1\n"
STORE = "3: find a fridge\n4: open the fridge after 3\n5: put down the apple after 2, 4\n"
WHOLE = f"{FETCH}{STORE}done"
CLOSED = "the fridge is closed"


def skills(decisions):
    return [decision.skill.text for decision in decisions]


def graph(decision):
    [artefact] = [each for each in decision.artefacts if each.kind == "graph"]
    return {node["id"]: node for node in json.loads(artefact.text)["nodes"]}


def notes(thought):
    return {each.title: each.text for each in thought.artefacts if each.kind == "note"}


def test_a_graph_is_carried_out_by_one_question_and_its_branches_are_kept(asked, played):
    backend = ScriptedBackend([WHOLE])
    decisions, closing = played(DagPlan(backend), asked)
    assert skills(decisions) == [
        "find an apple", "pick up the apple", "find a fridge", "open the fridge",
        "put down the apple",
    ]  # fmt: skip
    assert len(backend.prompts) == 1
    first = graph(decisions[0])
    assert first[3]["after"] == []
    assert first[5]["after"] == [2, 4]
    assert [node["state"] for node in first.values()] == ["now"] + ["pending"] * 4
    assert {node["state"] for node in graph(closing).values()} == {"done"}


def test_dependencies_decide_the_order_not_the_lines(asked, played):
    lines = "1: pick up the apple after 2\n2: find an apple\n3: put down the apple after 4, 1\n"
    backend = ScriptedBackend([f"{lines}4: find a fridge after 1\n"])
    decisions, _ = played(DagPlan(backend), asked)
    assert skills(decisions) == [
        "find an apple", "pick up the apple", "find a fridge", "put down the apple",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("wrong", "complaint"),
    [
        ("1: find an apple after 2\n2: find a fridge after 1\n", "in a circle: 1 → 2 → 1"),
        ("1: find an apple after 7\n", "Sub-task 1 is after 7, but there is no sub-task 7"),
        ("1: find an apple\n1: find a fridge\n", "Two sub-tasks have the number 1"),
        ("1: grab apple\n", "Sub-task 1, 'grab apple', is nothing the robot can do"),
        ("1: find an appel\n", "did you mean 'find an apple'?"),
        ("1: find a fridge\n2: put down the apple\n", "it has to find the apple and pick up the"),
        (f"{FETCH}3: pick up the apple after 2\n", "the robot holds the apple then"),
        (f"{FETCH}3: put down the mug after 2\n", "the apple then; it has to put down that"),
        ("1: pick up the apple\n", "the robot is not near the apple then; it has to find"),
        (
            "1: find an apple\n2: find an apple\n",
            "Sub-task 2, find an apple, cannot work: the robot is",
        ),
        ("1: find an apple\n2: slice the apple\n", "the robot holds no knife then"),
        ("I cannot help with that.", "There is no sub-task"),
        ("", "There is no sub-task"),
        ("".join(f"{n}: find an apple\n" for n in range(1, 32)), "31 sub-tasks, at most 30"),
    ],
)
def test_what_cannot_be_carried_out_is_named_and_asked_again(wrong, complaint, asked, played):
    backend = ScriptedBackend([wrong, WHOLE])
    decisions, _ = played(DagPlan(backend), asked)
    assert complaint in backend.prompts[1].text[backend.prompts[1].fixed :]
    assert complaint in notes(decisions[0])["Graph refused"]
    answers = [each.text for each in decisions[0].artefacts if each.kind == "answer"]
    assert answers == [wrong, WHOLE]
    assert len(decisions) == 5


def test_rubbish_without_end_is_given_up_with_a_reason(asked, played):
    backend = ScriptedBackend(["1:", "\x00 1: \n after 99999999999999", "…"])
    decisions, closing = played(DagPlan(backend), asked)
    assert decisions == []
    assert len(backend.prompts) == ASKED_AGAIN + 1
    assert notes(closing)["Given up"] == "3 graphs in a row were refused."
    assert closing.prompt == backend.prompts[-1].text


def test_a_graph_that_can_be_read_is_tried_at_last_and_the_room_tells_why_it_fails(asked, played):
    backend = ScriptedBackend([*["1: pick up the apple\ndone"] * (ASKED_AGAIN + 1), FETCH])
    decisions, _ = played(DagPlan(backend), asked, [("pick up the apple", "find it first")])
    assert "3 graphs in a row were refused" in notes(decisions[0])["Tried all the same"]
    assert skills(decisions) == ["pick up the apple", "find an apple", "pick up the apple"]
    assert "Failed: pick up the apple (find it first)" in backend.prompts[-1].text


def test_dependencies_the_skills_imply_are_added_and_said(asked, played):
    loose = "1: find an apple\n2: pick up the apple\n3: find a fridge\n4: put down the apple\n"
    [first, *_], _ = played(DagPlan(ScriptedBackend([loose])), asked)
    assert {key: node["after"] for key, node in graph(first).items()} == {
        1: [], 2: [1], 3: [], 4: [3, 2],
    }  # fmt: skip
    assert graph(first)[4]["added"] == [3, 2]
    assert any(each.text == "4 has to come after 3, 2." for each in first.artefacts)


def test_after_a_failure_the_model_is_told_what_was_done_what_failed_and_why(asked, played):
    shut = f"{FETCH}3: find a fridge after 2\n4: put down the apple after 3\ndone"
    backend = ScriptedBackend([shut, "1: open the fridge\n2: put down the apple after 1\ndone"])
    decisions, closing = played(DagPlan(backend), asked, [("put down the apple", CLOSED)])
    assert skills(decisions)[3:] == ["put down the apple", "open the fridge", "put down the apple"]
    assert backend.prompts[1].text.endswith(
        "Done: find an apple, pick up the apple, find a fridge\n"
        "Failed: put down the apple (the fridge is closed)\n"
        "Planned: put down the apple\n"
        "Now: the robot is at the fridge and holds the apple\nGraph of what remains:\n"
    )
    assert [node["state"] for node in graph(decisions[4]).values()] == ["now", "pending"]
    assert [node["state"] for node in graph(closing).values()] == ["done", "done"]


def test_what_was_said_not_to_be_there_is_not_looked_for_again(asked, played):
    absent = "there is no apple in this room"
    tomato = "1: find a tomato after 1\n2: pick up the tomato after 1\n"
    backend = ScriptedBackend([FETCH, FETCH, tomato])
    decisions, _ = played(DagPlan(backend), asked, [("find an apple", absent)])
    assert "Mind: There is no apple in this room; what is meant" in backend.prompts[2].text
    assert skills(decisions)[1:] == ["find a tomato", "pick up the tomato"]


def test_nothing_may_remain_after_a_failure(asked, played):
    lamp = "1: find a floor lamp\n2: turn on the floor lamp after 1\n"
    backend = ScriptedBackend([lamp, "done"])
    refusals = [("turn on the floor lamp", "the floor lamp is already on")]
    decisions, closing = played(DagPlan(backend), asked, refusals)
    assert len(decisions) == 2
    assert "Given up" not in notes(closing)


def test_graphs_of_what_remains_are_bounded(asked, played):
    put = "1: open the fridge\ndone"
    backend = ScriptedBackend(["1: find a fridge\n2: open the fridge\n", *[put] * REPLANNED])
    decisions, closing = played(
        DagPlan(backend), asked, [("open the fridge", "stuck")] * (REPLANNED + 1)
    )
    assert len(decisions) == REPLANNED + 2
    assert notes(closing)["Given up"] == "6 graphs of what remained were tried."


def test_every_call_is_paid_for_once(asked, played):
    class Counting(ScriptedBackend):
        def generate(self, prompt, **options):
            answer = super().generate(prompt, **options)
            return Generation(answer.text, Usage(10, 0, 5, 1.0), answer.prompt)

    backend = Counting(["nonsense", "1: find an apple\n2: open the fridge\n", "1: grab\n", "done"])
    decisions, closing = played(DagPlan(backend), asked, [("open the fridge", "it is stuck")])
    costs = [one.usage.prompt_tokens for one in (*decisions, closing)]
    assert costs == [20, 0, 20]


def test_the_model_is_held_to_the_skills_and_the_graph_s_form(asked, played):
    grammars = []

    class Noting(ScriptedBackend):
        def generate(self, prompt, *, grammar="", **options):
            grammars.append(grammar)
            return super().generate(prompt, **options)

    played(DagPlan(Noting([WHOLE])), asked)
    [written] = grammars
    assert '"pick up " ("the alarm clock" | "the apple"' in written
    assert written.count('"the tomato"') == 3  # picked up, put down, sliced; found with an article


def test_what_was_said_to_be_closed_has_to_be_opened(asked, played):
    shut = f"{FETCH}3: find a fridge after 2\n4: put down the apple after 3\ndone"
    again = "1: find a fridge\n2: put down the apple after 1\ndone"
    backend = ScriptedBackend([shut, again, "1: open the fridge\n2: put down the apple\n"])
    decisions, _ = played(DagPlan(backend), asked, [("put down the apple", CLOSED)])
    assert (
        "Mind: The fridge is closed; it has to open the fridge first.\nGraph of"
        in backend.prompts[2].text
    )
    assert skills(decisions)[-2:] == ["open the fridge", "put down the apple"]


def test_the_examples_are_the_fixed_part_of_every_question(asked, played):
    backend = ScriptedBackend(["", "1: find an apple\n2: open the fridge\n", "done"])
    played(DagPlan(backend), asked, [("open the fridge", "it is stuck")])
    fixed = {prompt.text[: prompt.fixed] for prompt in backend.prompts}
    assert len(fixed) == 1
    assert "Graph of what remains:" in fixed.pop()


def test_the_graphs_of_all_examples_pass_their_own_checks(played):
    from reibench.planners.attempts import OUTSET, attempts, foreseen, setbacks
    from reibench.planners.checking import check_conditions, mended
    from reibench.planners.graph import graph_of, read_graph
    from reibench.skill import SKILLS

    for example in examples():
        tried = attempts(example)
        whole = graph_of(foreseen(tried))
        assert mended(read_graph(whole.written(), SKILLS)) == whole
        check_conditions(whole, OUTSET)
        for setback, remaining in setbacks(tried):
            rest = graph_of(remaining)
            assert mended(rest) == rest
            check_conditions(rest, setback)


def test_a_graph_in_which_everything_depends_on_everything_is_checked_at_once(asked, played):
    lines = [
        f"{n}: find {'an apple' if n % 2 else 'a mug'}"
        + (f" after {', '.join(map(str, range(1, n)))}" if n > 1 else "")
        for n in range(1, 31)
    ]
    decisions, _ = played(DagPlan(ScriptedBackend(["\n".join(lines)])), asked)
    assert len(decisions) == 30
