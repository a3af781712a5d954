"""The two bar figures: what they draw can be read from the SVG's ids."""

import re
import xml.etree.ElementTree as ET

import pytest

from reibench.__main__ import main

METHODS = "success-by-method.svg"


def draw(database, folder, *arguments):
    arguments = ["--figures", str(folder), *arguments]
    assert main(["score", "--db", str(database), *arguments]) == 0
    return folder


@pytest.fixture(scope="module")
def drawn(played_once, tmp_path_factory):
    """Draw the figures and return their folder."""
    return draw(played_once, tmp_path_factory.mktemp("plain") / "made" / "here")


@pytest.fixture(scope="module")
def marked(played_once, tmp_path_factory):
    """Draw them with the paper's numbers."""
    return draw(played_once, tmp_path_factory.mktemp("marked"), "--against", "paper")


def ids(path):
    named = (element.get("id", "") for element in ET.parse(path).iter())
    return [name for name in named if " " in name]


def test_both_figures_are_drawn_in_three_formats(drawn):
    for name in ("success-by-level", "success-by-method"):
        assert (drawn / f"{name}.png").read_bytes().startswith(b"\x89PNG")
        assert (drawn / f"{name}.pdf").read_bytes().startswith(b"%PDF")
        assert ET.parse(drawn / f"{name}.svg").getroot().tag.endswith("svg")


def test_each_method_has_a_bar_for_each_level_in_both_readings(drawn):
    bars = ids(drawn / METHODS)
    assert len(bars) == 2 * 9 * 2
    assert "none explicit-standard solved 100.0" in bars
    assert "none explicit-standard said-done 50.0" in bars
    assert "tocc implicit-short solved 50.0" in bars


def test_the_figure_by_level_leaves_methods_out(drawn):
    bars = ids(drawn / "success-by-level.svg")
    assert len(bars) == 9 * 2
    assert all(bar.startswith("none ") for bar in bars)


def test_the_paper_s_numbers_are_marked_only_when_asked_for(drawn, marked):
    assert not any(name.startswith("paper") for name in ids(drawn / METHODS))
    marks = [name for name in ids(marked / METHODS) if name.startswith("paper")]
    assert "paper LLaMA3.1-8B tocc explicit-standard 59.0" in marks
    assert len(marks) == 2 * 9
    levels = ids(marked / "success-by-level.svg")
    assert len([name for name in levels if name.startswith("paper")]) == 3 * 9


def test_the_same_scores_draw_the_same_file(drawn, played_once, tmp_path):
    draw(played_once, tmp_path)
    for name in (METHODS, "success-by-method.pdf", "success-by-level.png"):
        assert (drawn / name).read_bytes() == (tmp_path / name).read_bytes()


def test_intervals_are_drawn_above_and_below(drawn):
    text = (drawn / METHODS).read_text(encoding="utf-8")
    assert len(re.findall(r'id="LineCollection_\d+"', text)) == 2 * 2 * 9
