"""What was made on the way."""

from reibench.artefact import Artefact
from reibench.view.artefacts import artefacts_html


def test_notes_are_in_plain_sight_and_everything_else_is_folded_under_its_title():
    note = Artefact("note", "gate", "it opened")
    plan = Artefact("pddl", "goal", "(:goal (in mug sink))")
    html = artefacts_html((note, plan))
    assert html.index("it opened") < html.index("<details")
    assert "<summary>goal</summary><pre>(:goal (in mug sink))</pre>" in html


def test_what_a_model_wrote_is_never_markup():
    for kind in ("note", "answer"):
        html = artefacts_html((Artefact(kind, "<i>", "<script>alert(1)</script>"),))
        assert "<script>" not in html
        assert "<i>" not in html


def test_nothing_made_shows_nothing():
    assert artefacts_html(()) == ""
