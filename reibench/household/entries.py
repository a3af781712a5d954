"""Entries of room files: one object each, saying only what its id and type do not."""

from collections.abc import Callable
from typing import Any, TypeAlias
from zlib import crc32

from reibench.household.objects import TRAITS, object_type, type_of
from reibench.scene import Box, SceneObject, Vector

STATES = ("open", "on", "dirty", "filled", "broken", "cooked")
Numbers: TypeAlias = Callable[..., list[float]]
"""Makes a list of numbers as they are written: rounded, or exact."""


def name_of(object_id: str) -> str:
    """Return an object name like AI2-THOR's: the type and eight digits, here made of the id."""
    return f"{type_of(object_id)}_{crc32(object_id.encode()):08x}"


def rounded(*values: float) -> list[float]:
    """Round to a tenth of a millimetre, so that files can be compared."""
    return [int(value) if value == int(value) else round(value, 4) for value in values]


def exact(*values: float) -> list[float]:
    """Leave numbers as they are, as what was measured in AI2-THOR is."""
    return list(values)


def read_object(entry: dict[str, Any]) -> SceneObject:
    """Read an object; what it holds is left to `with_contents`."""
    kind = object_type(type_of(entry["id"]))
    traits = frozenset(entry.get("traits", kind.traits))
    return SceneObject(
        id=entry["id"],
        type=kind.name,
        name=entry.get("name") or name_of(entry["id"]),
        position=Vector(*map(float, entry["at"])),
        yaw=float(entry.get("yaw", 0)),
        box=read_box(entry["box"]),
        parents=tuple(entry.get("in", ())),
        contents=tuple(entry.get("holds", ())) if "receptacle" in traits else None,
        liquid=entry.get("liquid", ""),
        temperature=entry.get("temperature", "RoomTemp"),
        **{trait: trait in traits for trait in TRAITS[1:]},
        **{state: bool(entry.get(state, False)) for state in STATES},
    )


def describe_object(thing: SceneObject, numbers: Numbers = rounded) -> dict[str, Any]:
    """Say only what its id and type do not."""
    entry: dict[str, Any] = {"id": thing.id, "at": numbers(*thing.position)}
    entry["box"] = numbers(*thing.box.center, *thing.box.size)
    if thing.yaw:
        entry["yaw"] = numbers(thing.yaw)[0]
    if thing.parents:
        entry["in"] = list(thing.parents)
    if thing.name != name_of(thing.id):
        entry["name"] = thing.name
    traits = {trait for trait in TRAITS[1:] if getattr(thing, trait)}
    traits |= {"receptacle"} if thing.receptacle else set()
    if traits != object_type(thing.type).traits:
        entry["traits"] = sorted(traits)
    entry |= {state: True for state in STATES if getattr(thing, state)}
    if thing.liquid:
        entry["liquid"] = thing.liquid
    if thing.temperature != "RoomTemp":
        entry["temperature"] = thing.temperature
    return entry


def read_box(numbers: list[float]) -> Box:
    """Read a box's centre and size, six numbers."""
    x, y, z, width, height, depth = map(float, numbers)
    return Box(Vector(x, y, z), Vector(width, height, depth))
