"""Seed instructions: every goal in a sentence, and files of them."""

import pytest

from reibench.dataset.build.seeding import plainly, read_seeds
from reibench.dataset.forms import names, says
from reibench.dataset.grammar import text_problems
from reibench.dataset.seeds import PROPORTIONS, options
from reibench.episode import Goal, TaskType
from reibench.errors import InvalidEpisode
from reibench.household import load_room, room_names


def test_every_goal_has_a_sentence_that_names_its_objects():
    rooms = [load_room(name) for name in room_names()]
    for goal in {goal for task in PROPORTIONS for goal, _ in options(rooms, task)}:
        text = plainly(goal)
        assert list(text_problems(text)) == [], text
        for name in filter(None, (goal.object, goal.movable_receptacle)):
            assert any(says(text, word) for word in names()[name].words), text


@pytest.mark.parametrize(
    ("goal", "text"),
    [
        (Goal(TaskType.PICK, "Apple", "Fridge"), "Put an apple in the fridge."),
        (
            Goal(TaskType.HEAT, "Bread", "CounterTop"),
            "Heat the bread and put the bread on the counter.",
        ),
        (
            Goal(TaskType.EXAMINE, "KeyChain", "FloorLamp"),
            "Pick up keys and turn on the floor lamp.",
        ),
        (
            Goal(TaskType.STACK, "Fork", "Sink", "Plate"),
            "Put a fork on a plate and put the plate in the sink.",
        ),
    ],
)
def test_sentences_read_like_annotators(goal, text):
    assert plainly(goal) == text


def test_a_file_of_seeds_is_read_with_and_without_sentences(tmp_path):
    path = tmp_path / "seeds.txt"
    path.write_text(
        "# two\nheat Potato > DiningTable | kitchen-2, 4 | Heat up a potato.\n\n"
        "pick Watch > Drawer | living-room-1\n"
    )
    one, two = read_seeds(path)
    assert (one.text, one.task.setup.seed, one.task.id) == ("Heat up a potato.", 4, "seeds_2")
    assert (two.text, two.task.setup.room) == ("Put a watch in the drawer.", "living-room-1")
    assert "Sofa" in two.present


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("heat Potato", "is not like 'heat Potato > DiningTable"),
        ("boil Potato > Sink | kitchen-1", "the task 'boil Potato > Sink' is not like"),
        ("heat Potato > Sink | attic", "No room called 'attic'"),
    ],
)
def test_a_wrong_line_is_named(tmp_path, line, said):
    path = tmp_path / "seeds.txt"
    path.write_text("\n" + line)
    with pytest.raises(InvalidEpisode, match="line 2") as caught:
        list(read_seeds(path))
    assert said in str(caught.value)
