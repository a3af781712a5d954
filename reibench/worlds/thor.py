"""The skill layer: compiles skills to AI2-THOR actions over any controller that speaks them.

What a skill means is decided here, once, for the embedded simulator and for Unity; the feedback
and the placing rules come from `rules`.
"""

from collections.abc import Callable, Sequence

from reibench.episode import Task
from reibench.goals import Treatments, check
from reibench.household.objects import object_type
from reibench.scene import SceneObject
from reibench.skill import SKILLS, Skill, Verb
from reibench.worlds import Event
from reibench.worlds.approach import CLOSE_ENOUGH, distance
from reibench.worlds.moving import Legs
from reibench.worlds.rules import Reason, Refused, Rules
from reibench.worlds.setup import prepare
from reibench.worlds.simulator import Simulator
from reibench.worlds.treating import treat

KNIVES = frozenset({"Knife", "ButterKnife"})
BASIN_OF = {"Sink": "SinkBasin", "Bathtub": "BathtubBasin"}


class ThorWorld:
    """Household skills over a simulator."""

    def __init__(self, simulator: Simulator, rules: Rules) -> None:
        self.skills = SKILLS
        self._simulator = simulator
        self._rules = rules
        self._handlers: dict[Verb, Callable[[Skill], None]] = {
            Verb.FIND: self._find,
            Verb.PICK_UP: self._pick_up,
            Verb.PUT_DOWN: self._put_down,
            Verb.OPEN: self._open,
            Verb.CLOSE: self._close,
            Verb.SLICE: self._slice,
            Verb.TURN_ON: self._turn_on,
            Verb.TURN_OFF: self._turn_off,
        }

    @property
    def simulator(self) -> Simulator:
        """The simulator the skills act on."""
        return self._simulator

    def reset(self, task: Task) -> Event:
        """Set up the task's room."""
        self._task = task
        self._place = ""
        self._visited: list[str] = []
        self._treatments = Treatments()
        self._legs = Legs(self._simulator)
        prepare(self._simulator, task.setup)
        self._scene = self._simulator.scene()
        return self._event(success=True)

    def step(self, skill: Skill) -> Event:
        """Carry out `skill`; refusals are events."""
        before = self._scene.agent
        try:
            self._handlers[skill.verb](skill)
        except Refused as refused:
            if self._simulator.scene().agent != before:
                self._legs.stand(
                    before
                )  # the robot turned to look: a refused skill changes nothing
            self._scene = self._simulator.scene()
            self._forget_place(skill)
            return self._event(success=False, message=self._rules.say(skill, refused))
        self._scene = self._simulator.scene()
        self._treatments = treat(self._treatments, skill, self._acted_on, self._scene)
        self._forget_place(skill)
        return self._event(success=True)

    def close(self) -> None:
        """Free the simulator."""
        self._simulator.close()

    def _event(self, *, success: bool, message: str = "") -> Event:
        goals = check(self._task.goal, self._scene, self._treatments, self._rules.matches)
        return Event(success, message, self._scene, goals)

    def _forget_place(self, skill: Skill) -> None:
        if skill.verb in self._rules.place_forgotten_by:
            self._place = ""
        if skill.verb is not Verb.FIND:
            self._visited.clear()

    def _act(self, action: str, refusals: dict[str, Refused] | None = None, **args: object) -> None:
        """Act, or refuse with the reason that belongs to the error code."""
        outcome = self._simulator.act(action, **args)
        if not outcome.success:
            if refusals and outcome.code in refusals:
                raise refusals[outcome.code]
            raise Refused(Reason.SIMULATOR, detail=outcome.message)

    # finding

    def _instances(self, object_type: str) -> list[SceneObject]:
        """Return what the noun can mean: objects of the type and its slices, or refuse."""
        sliced = (f"{object_type}Sliced", "EggCracked" if object_type == "Egg" else "")
        things = [o for o in self._scene.objects if o.type == object_type or o.type in sliced]
        if not things:
            raise Refused(Reason.ABSENT)
        return things

    def _find(self, skill: Skill) -> None:
        things = [thing for thing in self._instances(skill.object) if not thing.held]
        if not things:
            raise Refused(Reason.ALREADY_HELD, self._scene.held)
        if self._rules.repeated_find_moves_on:
            fresh = [thing for thing in things if thing.id not in self._visited]
            if not fresh:
                self._visited.clear()
            things = fresh or things
        else:
            self._visited.clear()
        thing = min(things, key=self._effort)
        self._legs.go_to(self._scene, thing)
        self._acted_on = thing
        self._place = thing.id
        self._visited.append(thing.id)

    def _effort(self, thing: SceneObject) -> float:
        """Rank instances: nearest first, closed-in and unseen ones last, slices before wholes.

        The penalties are LoTA-Bench's.
        """
        effort = distance(self._scene.agent.position, thing)
        if self._scene.closed_around(thing):
            effort += 100_000
        if thing.id not in self._scene.visible:
            effort += 1_000
        if thing.type == "StoveBurner" and thing.contents:
            effort += 10_000
        return effort - (100 if thing.type.endswith(("Sliced", "Cracked")) else 0)

    def _in_reach(
        self, things: Sequence[SceneObject], *, ready: Callable[[SceneObject], bool] | None = None
    ) -> SceneObject:
        """Return the instance meant: the one gone to, else the nearest to it that is `ready`."""
        seen = [thing for thing in things if thing.id in self._scene.visible and not thing.held]
        if not seen and (beside := self._legs.turn_to(self._scene, things)):
            return beside
        if seen:
            place = self._scene.by_id.get(self._place)
            gone_to = {self._place}
            if place and (container := self._scene.closed_around(place)):
                gone_to.add(container.id)
            here = place.position if place and not place.held else self._scene.agent.position
            return min(
                seen,
                key=lambda thing: (
                    thing.id not in gone_to,
                    ready is not None and not ready(thing),
                    distance(here, thing),
                ),
            )
        if all(thing.held for thing in things):
            raise Refused(Reason.ALREADY_HELD, self._scene.held)
        nearest = min((thing for thing in things if not thing.held), key=self._effort)
        if container := self._scene.closed_around(nearest):
            raise Refused(Reason.ENCLOSED, container)
        parent = next((p for p in map(self._scene.by_id.get, nearest.parents) if p), None)
        raise Refused(Reason.OUT_OF_REACH, parent)

    # handling

    def _pick_up(self, skill: Skill) -> None:
        things = self._instances(skill.object)
        if self._scene.held:
            raise Refused(Reason.HAND_FULL, self._scene.held)
        thing = self._acted_on = self._in_reach([o for o in things if o.pickupable])
        self._act("PickupObject", objectId=thing.id)

    def _put_down(self, skill: Skill) -> None:
        held = self._scene.held
        if held is None:
            raise Refused(Reason.HAND_EMPTY)
        if self._rules.noun_decides_put_down and held.type not in (
            skill.object,
            f"{skill.object}Sliced",
        ):
            raise Refused(Reason.OTHER_HELD, held)
        self._acted_on = held
        try:
            self._place_in(held)
        except Refused:
            if self._rules.failed_put_down_drops and self._simulator.act("DropHandObject").success:
                self._place = ""
            raise

    def _place_in(self, held: SceneObject) -> None:
        """Put what is held where the robot last went."""
        place = self._scene.by_id.get(self._place)
        if place is None or place.held:
            raise Refused(Reason.NO_PLACE)
        kinds = {place.type}
        place = self._basin(place)
        kinds.add(place.type)
        if not place.receptacle:
            raise Refused(Reason.NOT_A_PLACE, place)
        if place.id not in self._scene.visible and self._legs.turn_to(self._scene, [place]) is None:
            container = self._scene.closed_around(place)
            raise Refused(Reason.CLOSED if container else Reason.NO_PLACE, container)
        belongs = object_type(held.type).belongs
        if not self._rules.places_anything and not any(map(belongs, kinds)):
            raise Refused(Reason.NOT_ALLOWED, place)
        self._act(
            "PutObject",
            {
                "ReceptacleNotOpen": Refused(Reason.CLOSED, place),
                "ReceptacleFull": Refused(Reason.NO_ROOM, place),
            },
            objectId=place.id,
            # Forced, for AI2-THOR 5 refuses what ALFRED does, e.g. a tomato in a microwave.
            forceAction=True,
            placeStationary=True,
        )

    def _basin(self, place: SceneObject) -> SceneObject:
        """Return the basin of a sink or bath, for AI2-THOR puts things into those."""
        basins = self._scene.of_type(BASIN_OF.get(place.type, ""))
        near = [basin for basin in basins if distance(basin.position, place) < CLOSE_ENOUGH]
        return min(near, key=lambda basin: distance(basin.position, place), default=place)

    def _open(self, skill: Skill) -> None:
        thing = self._acted_on = self._in_reach(
            self._instances(skill.object), ready=lambda o: not o.open
        )
        if thing.open:
            raise Refused(Reason.ALREADY_SO, detail="open")
        if thing.on and thing.type == "Microwave":
            raise Refused(Reason.IS_RUNNING)
        self._act("OpenObject", objectId=thing.id)

    def _close(self, skill: Skill) -> None:
        thing = self._acted_on = self._in_reach(
            self._instances(skill.object), ready=lambda o: o.open
        )
        if not thing.open:
            raise Refused(Reason.ALREADY_SO, detail="closed")
        self._act("CloseObject", objectId=thing.id)

    def _slice(self, skill: Skill) -> None:
        things = self._instances(skill.object)
        held = self._scene.held
        if self._rules.knife_to_slice and (held is None or held.type not in KNIVES):
            raise Refused(Reason.NO_KNIFE)
        whole = [thing for thing in things if thing.sliceable]
        if not whole:
            raise Refused(Reason.ALREADY_SO, detail="sliced")
        thing = self._acted_on = self._in_reach(whole)
        self._act("SliceObject", objectId=thing.id)

    def _turn_on(self, skill: Skill) -> None:
        thing = self._acted_on = self._in_reach(
            self._instances(skill.object), ready=lambda o: not o.on
        )
        if thing.on:
            raise Refused(Reason.ALREADY_SO, detail="on")
        if thing.open and thing.type == "Microwave":
            raise Refused(Reason.MUST_BE_SHUT)
        self._act("ToggleObjectOn", objectId=thing.id)

    def _turn_off(self, skill: Skill) -> None:
        thing = self._acted_on = self._in_reach(self._instances(skill.object), ready=lambda o: o.on)
        if not thing.on:
            raise Refused(Reason.ALREADY_SO, detail="off")
        self._act("ToggleObjectOff", objectId=thing.id)
