"""Moving the robot and its camera."""

from typing import Any

from reibench.household.actions import Refused, action
from reibench.household.geometry import footprint, forward
from reibench.household.state import State
from reibench.scene import Vector

LOOK_STEP = 30.0
HIGHEST, LOWEST = -30.0, 60.0
"""How far up and down the camera tilts, in degrees."""


@action("Teleport", changes=False)
def teleport(  # noqa: PLR0913 - the arguments are AI2-THOR's
    state: State,
    position: dict[str, float] | None = None,
    rotation: dict[str, float] | float | None = None,
    horizon: float | None = None,
    standing: bool | None = None,
    forceAction: bool = False,
    x: float | None = None,
    y: float | None = None,
    z: float | None = None,
) -> None:
    """Stand somewhere else; what is left out stays as it is, and the floor is at one height."""
    here = state.agent
    given = position or {}
    target = Vector(
        _first(x, given.get("x"), here.position.x),
        here.position.y,
        _first(z, given.get("z"), here.position.z),
    )
    if not forceAction and target != here.position:
        _require_reachable(state, target)
    yaw = rotation.get("y", here.yaw) if isinstance(rotation, dict) else rotation
    state.agent = here._replace(
        position=target,
        yaw=here.yaw if yaw is None else float(yaw) % 360,
        horizon=here.horizon if horizon is None else float(horizon),
        standing=here.standing if standing is None else bool(standing),
    )


@action("TeleportFull", changes=False)
def teleport_full(  # noqa: PLR0913
    state: State,
    rotation: dict[str, float] | float,
    horizon: float,
    standing: bool,
    position: dict[str, float] | None = None,
    forceAction: bool = False,
    x: float | None = None,
    y: float | None = None,
    z: float | None = None,
) -> None:
    """Stand somewhere else, with everything said."""
    teleport(state, position, rotation, horizon, standing, forceAction, x, y, z)


@action("GetReachablePositions", changes=False)
def get_reachable_positions(state: State, gridSize: float | None = None) -> list[dict[str, float]]:
    """Return the grid positions the robot can get to."""
    floor = state.floor
    if gridSize is not None and gridSize != state.settings.grid:
        floor = state.room.floor_of(gridSize)
    return [point._asdict() for point in floor.points]


@action("MoveAhead", changes=False)
def move_ahead(state: State, moveMagnitude: float | None = None, forceAction: bool = False) -> None:
    """Go ahead, one grid step unless said otherwise."""
    _walk(state, 0, moveMagnitude, forceAction)


@action("MoveBack", changes=False)
def move_back(state: State, moveMagnitude: float | None = None, forceAction: bool = False) -> None:
    """Go back."""
    _walk(state, 180, moveMagnitude, forceAction)


@action("MoveLeft", changes=False)
def move_left(state: State, moveMagnitude: float | None = None, forceAction: bool = False) -> None:
    """Go left."""
    _walk(state, 270, moveMagnitude, forceAction)


@action("MoveRight", changes=False)
def move_right(state: State, moveMagnitude: float | None = None, forceAction: bool = False) -> None:
    """Go right."""
    _walk(state, 90, moveMagnitude, forceAction)


@action("RotateRight", changes=False)
def rotate_right(state: State, degrees: float = 90.0) -> None:
    """Turn right."""
    state.agent = state.agent._replace(yaw=(state.agent.yaw + degrees) % 360)


@action("RotateLeft", changes=False)
def rotate_left(state: State, degrees: float = 90.0) -> None:
    """Turn left."""
    rotate_right(state, -degrees)


@action("LookUp", changes=False)
def look_up(state: State, degrees: float = LOOK_STEP) -> None:
    """Tilt the camera up; this changes no object's visibility here."""
    horizon = state.agent.horizon - degrees
    if horizon < HIGHEST:
        raise Refused("can't look up beyond the allowed limit", "LookUpCantExceedMax")
    state.agent = state.agent._replace(horizon=horizon)


@action("LookDown", changes=False)
def look_down(state: State, degrees: float = LOOK_STEP) -> None:
    """Tilt the camera down."""
    horizon = state.agent.horizon + degrees
    if horizon > LOWEST:
        raise Refused("can't look down beyond the allowed limit", "LookDownCantExceedMin")
    state.agent = state.agent._replace(horizon=horizon)


def _first(*values: float | None) -> float:
    return next(float(value) for value in values if value is not None)


def _require_reachable(state: State, target: Vector) -> None:
    if not footprint(state.room.bounds).covers(target.x, target.z):
        raise Refused(
            "Teleport target out of scene bounds! Ignore this by setting forceAction=true."
        )
    if not state.floor.reaches(target.x, target.z):
        blocker = state.floor.blocker(target.x, target.z) or "what stands around it"
        raise Refused(
            f"Cannot teleport to ({target.x:.2f}, {target.z:.2f}): {blocker} is in the way."
        )


def _walk(state: State, turn: float, magnitude: Any, force: bool) -> None:
    here = state.agent
    far = state.settings.grid if magnitude is None else float(magnitude)
    ahead_x, ahead_z = forward(here.yaw + turn)
    # Rounded so that walking about on the grid does not drift off it.
    x = round(here.position.x + far * ahead_x, 6)
    z = round(here.position.z + far * ahead_z, 6)
    if not force and (blocker := state.floor.blocker(x, z)):
        step = f"({x - here.position.x:.4f}, 0.0000, {z - here.position.z:.4f})"
        raise Refused(f"{blocker} is blocking Agent 0 from moving by {step}.")
    state.agent = here._replace(position=here.position._replace(x=x, z=z))
