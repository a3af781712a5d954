"""Timing worlds: skill steps a second by room size and over AI2-THOR's wires, and memory."""

import random
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

from reibench.episode import Goal, SceneSetup, Task, TaskType
from reibench.household import Room, generate_room
from reibench.household.rooms import save_room
from reibench.methods import Instruction
from reibench.planners.expert import Expert
from reibench.skill import SKILLS, Skill, Verb
from reibench.worlds import World
from reibench.worlds.embedded import EmbeddedSimulator
from reibench.worlds.rules import STRICT
from reibench.worlds.thor import ThorWorld

SIZES = (25, 50, 100, 200)
STEPS = 1_500
REPEATS = 3
WORLDS = 64
SIDE_BY_SIDE = 50
"""Objects in the room in which the ways to reach a world are compared."""
SIDE_STEPS = 300
"""Steps timed for each of them, a tenth of that with frames."""


class RoomSimulator(EmbeddedSimulator):
    """An embedded simulator of one generated room."""

    def __init__(self, room: Room) -> None:
        super().__init__()
        self._room = room

    def room_called(self, name: str) -> Room:
        """Return the one room whatever is asked."""
        return self._room


@dataclass(frozen=True)
class Course:
    """What is timed in a room."""

    room: Room
    task: Task
    visits: tuple[Skill, ...]
    """Going to one thing after another and trying what can be done: many are refused."""
    plan: tuple[Skill, ...]
    """The expert's solution: every step works."""


@dataclass(frozen=True)
class Rates:
    """Skill steps a second, the best of some rounds."""

    visits: float = 0.0
    working: float = 0.0


def course(objects: int, seed: int = 0) -> Course:
    """Return a course through a generated kitchen of about `objects` objects."""
    room = _kitchen(objects, seed)
    types = sorted({thing.type for thing in room.objects})
    # Not every room has a potato; in those something else is heated, or just carried.
    goals = [Goal(TaskType.HEAT, name, "CounterTop") for name in ("Potato", *types)]
    goals += [Goal(TaskType.PICK, name, "CounterTop") for name in types]
    tasks = (Task("bench", SceneSetup(room.name), goal) for goal in goals)
    return next(
        Course(room, task, _visits(room), plan) for task in tasks if (plan := _plan(room, task))
    )


