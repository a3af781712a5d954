"""The dataset card: what it says of the shipped file is what the file holds."""

from itertools import pairwise

import pytest

from reibench.commands.building import CARD, EPISODES
from reibench.dataset.card import fingerprint, with_figures
from reibench.dataset.files import read_episodes, write_episodes
from reibench.dataset.levels import derive
from reibench.dataset.sample import select
from reibench.dataset.scripts import shipped_scripts
from reibench.errors import ReibenchError


def test_the_shipped_file_is_what_the_scripts_make_byte_for_byte(tmp_path):
    again = tmp_path / "again.jsonl.gz"
    write_episodes(again, [each for script in shipped_scripts() for each in derive(script)])
    assert again.read_bytes() == EPISODES.read_bytes()


def test_the_card_says_what_the_shipped_file_holds(shipped):
    card = CARD.read_text(encoding="utf-8")
    assert with_figures(card, shipped) == card
    assert fingerprint(shipped) in card


def test_the_fingerprint_tells_one_changed_episode(shipped):
    assert fingerprint(shipped[:9]) != fingerprint([*shipped[:8], shipped[9]])


def test_a_card_without_its_part_is_refused(shipped):
    with pytest.raises(ReibenchError, match="no part between"):
        with_figures("# A card", shipped)


def test_the_sample_of_1000_has_the_papers_counts_and_is_balanced(shipped):
    sample = select(shipped, "rei-1000")
    types = [each.task.goal.task_type.short for each in sample]
    counts = {kind: types.count(kind) for kind in set(types)}
    assert counts == {
        "pick": 185, "stack": 184, "clean": 162, "heat": 168, "cool": 168, "examine": 133,
    }  # fmt: skip
    levels = [str(each.vagueness) for each in sample]
    assert {levels.count(level) for level in set(levels)} == {111, 112}


def test_episodes_of_a_task_stand_together(shipped):
    changes = sum(one.task.id != next_.task.id for one, next_ in pairwise(shipped))
    assert changes == 299
    assert read_episodes(EPISODES) == shipped
