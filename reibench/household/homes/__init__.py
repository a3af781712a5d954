"""Homes: rooms made like real ones, in what they hold, how much of it, and where."""

from collections.abc import Callable, Mapping
from random import Random

from reibench.household.habits import Stratum, draw_inventory
from reibench.household.homes.bathroom import furnish_bathroom
from reibench.household.homes.bedroom import furnish_bedroom
from reibench.household.homes.kitchen import furnish_kitchen
from reibench.household.homes.living_room import furnish_living_room
from reibench.household.homes.site import Site
from reibench.household.homes.things import add_things, settle

FURNISHERS: Mapping[str, Callable[[Site], None]] = {
    "kitchen": furnish_kitchen,
    "living room": furnish_living_room,
    "bedroom": furnish_bedroom,
    "bathroom": furnish_bathroom,
}
"""By kind of room. Each raises Cramped when it finds no place for something necessary."""
STRICT = 60
"""Attempts in which everything has to find its place; then some may be left out."""


def draft_home(kind: str, seed: int, attempt: int, stratum: Stratum | None) -> Site:
    """Make one attempt at a home; raises Cramped where it does not work out."""
    inventory = draw_inventory(kind, Random(f"{kind} {seed}"), stratum)
    random = Random(f"home {kind} {seed} {attempt}")
    # A layout that does not fit is given a little more room each time.
    sides = [round(side * (1 + 0.001 * attempt), 1) for side in inventory.sides]
    width, depth = sides if random.random() < 0.5 else reversed(sides)
    site = Site(kind, random, width, depth, inventory=inventory, lenient=attempt >= STRICT)
    FURNISHERS[kind](site)
    site.walk()
    add_things(site)
    settle(site)
    return site