def time_rounds(world: World, run: Course, steps: int, before: Rates = Rates()) -> Rates:
    """Return the rates of a round of each kind, or those of `before` where they were better."""
    laps = max(1, steps // len(run.plan))
    visits = _rate(world, run.task, run.visits[:steps], 1)
    working = _rate(world, run.task, run.plan, laps)
    return Rates(max(before.visits, visits), max(before.working, working))


def time_embedded(run: Course) -> Rates:
    """Return the best of some rounds in the embedded world."""
    world, rates = ThorWorld(RoomSimulator(run.room), STRICT), Rates()
    for _ in range(REPEATS):
        rates = time_rounds(world, run, STEPS, rates)
    return rates


def time_side_by_side(run: Course, steps: int = SIDE_STEPS) -> dict[str, Rates]:
    """Return the rates of the embedded world and the same one over the wires, taken in turns."""
    with _worlds(run.room) as worlds:
        best = dict.fromkeys(worlds, Rates())
        for _ in range(REPEATS):
            for way, world in worlds.items():
                some = steps // 10 if "frames" in way else steps
                best[way] = time_rounds(world, run, some, best[way])
    return best


def share_that_works(run: Course) -> float:
    """Return how many of the visits' steps are not refused."""
    world = ThorWorld(RoomSimulator(run.room), STRICT)
    world.reset(run.task)
    return sum(world.step(skill).success for skill in run.visits) / len(run.visits)


def memory_of_worlds(count: int) -> float:
    """Return the megabytes that a fresh process with `count` started worlds occupies."""
    code = f"from reibench.bench.worlds import hold_worlds; print(hold_worlds({count}))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return float(done.stdout)


def hold_worlds(count: int) -> float:
    """Start `count` worlds of 50 objects, act in each, and return this process's peak in MB."""
    rooms = [_kitchen(50, seed) for seed in range(count)]
    worlds = [ThorWorld(RoomSimulator(room), STRICT) for room in rooms]
    for world, room in zip(worlds, rooms, strict=True):
        world.reset(Task("bench", SceneSetup(room.name), Goal(TaskType.PICK, "Mug", "Shelf")))
        for skill in _visits(room)[:30]:
            world.step(skill)
    return _peak_memory()


def bench_world() -> dict[str, object]:
    """Return what `bench world --json` prints."""
    runs = {str(objects): course(objects) for objects in SIZES}
    rates = {size: time_embedded(run) for size, run in runs.items()}
    sides = time_side_by_side(runs[str(SIDE_BY_SIDE)])
    base = sides["embedded"]
    return {
        "skill_steps_per_second": {size: round(each.visits, 1) for size, each in rates.items()},
        "share_that_worked": {size: round(share_that_works(run), 3) for size, run in runs.items()},
        "working_skill_steps_per_second": {
            size: round(each.working, 1) for size, each in rates.items()
        },
        f"memory_mb_{WORLDS}_worlds": round(memory_of_worlds(WORLDS), 1),
        "side_by_side": {
            way: _rounded(each)
            | {
                "visits_to_embedded": round(each.visits / base.visits, 4),
                "working_to_embedded": round(each.working / base.working, 4),
            }
            for way, each in sides.items()
        },
        "side_by_side_objects": SIDE_BY_SIDE,
        "steps_timed": STEPS,
        "side_by_side_steps_timed": SIDE_STEPS,
        "rounds": REPEATS,
        "reported": "best round",
    }


def _peak_memory() -> float:
    """Return the most this process has occupied, in MB."""
    import resource

    status = Path("/proc/self/status")
    if status.exists():
        # What getrusage says on Linux includes the parent's peak, from before this one began.
        lines = dict(line.split(":", 1) for line in status.read_text().splitlines() if ":" in line)
        return int(lines["VmHWM"].split()[0]) / 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def _kitchen(objects: int, seed: int) -> Room:
    return generate_room("kitchen", seed, name=f"bench-{objects}-{seed}", objects=objects)


def _rounded(rates: Rates) -> dict[str, float]:
    return {name: round(value, 1) for name, value in asdict(rates).items()}


def _visits(room: Room) -> tuple[Skill, ...]:
    types, choose = {thing.type for thing in room.objects}, random.Random(1)
    skills = [skill for skill in SKILLS if skill.object in types]
    finds = [skill for skill in skills if skill.verb is Verb.FIND]
    chosen: list[Skill] = []
    while len(chosen) < STEPS:
        thing = choose.choice(finds)
        chosen.append(thing)
        others = [s for s in skills if s.object == thing.object and s.verb is not Verb.FIND]
        chosen += choose.sample(others, min(2, len(others)))
    return tuple(chosen[:STEPS])


def _plan(room: Room, task: Task) -> tuple[Skill, ...]:
    """Return the steps of the expert's solution that work; none if it finds no solution."""
    world = ThorWorld(RoomSimulator(room), STRICT)
    event = world.reset(task)
    moves = Expert(task.goal).plan(Instruction(text="", original=""), event, world.skills)
    plan, decision = [], next(moves, None)
    while decision is not None:
        event = world.step(decision.skill)
        if event.success:
            plan.append(decision.skill)
        try:
            decision = moves.send(event)
        except StopIteration:
            break
    return tuple(plan) if event.solved else ()


def _rate(world: World, task: Task, skills: tuple[Skill, ...], laps: int) -> float:
    """Return the skill steps a second; setting up the room before each lap is not counted."""
    seconds = 0.0
    for _ in range(laps):
        world.reset(task)
        begin = perf_counter()
        for skill in skills:
            world.step(skill)
        seconds += perf_counter() - begin
    return laps * len(skills) / seconds


@contextmanager
def _worlds(room: Room) -> Iterator[dict[str, World]]:
    """Start the ways there are to reach a world of that room."""
    # Not at the top: the memory of embedded worlds is measured in processes with this module.
    from reibench.worlds.ai2thor.settings import UnitySettings
    from reibench.worlds.ai2thor.simulator import UnitySimulator

    with ExitStack() as ending:
        file = Path(ending.enter_context(TemporaryDirectory())) / "room.json"
        save_room(room, file)
        settings = replace(
            UnitySettings.from_environment(), width=300, height=300, arguments=f"--room {file}"
        )
        worlds: dict[str, World] = {"embedded": ThorWorld(RoomSimulator(room), STRICT)}
        for server in ("fifo", "wsgi"):
            over = replace(settings, server=server)
            for way, frames in ((server, False), (f"{server}, frames", True)):
                simulator = UnitySimulator("stand-in", over, frames=frames)
                ending.callback(simulator.close)
                # Frames are made and sent; writing them as PNG is the page's business.
                worlds[way] = ThorWorld(simulator, STRICT)
        yield worlds
