"""Finding an episode: by type, room, level and words, alone and together."""

import pytest

from reibench.dialogue import Vagueness
from reibench.view.catalogue import Catalogue
from reibench.view.finder import Seek, finder, found_list, seek

SHOWN = Vagueness("implicit", "standard")


@pytest.fixture
def catalogue(episodes):
    return Catalogue.of(episodes.values())


def test_everything_is_found_once_a_task_at_the_level_shown(catalogue):
    found = seek(catalogue, Seek(), SHOWN)
    assert len(found) == len(catalogue.of_task)
    assert {episode.vagueness for episode in found} == {SHOWN}


def test_choices_narrow_what_is_found_and_words_look_into_the_instruction(catalogue):
    for episode in catalogue.episodes:
        wanted = Seek(
            kind=str(episode.task.goal.task_type),
            room=episode.task.setup.room,
            level=str(episode.vagueness),
            words=" ".join(episode.dialogue.instruction.text.split()[:4]).upper(),
        )
        assert episode in seek(catalogue, wanted, SHOWN)
    kitchen = seek(catalogue, Seek(room="kitchen-2"), SHOWN)
    assert {episode.task.setup.room for episode in kitchen} == {"kitchen-2"}


def test_nothing_found_says_what_to_do(catalogue):
    shown = found_list(catalogue, Seek(words="zeppelin"), catalogue.first)
    assert "take a word or a choice back" in shown
    assert "<button" not in shown


def test_what_one_types_cannot_become_markup(catalogue):
    assert "<script" not in found_list(catalogue, Seek(words="<script>"), catalogue.first)


def test_every_room_and_type_can_be_chosen(catalogue):
    fields = finder(catalogue)
    for room in catalogue.rooms:
        assert f'value="{room}"' in fields
