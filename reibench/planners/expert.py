"""The expert: knows the goal and sees the whole room, and solves any solvable task.

An upper bound, the solution shown in the demo, and the proof that an episode can be solved.
"""

from collections.abc import Callable, Generator, Iterator
from typing import ClassVar, TypeAlias

from reibench.episode import Goal, TaskType
from reibench.household.objects import SINGLE
from reibench.methods import Instruction
from reibench.planners import Decision, Plan, planners
from reibench.scene import SceneObject
from reibench.skill import PICKABLE, SKILLS, Skill, Verb
from reibench.worlds import Event

Moves: TypeAlias = Generator[Skill, Event, None]
PLACES_TRIED = 6
"""How many receptacles of the wanted type are tried before giving up on a full one."""
THINGS_MOVED = 2
"""How many things are taken out of a full receptacle at most."""
SOMEWHERE = ("CounterTop", "DiningTable", "SideTable", "CoffeeTable", "Desk", "Dresser", "Shelf")
"""Where to leave what is in the way, in order of preference."""


@planners.register("expert")
class Expert:
    """Carry out the goal itself instead of an instruction."""

    reads_goal: ClassVar[bool] = True

    def __init__(self, goal: Goal) -> None:
        self._goal = goal

    def plan(self, instruction: Instruction, start: Event, skills: tuple[Skill, ...]) -> Plan:
        """Plan with the scene of each event; `instruction` is not read."""
        self._event = start
        moves = self._solve()
        skill = next(moves, None)
        while skill is not None:
            self._event = yield Decision(skill)
            try:
                skill = moves.send(self._event)
            except StopIteration:
                break
        return None

    def _solve(self) -> Moves:
        goal = self._goal
        if goal.sliced:
            yield from self._cut(goal.object)
        if self._stands_there(goal.object, goal.destination):
            yield from self._go_to(goal.destination)
            yield from self._do(Verb.PICK_UP, goal.object)
        else:
            yield from self._fetch(goal.object)
        if self._event.scene.held is None:
            return  # what it wants is not to be had: nothing it could still do would help
        match goal.task_type:
            case TaskType.EXAMINE:
                yield from self._light(goal.destination)
                return
            case TaskType.HEAT:
                yield from self._heat(goal.object)
            case TaskType.COOL:
                yield from self._cool(goal.object)
            case TaskType.CLEAN:
                yield from self._clean(goal.object)
            case TaskType.STACK:
                yield from self._go_to(goal.movable_receptacle)
                yield from self._do(Verb.PUT_DOWN, goal.object)
                yield from self._do(Verb.PICK_UP, goal.movable_receptacle)
        carried = goal.movable_receptacle or goal.object
        yield from self._put(carried, goal.destination)

    def _stands_there(self, name: str, receptacle: str) -> bool:
        """Whether every `receptacle` holds one thing only, and has a `name` already."""
        scene = self._event.scene
        places = scene.of_type(receptacle)
        held = [scene.by_id[one].type for place in places for one in place.contents or ()]
        return receptacle in SINGLE and held == [name] * len(places) != []

    def _do(self, verb: Verb, name: str) -> Moves:
        self._event = yield Skill(verb, name)

    def _seen(self, name: str) -> Iterator[SceneObject]:
        """Yield what is visible and can be called `name`."""
        scene = self._event.scene
        for thing in scene.objects:
            if thing.id in scene.visible and thing.type in (name, f"{name}Sliced"):
                yield thing

    def _go_to(self, name: str) -> Moves:
        """Go to a `name`, and open what it is shut in."""
        yield from self._do(Verb.FIND, name)
        yield from self._uncover(name)

    def _uncover(self, name: str) -> Moves:
        """Open what the `name` gone to is shut in, if it is."""
        if next(self._seen(name), None) is not None:
            return
        scene = self._event.scene
        for thing in scene.objects:
            container = scene.closed_around(thing)
            if thing.type == name and container and container.id in scene.visible:
                yield from self._do(Verb.OPEN, container.type)
                return

    def _fetch(self, name: str) -> Moves:
        yield from self._go_to(name)
        yield from self._do(Verb.PICK_UP, name)
        if self._goal.sliced and name == self._goal.object:
            yield from self._exchange(name, name, lambda held: held.type == f"{name}Sliced")

    def _take_back(self, name: str, place: str, left: str) -> Moves:
        """Pick up again the very thing that was left in or on a `place`."""
        yield from self._do(Verb.PICK_UP, name)
        yield from self._exchange(name, place, lambda held: held.id == left)

    def _exchange(self, name: str, place: str, wanted: Callable[[SceneObject], bool]) -> Moves:
        """Exchange what is held, if it is not `wanted`, for another `name` at a `place`."""
        for _ in range(THINGS_MOVED):
            held = self._event.scene.held
            spare = self._spare(place)
            if held is None or wanted(held) or not spare:
                return
            yield from self._try_each(name, spare)
            yield from self._go_to(place)
            yield from self._do(Verb.PICK_UP, name)

    def _spare(self, *but: str) -> str:
        """Return the type of a place to leave things, other than `but`; empty if none is."""
        scene = self._event.scene
        return next((p for p in SOMEWHERE if p not in but and scene.of_type(p)), "")

    def _put(self, carried: str, receptacle: str) -> Moves:
        """Put what is carried into some `receptacle`; make room where all are full."""
        yield from self._try_each(carried, receptacle)
        if not self._event.success and self._event.scene.held is not None:
            yield from self._make_room(carried, receptacle)

    def _try_each(self, carried: str, receptacle: str) -> Moves:
        """Try one `receptacle` after another until the thing is put."""
        for _ in range(min(PLACES_TRIED, len(self._event.scene.of_type(receptacle)))):
            yield from self._go_to(receptacle)
            opens = Skill(Verb.OPEN, receptacle)
            shut = any(thing.openable and not thing.open for thing in self._seen(receptacle))
            if shut and opens in SKILLS:  # a toilet is openable, but no skill opens one
                yield from self._do(opens.verb, opens.object)
            yield from self._do(Verb.PUT_DOWN, carried)
            if self._event.success:
                return

    def _make_room(self, carried: str, receptacle: str) -> Moves:
        """Leave what is carried elsewhere, take something out of a `receptacle`, and try again."""
        held = self._event.scene.held
        spare = self._spare(receptacle)
        other = self._spare(receptacle, spare) or spare
        if held is None or not spare:
            return
        yield from self._try_each(carried, spare)
        for _ in range(THINGS_MOVED):
            yield from self._go_to(receptacle)
            in_the_way = next(self._contents(receptacle), None)
            if in_the_way is None:
                break
            yield from self._do(Verb.PICK_UP, in_the_way)
            yield from self._try_each(in_the_way, other)
        yield from self._go_to(spare)
        yield from self._take_back(carried, spare, held.id)
        yield from self._try_each(carried, receptacle)

    def _contents(self, receptacle: str) -> Iterator[str]:
        """Yield the types of what can be taken out of a visible `receptacle` or its basin."""
        scene = self._event.scene
        for name in (receptacle, f"{receptacle}Basin"):
            for place in self._seen(name):
                for thing in map(scene.by_id.get, place.contents or ()):
                    if thing and thing.type in PICKABLE:
                        yield thing.type

    def _heat(self, name: str) -> Moves:
        left = self._held_id()
        yield from self._put(name, "Microwave")
        for verb in (Verb.CLOSE, Verb.TURN_ON, Verb.TURN_OFF, Verb.OPEN):
            yield from self._do(verb, "Microwave")
        yield from self._take_back(name, "Microwave", left)

    def _cool(self, name: str) -> Moves:
        left = self._held_id()
        yield from self._put(name, "Fridge")
        yield from self._do(Verb.CLOSE, "Fridge")
        yield from self._do(Verb.OPEN, "Fridge")
        yield from self._take_back(name, "Fridge", left)

    def _clean(self, name: str) -> Moves:
        left = self._held_id()
        yield from self._put(name, "Sink")
        yield from self._do(Verb.TURN_ON, "Faucet")
        yield from self._do(Verb.TURN_OFF, "Faucet")
        yield from self._take_back(name, "Sink", left)

    def _held_id(self) -> str:
        held = self._event.scene.held
        return held.id if held else ""

    def _light(self, lamp: str) -> Moves:
        yield from self._go_to(lamp)
        if not any(thing.on for thing in self._seen(lamp)):
            yield from self._do(Verb.TURN_ON, lamp)

    def _cut(self, name: str) -> Moves:
        scene = self._event.scene
        knife = "Knife" if scene.of_type("Knife") else "ButterKnife"
        yield from self._fetch(knife)
        yield from self._go_to(name)
        yield from self._do(Verb.SLICE, name)
        somewhere = next((place for place in SOMEWHERE if scene.of_type(place)), "CounterTop")
        yield from self._put(knife, somewhere)
