"""Clear instructions in one form for each type of task: what a taught model restates into."""

from functools import lru_cache

from reibench.dialogue import Dialogue
from reibench.episode import Goal, TaskType
from reibench.goals import preposition
from reibench.methods.wording import conversation
from reibench.skill import PICKABLE, RECEPTACLES, in_words

FORMS = {
    TaskType.PICK: "Put {object} {at}.",
    TaskType.STACK: "Put {object} {within} and put {movable} {at}.",
    TaskType.CLEAN: "Wash {object} and put it {at}.",
    TaskType.HEAT: "Heat {object} and put it {at}.",
    TaskType.COOL: "Cool {object} and put it {at}.",
    TaskType.EXAMINE: "Look at {object} under {lamp}.",
}
"""One a task type; things and places stand in them under their names among the skills."""
LAMPS = ("DeskLamp", "FloorLamp")
HOLDERS = ("Bowl", "Box", "Cup", "Mug", "Pan", "Plate", "Pot")
LABEL = "Clear instruction:"


def question(dialogue: Dialogue) -> str:
    """Return what a taught model is asked: what was said, and a label for the answer."""
    return f"{conversation(dialogue)}\n{LABEL}"


def called(object_type: str) -> str:
    """Return what a thing or place is called in a clear instruction, with its article."""
    return f"the {'bottle' if object_type == 'Bottle' else in_words(object_type)}"


def clear(goal: Goal) -> str:
    """Return the clear instruction for `goal`."""
    movable = goal.movable_receptacle
    return FORMS[goal.task_type].format(
        object=called(goal.object),
        at=_at(goal.destination),
        lamp=called(goal.destination),
        within=_at(movable) if movable else "",
        movable=called(movable) if movable else "",
    )


def _at(place: str) -> str:
    return f"{preposition(place)} {called(place)}"


@lru_cache(maxsize=1)
def grammar() -> str:
    """Return a GBNF grammar of every clear instruction, after the label and a space."""
    slots = {
        "object": "object",
        "at": "at",
        "lamp": "lamp",
        "within": "within",
        "movable": "movable",
    }
    forms = []
    for form in FORMS.values():
        parts: list[str] = []
        rest = form
        while "{" in rest:
            before, _, rest = rest.partition("{")
            slot, _, rest = rest.partition("}")
            parts += [_quoted(before), slots[slot]] if before else [slots[slot]]
        forms.append(" ".join([*parts, _quoted(rest)]))
    rules = {
        "root": f'" " ( {" | ".join(forms)} )',
        "object": _either(map(called, PICKABLE)),
        "movable": _either(map(called, HOLDERS)),
        "within": _either(map(_at, HOLDERS)),
        "at": _either(map(_at, RECEPTACLES)),
        "lamp": _either(map(called, LAMPS)),
    }
    return "\n".join(f"{name} ::= {rule}" for name, rule in rules.items())


def _either(texts: "map[str]") -> str:
    return " | ".join(map(_quoted, texts))


def _quoted(text: str) -> str:
    return f'"{text}"'
