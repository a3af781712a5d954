"""The robot's legs and neck: going where a thing can be seen, and turning to it."""

from collections.abc import Sequence

from reibench.scene import Pose, Scene, SceneObject, Vector
from reibench.worlds.approach import CLOSE_ENOUGH, REACH, distance, facing
from reibench.worlds.rules import Reason, Refused
from reibench.worlds.simulator import Simulator

POSES_TRIED = 20
"""How many of the nearest free places `find` tries (LoTA-Bench)."""


class Legs:
    """Moves the robot about one room."""

    def __init__(self, simulator: Simulator) -> None:
        self._simulator = simulator
        self._nearest: dict[Vector, list[Vector]] = {}

    def go_to(self, scene: Scene, thing: SceneObject) -> None:
        """Stand by `thing` where it, or the closed container it is in, can be seen.

        Raises:
            Refused: when no such place is found; the robot is where it was.
        """
        shown = scene.closed_around(thing) or thing
        before = scene.agent
        if shown.id in scene.visible and distance(before.position, thing) < CLOSE_ENOUGH:
            return
        for place in self._places_near(thing):
            if self.stand(facing(place, thing)) and self._simulator.sees(shown.id):
                return
        self.stand(before)
        raise Refused(Reason.UNREACHABLE)

    def turn_to(self, scene: Scene, things: Sequence[SceneObject]) -> SceneObject | None:
        """Turn to the nearest of `things` that can be seen from here, if any can.

        Close to wide furniture, what stands at its other end is out of the camera's view.
        """
        here = scene.agent.position
        near = [o for o in things if not o.held and distance(here, o) <= REACH]
        loose = [thing for thing in near if not scene.closed_around(thing)]
        for thing in sorted(loose, key=lambda thing: distance(here, thing)):
            if self.stand(facing(here, thing)) and self._simulator.sees(thing.id):
                return thing
        return None

    def stand(self, pose: Pose) -> bool:
        """Take a pose; false if it is not free."""
        return self._simulator.act(
            "Teleport",
            position={"x": pose.position.x, "y": pose.position.y, "z": pose.position.z},
            rotation={"x": 0.0, "y": pose.yaw, "z": 0.0},
            horizon=pose.horizon,
            standing=pose.standing,
        ).success

    def _places_near(self, thing: SceneObject) -> list[Vector]:
        center = thing.box.center
        if center not in self._nearest:
            ranked = sorted(self._simulator.reachable(), key=lambda place: distance(place, thing))
            self._nearest[center] = ranked[:POSES_TRIED]
        return self._nearest[center]
