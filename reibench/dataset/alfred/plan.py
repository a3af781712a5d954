"""ALFRED's expert plans as skills of LoTA-Bench."""

from collections.abc import Iterator

from reibench.dataset.alfred.trial import PlanAction, Trial
from reibench.errors import UnknownSkill
from reibench.scene import CONTAINERS
from reibench.skill import OBJECTS_OF, Skill, Verb


def skills_of(trial: Trial) -> tuple[Skill, ...]:
    """Return the trial's expert plan in skills.

    ALFRED's plan does not name the opening and closing that its executor adds around what is in
    a closed place; here they are named.

    Raises:
        UnknownSkill: when the plan acts on something that no skill is about.
    """
    return tuple(_translated(trial.plan))


def _translated(plan: tuple[PlanAction, ...]) -> Iterator[Skill]:
    place = held = ""
    for action in plan:
        match action.name:
            case "GotoLocation":
                place = action.object
            case "PickupObject":
                yield from _reaching(action.object, place, Verb.PICK_UP, action.object)
                held = action.object
            case "PutObject":
                yield from _reaching(action.receptacle, place, Verb.PUT_DOWN, held)
                held = ""
            case "SliceObject":
                yield from _reaching(action.object, place, Verb.SLICE, action.object)
            case "ToggleObject":
                yield from _reaching(action.object, place, Verb.TURN_ON, action.object)
            case "HeatObject":
                yield from _treating("Microwave", held, (Verb.TURN_ON, Verb.TURN_OFF))
            case "CoolObject":
                yield from _treating("Fridge", held, ())
            case "CleanObject":
                yield from _cleaning(action.object, held)
            case "NoOp":
                pass
            case other:
                raise UnknownSkill(f"No skill does what ALFRED calls {other!r}.")


def _reaching(target: str, place: str, verb: Verb, noun: str) -> Iterator[Skill]:
    """Go to a thing and do something there, opening what ALFRED's robot went to for it."""
    shut = next((kind for kind in CONTAINERS if kind.lower() == place), "")
    around = [] if shut not in OBJECTS_OF[Verb.OPEN] else [shut]
    yield _skill(Verb.FIND, target)
    yield from (_skill(Verb.OPEN, kind) for kind in around)
    yield _skill(verb, noun)
    yield from (_skill(Verb.CLOSE, kind) for kind in around)


def _treating(machine: str, held: str, switching: tuple[Verb, ...]) -> Iterator[Skill]:
    """Put what is held into a machine that has to be shut, and take it out again."""
    yield _skill(Verb.FIND, machine)
    yield _skill(Verb.OPEN, machine)
    yield _skill(Verb.PUT_DOWN, held)
    yield _skill(Verb.CLOSE, machine)
    yield from (_skill(verb, machine) for verb in switching)
    yield _skill(Verb.OPEN, machine)
    yield _skill(Verb.PICK_UP, held)
    yield _skill(Verb.CLOSE, machine)


def _cleaning(basin: str, held: str) -> Iterator[Skill]:
    yield _skill(Verb.FIND, basin)
    yield _skill(Verb.PUT_DOWN, held)
    yield _skill(Verb.TURN_ON, "Faucet")
    yield _skill(Verb.TURN_OFF, "Faucet")
    yield _skill(Verb.PICK_UP, held)


def _skill(verb: Verb, noun: str) -> Skill:
    name = noun.removesuffix("Basin") if noun in ("SinkBasin", "BathtubBasin") else noun
    if name not in OBJECTS_OF[verb]:
        raise UnknownSkill(
            f"No skill says {verb.value!r} of a {name or 'thing that is not named'}."
        )
    return Skill(verb, name)
