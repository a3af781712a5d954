"""The controller: AI2-THOR 5's, without Unity."""

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from reibench.household.actions import Action, Refused, known_actions
from reibench.household.effects import take_effect
from reibench.household.metadata import agent_metadata
from reibench.household.rooms import Room, load_room
from reibench.household.state import Moment, Settings, State
from reibench.scene import Scene, Vector

MISUSE = frozenset(("InvalidAction", "MissingArguments", "AmbiguousAction", "InvalidArgument"))
"""Error codes at which AI2-THOR's client raises."""


@dataclass(frozen=True)
class Event:
    """What came of an action; it stays as it is when the room goes on changing."""

    action: str
    success: bool
    message: str
    """AI2-THOR's `errorMessage`; empty if it worked."""
    code: str
    """AI2-THOR's `errorCode`; empty if it worked, and for failures AI2-THOR has no code for."""
    action_return: Any
    moment: Moment = field(repr=False)
    time: int
    """How many actions had been carried out since the room was set up."""
    screen: tuple[int, int] = (300, 300)

    @cached_property
    def metadata(self) -> dict[str, Any]:
        """AI2-THOR 5's metadata of the moment after the action, made when first asked for."""
        width, height = self.screen
        found = agent_metadata(self.moment, width=width, height=height)
        return found | {
            "lastAction": self.action,
            "lastActionSuccess": self.success,
            "errorMessage": self.message,
            "errorCode": self.code,
            "currentTime": float(self.time),
            "actionReturn": self.action_return,
        }


class Controller:
    """A room and a robot in it, driven by AI2-THOR's actions."""

    def __init__(
        self,
        scene: str | Room = "kitchen-1",
        *,
        gridSize: float = 0.25,
        visibilityDistance: float = 1.5,
        fieldOfView: float = 90.0,
        width: int = 300,
        height: int = 300,
    ) -> None:
        """Set up `scene`, the name of a room, its file, or a room; lengths are in metres.

        Raises:
            UnknownName: when there is no such room.
            InvalidRoom: when its file is damaged.
        """
        self._screen = width, height
        self._actions = known_actions()
        self._room = scene if isinstance(scene, Room) else load_room(scene)
        self._state = State(self._room, Settings(gridSize, visibilityDistance, fieldOfView))
        self.last_event = self.reset()

    @property
    def room(self) -> Room:
        """The room as it was before anything happened."""
        return self._room

    def reset(self, scene: str | Room | None = None) -> Event:
        """Start afresh, in another room if `scene` names or is one."""
        if scene is not None:
            self._room = scene if isinstance(scene, Room) else load_room(scene)
        self._state = State(self._room, self._state.settings)
        take_effect(self._state)
        return self._event("Reset")

    def step(self, action: str | dict[str, Any], **arguments: Any) -> Event:
        """Carry out an action; one that cannot be done is an event without success.

        Raises:
            ValueError: when there is no such action, or its arguments are not as they should be,
                like AI2-THOR's client; `last_event` then says so too.
        """
        if not isinstance(action, str):
            arguments = {**action, **arguments}
            action = str(arguments.pop("action", ""))
        known = self._actions.get(action)
        if known is None:
            if action == "Reset":
                return self.reset(arguments.get("sceneName"))
            raise self._misuse(action, "InvalidAction", f"Invalid action: {action!r}.")
        self._check_arguments(known, arguments)
        return self._carry_out(known, arguments)

    def stop(self) -> None:
        """Do nothing: there is no process to end."""

    def snapshot(self) -> Scene:
        """Return the scene as it is now."""
        return self._state.moment().scene

    def sees(self, object_id: str) -> bool:
        """Whether the robot sees that object now."""
        return self._state.sees(object_id)

    def reachable(self) -> tuple[Vector, ...]:
        """Return the grid positions the robot can get to."""
        return self._state.floor.points

    def _carry_out(self, known: Action, arguments: dict[str, Any]) -> Event:
        state = self._state
        state.time += 1
        if not known.ignored.isdisjoint(arguments):
            arguments = {key: arguments[key] for key in arguments if key not in known.ignored}
        try:
            answer = known.function(state, **arguments)
        except Refused as refused:
            if refused.code in MISUSE:
                raise self._misuse(known.name, refused.code, refused.message) from None
            return self._event(known.name, refused.message, refused.code)
        if known.changes:
            take_effect(state)
        return self._event(known.name, answer=answer)

    def _check_arguments(self, known: Action, arguments: dict[str, Any]) -> None:
        extra = set(arguments) - known.arguments - known.ignored
        if extra and not known.anything:
            could = ", ".join(sorted(known.arguments)) or "none"
            message = f"Invalid argument: {', '.join(sorted(extra))} for action {known.name}."
            message += f" It takes: {could}."
            raise self._misuse(known.name, "InvalidArgument", message)
        if not known.required.issubset(arguments):
            missing = ", ".join(sorted(known.required - set(arguments)))
            message = f"Missing arguments for action {known.name}: {missing}."
            raise self._misuse(known.name, "MissingArguments", message)

    def _misuse(self, action: str, code: str, message: str) -> ValueError:
        self._event(action, message, code)
        return ValueError(message)

    def _event(
        self, action: str, message: str = "", code: str = "", answer: object = None
    ) -> Event:
        self.last_event = Event(
            action,
            not message,
            message,
            code,
            answer,
            self._state.moment(),
            self._state.time,
            self._screen,
        )
        return self.last_event
