"""Scripts: the marked form, the nine levels that derive from it, and defects in bad ones."""

import pytest

from reibench.dataset.levels import derive
from reibench.dataset.sample import select
from reibench.dataset.script_check import script_problems
from reibench.dataset.script_set import set_problems
from reibench.dataset.scripts import SCRIPTS, format_scripts, read_scripts
from reibench.errors import InvalidEpisode

GOLD = SCRIPTS / "gold.txt"
SAMPLES = SCRIPTS.parent / "samples"


@pytest.fixture(scope="module")
def gold():
    return {script.id: script for script in read_scripts(GOLD)}


@pytest.fixture
def broken(tmp_path):
    """Read one of the gold scripts with some words changed."""

    def read(name, *changes):
        text = next(t for t in GOLD.read_text().split("\n# ") if t.startswith((name, f"# {name}")))
        text = text if text.startswith("# ") else f"# {text}"
        for old, new in changes:
            assert old in text, old
            text = text.replace(old, new, 1)
        path = tmp_path / "script.txt"
        path.write_text(text)
        return read_scripts(path)[0]

    return read


def test_scripts_come_back_from_a_file_as_they_were():
    text = GOLD.read_text()
    assert format_scripts(read_scripts(GOLD)) == text


def test_the_hand_marked_gold_episodes_derive_from_their_scripts_to_the_letter(gold):
    # the manifest holds the digests of the 54 episodes as they were marked by hand
    episodes = [episode for script in gold.values() for episode in derive(script)]
    assert len(select(episodes, str(SAMPLES / "gold.json"))) == 54


def test_gold_scripts_are_sound_alone_and_together(gold):
    assert [problem for script in gold.values() for problem in script_problems(script)] == []
    assert set_problems(list(gold.values())) == []


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("[the potato|it]", "[the potato|it", "stands alone"),
        ("{+Dr. Pan had the other half.}", "{+Dr. Pan had the other half.", "brace is not closed"),
        ("task: heat Potato", "task: boil Potato", "is not like"),
        ("room: kitchen-2, seed 2\n", "", "has no line 'room'"),
        ("R Is half", "X Is half", "a turn begins with"),
    ],
)
def test_a_script_that_cannot_be_read_is_named(broken, old, new, said):
    with pytest.raises(InvalidEpisode, match="script heat_potato") as caught:
        broken("heat_potato", (old, new))
    assert said in str(caught.value)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ([("> You", "R You")], "not six of human and robot"),
        ([("[the potato|it]", "[2:the potato|it]")], "no movable receptacle"),
        ([("Is half a granola bar really all you have had? ", "")], "turn 2 has"),
        (
            [
                ("[that potato]", "supper"),
                ("[A potato|Something starchy]", "Rice"),
                ("[a potato|one of those]", "rice"),
                ("[a potato|something that size]", "rice"),
            ],
            "the context mentions the Potato 2 times, not 3 or more",
        ),
        ([("[the potato|that lumpy thing]", "dinner")], "the request does not mention the Potato"),
        ([("[the potato|it]", "[the potato]")], "needs an unnamed form"),
        ([("<the dining table>", "the dining table")], "does not mark <the DiningTable>"),
        ([("{!The only", "The only"), ("much salt.}", "much salt.")], "mark its sentence with !"),
        ([("{+Dr. Pan had the other half.} ", "")], "stands 2 times in the noise, not 3"),
        ([("{+Dr. Pan had the other half.}", "Dr. Pan had the other half.")], "outside noise"),
        ([("Dr. Pan had the other half.", "She had it.")], "does not say 'Dr. Pan'"),
        ([("colleague, Pan", "colleague, Pandora")], "is no object type"),
        ([("colleague, Pan", "colleague, DiningTable")], "is part of the task"),
        ([("no peeling left", "no potato peeling left")], "outside a named mark"),
        ([("|it]", "|them]")], "does not agree in number"),
        ([("The microwave needs", "The the microwave needs")], "is doubled"),
        ([("A chair sounds", "An chair sounds")], "a or an"),
        ([("A chair sounds", "a chair sounds")], "begins a sentence small"),
        ([("{-Like", "Like"), ("my coat.}", "my coat.")], "short leaves out 1 passages"),
        ([("heated up and put", "put")], "is to be treated"),
    ],
)
def test_a_defect_in_a_script_is_found(broken, changes, said):
    found = script_problems(broken("heat_potato", *changes))
    assert any(said in each for each in found), found


def test_an_unmarked_rival_is_found(broken):
    script = broken("cool_apple", ("underdetermined: implicit-short Apple Tomato\n", ""))
    [problem] = script_problems(script)
    assert problem.startswith("at implicit-short the rivals left are Tomato")


def test_scripts_that_share_their_words_are_found(gold, broken):
    copy = broken("heat_potato", ("# heat_potato", "# heat_potato_2"), ("30s", "40s"))
    found = set_problems([*gold.values(), copy])
    assert any("of their five-word sequences" in each for each in found)


def test_the_written_scripts_are_sound_alone_and_together():
    scripts = [script for path in sorted(SCRIPTS.glob("*.txt")) for script in read_scripts(path)]
    assert len(scripts) == 300
    found = {script.id: script_problems(script) for script in scripts}
    assert {name: problems for name, problems in found.items() if problems} == {}
    assert set_problems(scripts) == []
