"""Furniture: how each kind of room is furnished, before small things are put in it."""

from collections.abc import Callable, Mapping

from reibench.household.furnishing.bathroom import furnish_bathroom
from reibench.household.furnishing.bedroom import furnish_bedroom
from reibench.household.furnishing.kitchen import furnish_kitchen
from reibench.household.furnishing.living_room import furnish_living_room
from reibench.household.layout import Draft

FURNISHERS: Mapping[str, Callable[[Draft], None]] = {
    "kitchen": furnish_kitchen,
    "living room": furnish_living_room,
    "bedroom": furnish_bedroom,
    "bathroom": furnish_bathroom,
}
"""By kind of room. Each raises Cramped when it finds no place for something necessary."""
