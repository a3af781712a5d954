"""Realised scripts, made once for all tests."""

from itertools import islice

import pytest

from reibench.dataset.realise.compose import Realiser
from reibench.dataset.realise.tasks import tasks
from reibench.dataset.scripts import Script
from reibench.household import load_room, room_names

SEED, MANY = 20, 400


@pytest.fixture(scope="session")
def realised() -> list[Script]:
    rooms = [load_room(name) for name in room_names() if not name.startswith("FloorPlan")]
    realiser = Realiser()
    seeds = islice(tasks(rooms, SEED, lambda task: True), MANY)
    return [realiser.realise(seed.task, seed.present, seed.task.id) for seed in seeds]
