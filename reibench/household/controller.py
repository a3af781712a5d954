"""The controller: AI2-THOR 5's, without Unity."""

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from reibench.errors import UnknownName
from reibench.household.actions import Action, Refused, known_actions
from reibench.household.effects import take_effect
from reibench.household.metadata import agent_metadata, object_metadata
from reibench.household.rooms import Room, load_room
from reibench.household.scenes import room_name
from reibench.household.state import Moment, Settings, State
from reibench.scene import Scene, Vector

MISUSE = frozenset(("InvalidAction", "MissingArguments", "AmbiguousAction", "InvalidArgument"))
"""Error codes at which AI2-THOR's client raises."""


class Misuse(ValueError):
    """No such action, or arguments it does not take; AI2-THOR's client raises ValueError."""


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

    @cached_property
    def metadata(self) -> dict[str, Any]:
        """AI2-THOR 5's metadata of the moment after the action, made when first asked for."""
        moment = self.moment
        return {"objects": [object_metadata(moment, one) for one in moment.scene.objects]} | (
            self.bare_metadata()
        )

    def bare_metadata(self) -> dict[str, Any]:
        """Return the metadata without the objects."""
        return agent_metadata(self.moment) | {
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
        self._actions = known_actions()
        self._room = scene if isinstance(scene, Room) else load_room(room_name(scene))
        screen = width, height
        self._state = State(self._room, Settings(gridSize, visibilityDistance, fieldOfView, screen))
        self.last_event = self.reset()

    @property
    def room(self) -> Room:
        """The room as it was before anything happened."""
        return self._room

    def reset(self, scene: str | Room | None = None) -> Event:
        """Start afresh, in another room if `scene` names or is one."""
        if scene is not None:
            self._room = scene if isinstance(scene, Room) else load_room(room_name(scene))
        self._state = State(self._room, self._state.settings)
        take_effect(self._state)
        return self._event("Reset")

    def step(self, action: str | dict[str, Any], **arguments: Any) -> Event:
        """Carry out an action; one that cannot be done is an event without success.

        Raises:
            Misuse: when there is no such action, or its arguments are not as they should be; a
                ValueError, as AI2-THOR's client raises; `last_event` then says so too.
        """
        if not isinstance(action, str):
            arguments = {**action, **arguments}
            action = str(arguments.pop("action", ""))
        known = self._actions.get(action)
        if known is None:
            if action == "Reset":
                return self._reset_to(arguments.get("sceneName"))
            raise self._misuse(action, "InvalidAction", f"Invalid action: {action}")
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

    def _reset_to(self, scene: str | Room | None) -> Event:
        try:
            return self.reset(scene)
        except UnknownName as error:
            raise self._misuse("Reset", "InvalidArgument", str(error)) from None

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
            missing = ",".join(sorted(known.required - set(arguments)))
            message = f"action: {known.name} is missing the following arguments: {missing}"
            raise self._misuse(known.name, "MissingArguments", message)
        for name, value in arguments.items():
            kind = known.kinds.get(name)
            if kind is not None and not kind.takes(value):
                message = f"action: {known.name} has an invalid argument: {name} (=={value!r})."
                message += f" Cannot convert to: {kind.name}"
                raise self._misuse(known.name, "InvalidArgument", message)

    def _misuse(self, action: str, code: str, message: str) -> Misuse:
        self._event(action, message, code)
        return Misuse(message)

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
        )
        return self.last_event
