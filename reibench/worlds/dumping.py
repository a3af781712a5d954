"""Dumps: a room's object metadata, and where the robot can stand, for `import ithor` to read."""

from typing import Any

from reibench.household.ithor import STANDING_KEY
from reibench.worlds.simulator import Simulator

ITHOR = tuple(
    f"FloorPlan{first + number}" for first in (0, 200, 300, 400) for number in range(1, 31)
)
"""Names of AI2-THOR's 120 iTHOR rooms."""


def dump(simulator: Simulator, room: str) -> dict[str, Any]:
    """Return object metadata by object id, as at load time, and the places to stand.

    Raises:
        UnknownName: when the simulator has no such room.
        WorldBroken: when it does not answer.
    """
    simulator.load(room)
    described = {each["objectId"]: each for each in simulator.metadata()["objects"]}
    return described | {STANDING_KEY: [place._asdict() for place in simulator.reachable()]}
