"""Timing the embedded world: skill steps a second by room size, and memory of many worlds."""

import json
import random
import subprocess
import sys
from time import perf_counter

from reibench.episode import Goal, SceneSetup, Task, TaskType
from reibench.household import Room, generate_room
from reibench.skill import SKILLS, Skill, Verb
from reibench.worlds.embedded import EmbeddedSimulator
from reibench.worlds.rules import STRICT
from reibench.worlds.thor import ThorWorld

SIZES = (25, 50, 100, 200)
STEPS = 1_500
REPEATS = 3
WORLDS = 64


class RoomSimulator(EmbeddedSimulator):
    """An embedded simulator of one generated room."""

    def __init__(self, room: Room) -> None:
        super().__init__()
        self._room = room

    def room_called(self, name: str) -> Room:
        """Return the one room whatever is asked."""
        return self._room


def _world(objects: int, seed: int = 0) -> tuple[ThorWorld, Task, list[Skill]]:
    room = generate_room("kitchen", seed, name=f"bench-{objects}-{seed}", objects=objects)
    types = {thing.type for thing in room.objects}
    goal = Goal(TaskType.HEAT, "Potato", "CounterTop")
    task = Task("bench", SceneSetup(room.name), goal)
    skills = [skill for skill in SKILLS if skill.object in types]
    return ThorWorld(RoomSimulator(room), STRICT), task, skills


def _sequence(skills: list[Skill], steps: int) -> list[Skill]:
    """Return a visit to things one after another: go there, try what can be done, go on."""
    choose = random.Random(1)
    finds = [skill for skill in skills if skill.verb is Verb.FIND]
    chosen: list[Skill] = []
    while len(chosen) < steps:
        thing = choose.choice(finds)
        chosen.append(thing)
        others = [s for s in skills if s.object == thing.object and s.verb is not Verb.FIND]
        chosen += choose.sample(others, min(2, len(others)))
    return chosen[:steps]


def steps_per_second(objects: int) -> float:
    """Return the best of some rounds of skill steps in a room of about `objects` objects."""
    world, task, skills = _world(objects)
    sequence = _sequence(skills, STEPS)
    rates = []
    for _ in range(REPEATS):
        world.reset(task)
        begin = perf_counter()
        for skill in sequence:
            world.step(skill)
        rates.append(len(sequence) / (perf_counter() - begin))
    return max(rates)


def memory_of_worlds(count: int) -> float:
    """Return the megabytes that a fresh process with `count` started worlds occupies."""
    code = f"from reibench.bench import hold_worlds; print(hold_worlds({count}))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return float(done.stdout)


def hold_worlds(count: int) -> float:
    """Start `count` worlds of 50 objects, act in each, and return this process's peak in MB."""
    import resource

    worlds = [_world(50, seed) for seed in range(count)]
    for world, task, skills in worlds:
        world.reset(task)
        for skill in _sequence(skills, 30):
            world.step(skill)
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def bench_world() -> dict[str, object]:
    """Return what `bench world --json` prints."""
    return {
        "skill_steps_per_second": {str(n): round(steps_per_second(n), 1) for n in SIZES},
        f"memory_mb_{WORLDS}_worlds": round(memory_of_worlds(WORLDS), 1),
        "steps_timed": STEPS,
        "rounds": REPEATS,
        "reported": "best round",
    }


if __name__ == "__main__":
    sys.stdout.write(json.dumps(bench_world()) + "\n")
