"""Object types: what each AI2-THOR 5 type can do, how big it is and where it may be put.

The table beside this module holds medians over the 120 iTHOR rooms and the placement rules of
AI2-THOR 5 and of ALFRED.
"""

import csv
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from reibench.errors import unknown
from reibench.scene import CONTAINERS, Vector

TRAITS = (
    "receptacle pickupable moveable openable toggleable sliceable breakable dirtyable fillable"
    " cookable heat_source cold_source"
).split()
"""What a type can be; all but `receptacle` are also fields of `SceneObject`."""

ROOM_KINDS = ("kitchen", "living room", "bedroom", "bathroom")

SURFACES = frozenset(
    "ArmChair Bed Chair CoffeeTable CounterTop Desk DiningTable DogBed Dresser Floor Footstool"
    " Ottoman Shelf SideTable Sofa Stool StoveBurner TVStand Toilet Plate".split()
)
"""Receptacles that hold things on top rather than inside."""

SINGLE = frozenset(
    "CoffeeMachine HandTowelHolder StoveBurner Toaster ToiletPaperHanger TowelHolder".split()
)
"""Receptacles that hold one thing."""

SOURCES = frozenset("CoffeeMachine Faucet Fridge Microwave StoveBurner Toaster".split())
"""Types that act by themselves on what is in, on or under them."""

SLICES = {"Apple": 5, "Bread": 6, "Lettuce": 5, "Potato": 5, "Tomato": 5}
"""Into how many pieces a thing is cut; AI2-THOR's numbers vary by model."""


@dataclass(frozen=True)
class ObjectType:
    """One object type."""

    name: str
    traits: frozenset[str]
    """Those of `TRAITS` that hold for at least half of the real instances."""
    size: Vector
    """Median extent along x, y, z in metres; rotated instances blur x and z."""
    mass: float
    """Kilograms; 0 for what is built in."""
    materials: tuple[str, ...]
    opens_by_default: bool
    on_by_default: bool
    rooms: tuple[int, ...]
    """In how many of AI2-THOR's 30 rooms of each of `ROOM_KINDS` it occurs."""
    found_on: tuple[tuple[str, int], ...]
    """Receptacle types instances were found on, with how often."""
    thor_receptacles: frozenset[str]
    """Where AI2-THOR 5 lets it be put."""
    alfred_receptacles: frozenset[str]
    """Where ALFRED's tasks put it, by force if AI2-THOR refuses."""

    @property
    def encloses(self) -> bool:
        """Whether it hides what it holds while closed, and must be open to be put into."""
        return self.name in CONTAINERS

    def may_go(self, receptacle: str) -> bool:
        """Whether AI2-THOR 5 lets this type be put in or on `receptacle`, unforced."""
        return receptacle in self.thor_receptacles

    def belongs(self, receptacle: str) -> bool:
        """Whether AI2-THOR 5 or ALFRED puts this type in or on `receptacle`."""
        return receptacle in self.thor_receptacles or receptacle in self.alfred_receptacles


def object_type(name: str) -> ObjectType:
    """Return the object type called `name`; raises UnknownName."""
    try:
        return object_types()[name]
    except KeyError:
        raise unknown("object type", name, object_types(), most=12) from None


@lru_cache(maxsize=1)
def object_types() -> dict[str, ObjectType]:
    """Return every object type by name."""
    with Path(__file__).with_name("objects.csv").open(encoding="utf-8", newline="") as file:
        return {row["type"]: _read(row) for row in csv.DictReader(file)}


def type_of(object_id: str) -> str:
    """Return the type an id stands for: `Sink|…|SinkBasin` and `Apple|…|AppleSliced_0` too."""
    parts = object_id.split("|")
    return parts[0] if len(parts) < 5 else parts[4].partition("_")[0]


def _read(row: dict[str, str]) -> ObjectType:
    size = [float(part) for part in row["size"].split("x")] if row["size"] else [0.1, 0.1, 0.1]
    found = (pair.split(":") for pair in _listed(row["found_on"]))
    return ObjectType(
        name=row["type"],
        traits=frozenset(_listed(row["traits"])),
        size=Vector(*size),
        mass=float(row["mass"] or 0),
        materials=tuple(_listed(row["materials"])),
        opens_by_default=row["opens_by_default"] == "1",
        on_by_default=row["on_by_default"] == "1",
        rooms=tuple(int(row[kind.replace(" ", "_") + "s"]) for kind in ROOM_KINDS),
        found_on=tuple((name, int(count)) for name, count in found),
        thor_receptacles=frozenset(_listed(row["thor_receptacles"])),
        alfred_receptacles=frozenset(_listed(row["alfred_receptacles"])),
    )


def _listed(cell: str) -> list[str]:
    return cell.split("|") if cell else []
