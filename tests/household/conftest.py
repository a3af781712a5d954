"""A robot that walks up to things, for the tests of the simulator."""

from collections.abc import Callable
from math import atan2, degrees

import pytest

from reibench.household import Controller, Event
from reibench.scene import SceneObject


class Robot:
    """Drives a controller in a few words."""

    def __init__(self, controller: Controller) -> None:
        self.controller = controller

    def find(self, kind: str, number: int = 0) -> SceneObject:
        return self.controller.snapshot().of_type(kind)[number]

    def now(self, thing: SceneObject) -> SceneObject:
        return self.controller.snapshot().by_id[thing.id]

    def go(self, thing: SceneObject, *, away: bool = False) -> None:
        """Stand as near to a thing as possible and look at it, or away from it."""
        middle, size = self.now(thing).box

        def distance(point):
            dx = max(abs(point.x - middle.x) - size.x / 2, 0)
            dz = max(abs(point.z - middle.z) - size.z / 2, 0)
            return dx * dx + dz * dz

        point = min(self.controller.reachable(), key=distance)
        yaw = degrees(atan2(middle.x - point.x, middle.z - point.z)) + (180 if away else 0)
        assert self("Teleport", position=point._asdict(), rotation=yaw).success

    def do(self, action: str, thing: SceneObject, **arguments) -> Event:
        """Walk up to a thing and act on it; it has to work."""
        self.go(thing)
        event = self(action, objectId=thing.id, **arguments)
        assert event.success, event.message
        return event

    def reveal(self, thing: SceneObject) -> None:
        """Open whatever closed thing it is inside."""
        around = self.controller.snapshot().closed_around(self.now(thing))
        if around:
            self.do("OpenObject", around)

    def fetch(self, kind: str) -> SceneObject:
        thing = self.find(kind)
        self.reveal(thing)
        self.do("PickupObject", thing)
        return thing

    def __call__(self, action: str, **arguments) -> Event:
        return self.controller.step(action, **arguments)


@pytest.fixture
def enter() -> Callable[[str], Robot]:
    return lambda room: Robot(Controller(room))


@pytest.fixture
def robot(enter) -> Robot:
    return enter("kitchen-1")
