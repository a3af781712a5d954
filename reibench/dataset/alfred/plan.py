"""ALFRED's expert plans carried out in LoTA-Bench's skills."""

from collections.abc import Generator
from typing import TypeAlias

from reibench.dataset.alfred.trial import PlanAction
from reibench.errors import UnknownSkill
from reibench.scene import CONTAINERS
from reibench.skill import OBJECTS_OF, Skill, Verb
from reibench.worlds import Event

_FINDABLE = {name.lower(): name for name in OBJECTS_OF[Verb.FIND]} | {
    "sinkbasin": "Sink",
    "bathtubbasin": "Bathtub",
}
"""The skills' object types by ALFRED's lower-case names."""
Moves: TypeAlias = Generator[Skill, Event, None]


class PlanInSkills:
    """One trial's expert plan; each event decides what the next skill is.

    ALFRED's high-level actions name no opening and closing: its executor opens what a thing is shut
    in, and shuts it again. So that is added here, where it is so in the restored room.
    """

    def __init__(self, plan: tuple[PlanAction, ...]) -> None:
        self._plan = plan
        self._held = ""
        self._place = ""
        self._opened: list[str] = []

    def moves(self, start: Event) -> Moves:
        """Yield one skill after another, to be sent its event.

        Raises:
            UnknownSkill: at an action that no skill is about.
        """
        self._event = start
        carry_out = {
            "GotoLocation": self._leave,
            "PickupObject": self._pick_up,
            "PutObject": self._put,
            "SliceObject": self._slice,
            "ToggleObject": self._toggle,
            "HeatObject": self._heat,
            "CoolObject": self._cool,
            "CleanObject": self._clean,
            "NoOp": self._leave,
        }
        for action in self._plan:
            if action.name not in carry_out:
                raise UnknownSkill(f"No skill does what ALFRED calls {action.name!r}.")
            yield from carry_out[action.name](action)

    def _do(self, verb: Verb, noun: str) -> Moves:
        self._event = yield _skill(verb, noun)

    def _leave(self, action: PlanAction) -> Moves:
        """Shut what was opened, and remember where to go."""
        while self._opened:
            yield from self._do(Verb.CLOSE, self._opened.pop())
        self._place = _FINDABLE.get(action.object, "")

    def _go_to(self, noun: str) -> Moves:
        """Go to a thing and open what hides it, or it, if things go into it."""
        yield from self._do(Verb.FIND, noun)
        if kind := _shut_nearby(self._event, noun):
            yield from self._do(Verb.OPEN, kind)
            self._opened.append(kind)

    def _pick_up(self, action: PlanAction) -> Moves:
        # From where the plan goes to, the thing it means is the nearest of its type.
        if self._place and self._place != action.object:
            yield from self._do(Verb.FIND, self._place)
        self._place = ""
        yield from self._go_to(action.object)
        yield from self._do(Verb.PICK_UP, action.object)
        self._held = action.object

    def _put(self, action: PlanAction) -> Moves:
        yield from self._go_to(action.receptacle)
        yield from self._do(Verb.PUT_DOWN, self._held)
        self._held = ""

    def _slice(self, action: PlanAction) -> Moves:
        yield from self._go_to(action.object)
        yield from self._do(Verb.SLICE, action.object)

    def _toggle(self, action: PlanAction) -> Moves:
        yield from self._do(Verb.FIND, action.object)
        yield from self._do(Verb.TURN_ON, action.object)

    def _heat(self, _: PlanAction) -> Moves:
        yield from self._treat("Microwave", Verb.TURN_ON, Verb.TURN_OFF)

    def _cool(self, _: PlanAction) -> Moves:
        yield from self._treat("Fridge")

    def _treat(self, machine: str, *switching: Verb) -> Moves:
        """Put what is held into a machine that has to be shut, and take it out again."""
        yield from self._go_to(machine)
        yield from self._do(Verb.PUT_DOWN, self._held)
        for verb in (Verb.CLOSE, *switching, Verb.OPEN):
            yield from self._do(verb, machine)
        yield from self._do(Verb.PICK_UP, self._held)

    def _clean(self, action: PlanAction) -> Moves:
        yield from self._do(Verb.FIND, action.object)
        yield from self._do(Verb.PUT_DOWN, self._held)
        yield from self._do(Verb.TURN_ON, "Faucet")
        yield from self._do(Verb.TURN_OFF, "Faucet")
        yield from self._do(Verb.PICK_UP, self._held)


def _shut_nearby(event: Event, noun: str) -> str:
    """Return the type of what must be opened at a `noun` just gone to; empty if nothing must."""
    scene = event.scene
    things = [thing for thing in scene.objects if thing.type in (noun, f"{noun}Sliced")]
    seen = [thing for thing in things if thing.id in scene.visible]
    if noun in CONTAINERS:
        return noun if any(thing.openable and not thing.open for thing in seen) else ""
    around = [] if seen else [scene.closed_around(thing) for thing in things]
    return next((each.type for each in around if each and each.id in scene.visible), "")


def _skill(verb: Verb, noun: str) -> Skill:
    name = noun.removesuffix("Basin") if noun in ("SinkBasin", "BathtubBasin") else noun
    if name not in OBJECTS_OF[verb]:
        raise UnknownSkill(f"No skill is to {verb.value} a {name or 'thing without a name'}.")
    return Skill(verb, name)
