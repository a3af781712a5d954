"""The rooms that come with the project: what each is asked to be."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from reibench.household.habits import Stratum
from reibench.household.objects import ROOM_KINDS


@dataclass(frozen=True)
class Plan:
    """What a room is generated from."""

    kind: str
    seed: int
    require: tuple[str, ...] = ()
    closed: bool = False
    """Whether no other optional or small types may appear: the dialogues written for a room
    speak of what is in it, and of nothing else."""
    where: Mapping[str, str] = field(default_factory=dict)
    """Where some types start. Opening something is needed for the potato and the credit card."""
    stratum: Stratum | None = None
    """For a room made like real ones: which of how many of its kind it is."""


_KITCHEN = (
    "Apple Bowl Bread Cabinet CoffeeMachine CounterTop Cup DishSponge Drawer Egg Faucet Fork Fridge"
    " GarbageCan Knife Lettuce Microwave Mug Pan PepperShaker Plate Pot Potato SaltShaker Sink"
    " SoapBottle Spoon StoveBurner Toaster Tomato Window"
)
_LIVING_ROOM = (
    "ArmChair Box CoffeeTable CreditCard Drawer FloorLamp GarbageCan HousePlant KeyChain Laptop"
    " Newspaper Painting Pillow RemoteControl SideTable Sofa Statue Television TVStand Vase Watch"
    " Window"
)
_BEDROOM = (
    "AlarmClock BaseballBat Bed Bowl CD CellPhone Chair CreditCard Desk DeskLamp Drawer GarbageCan"
    " KeyChain Laptop Mirror Mug Painting Pen Pencil Pillow Shelf TissueBox Window"
)

_WRITTEN: Mapping[str, Plan] = {
    "kitchen-1": Plan(
        "kitchen",
        1,
        (*_KITCHEN.split(), "HousePlant", "Spatula"),
        closed=True,
        where={"Lettuce": "CounterTop", "Egg": "Fridge", "Fork": "Drawer", "Cup": "Cabinet"},
    ),
    "kitchen-2": Plan(
        "kitchen",
        2,
        (*_KITCHEN.split(), "ButterKnife", "Chair", "DiningTable", "Kettle"),
        closed=True,
        where={
            "Apple": "DiningTable",
            "Potato": "CounterTop",
            "Tomato": "CounterTop",
            "Spoon": "Drawer",
            "Plate": "Cabinet",
        },
    ),
    "living-room-1": Plan(
        "living room",
        1,
        tuple(_LIVING_ROOM.split()),
        closed=True,
        where={"KeyChain": "CoffeeTable", "Watch": "Drawer", "Laptop": "SideTable"},
    ),
    "living-room-2": Plan(
        "living room",
        2,
        (*_LIVING_ROOM.split(), "Book", "Curtains", "Plate", "TissueBox"),
        closed=True,
        where={"CreditCard": "CoffeeTable", "KeyChain": "Drawer"},
    ),
    "bedroom-1": Plan(
        "bedroom",
        1,
        tuple(_BEDROOM.split()),
        closed=True,
        where={"BaseballBat": "Floor", "CD": "Drawer", "Mug": "Desk", "Pencil": "Desk"},
    ),
    "bedroom-2": Plan("bedroom", 2, ("Desk", "Dresser", "Mirror", "SideTable")),
    "bathroom-1": Plan("bathroom", 1, ("Bathtub", "Cabinet")),
    "bathroom-2": Plan("bathroom", 2, ("Drawer", "Shelf")),
}
"""The rooms the shipped dialogues were written for; results were measured in them, so that they
stay as they are."""

HOMES = 28
"""Rooms of each kind that are made like real ones."""

FIRST = 3
"""The number of the first of them; those before it were written for dialogues."""

SEEDS = {"kitchen-29": 203, "bedroom-23": 207}
"""Seeds of rooms whose usual one leaves little room to put a box, or icons too close to draw."""


def _home(kind: str, index: int) -> tuple[str, Plan]:
    name = f"{kind.replace(' ', '-')}-{index + FIRST}"
    seed = SEEDS.get(name, 200 + index + FIRST)
    return name, Plan(kind, seed, stratum=Stratum(index, HOMES))


PLANS: Mapping[str, Plan] = {
    **_WRITTEN,
    **dict(_home(kind, index) for kind in ROOM_KINDS for index in range(HOMES)),
}
"""By name of the room."""
