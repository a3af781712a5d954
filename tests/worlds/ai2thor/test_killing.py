"""Unity killed a hundred times in a row: a hundred error records, and nothing else is left."""

import os
import random
import signal
import threading
import time
from dataclasses import replace

import pytest

from reibench.run import RunSpec, evaluate

MOMENTS = ("at start", "between steps", "in a step")


class Murdered:
    """A world whose Unity is killed once in each episode, at a moment that changes in turn."""

    def __init__(self, world, running, seed=0):
        self.skills = world.skills
        self.kills = []
        self._world = world
        self._running = running
        self._choose = random.Random(seed)

    def reset(self, task):
        self._moment = MOMENTS[len(self.kills) % len(MOMENTS)]
        self._steps_left = self._choose.randrange(3)
        if self._moment == "at start":
            killer = threading.Thread(target=self._kill_when_it_appears)
            killer.start()
            try:
                return self._world.reset(task)
            finally:
                killer.join()
        return self._world.reset(task)

    def step(self, skill):
        if self._moment != "at start" and self._steps_left == 0:
            [process] = self._running()
            self.kills.append(self._moment)
            if self._moment == "in a step":
                os.kill(process, signal.SIGSTOP)
                threading.Timer(0.02, os.kill, (process, signal.SIGKILL)).start()
            else:
                os.kill(process, signal.SIGKILL)
        self._steps_left -= 1
        return self._world.step(skill)

    def _kill_when_it_appears(self):
        while not (found := self._running()):
            time.sleep(0.005)
        time.sleep(self._choose.uniform(0.0, 0.15))
        os.kill(found[0], signal.SIGKILL)
        self.kills.append(self._moment)


@pytest.mark.parametrize(("protocol", "kills"), [("fifo", 100), ("wsgi", 12)])
def test_kills_in_a_row_leave_as_many_error_records_and_no_process(
    protocol, kills, standing_in, running, left_behind, episodes, store
):
    world = standing_in(server=protocol, start_seconds="15")
    murdered = Murdered(world, running)
    chosen = list(episodes.values())
    specs = [RunSpec(planner="expert", world="ai2thor:stand-in", seed=seed) for seed in range(2)]
    records = []
    for number in range(kills):
        spec, episode = specs[number // len(chosen)], chosen[number % len(chosen)]
        records += evaluate(spec, [episode], None, murdered, store)
        assert running() == []
    assert [record.status for record in records] == ["error"] * kills
    assert [each.error for each in records if "Unity ended by itself" not in each.error] == []
    assert [murdered.kills.count(m) for m in MOMENTS] == [(kills + 2 - i) // 3 for i in range(3)]
    stored = store.entries("status = 'error'")
    assert len({entry.id for entry in stored}) == len(stored) == kills
    assert left_behind() == []
    [solved] = evaluate(replace(specs[0], seed=9), chosen[:1], None, world, store)
    assert solved.status == "success"
    world.close()
    assert left_behind() == []
