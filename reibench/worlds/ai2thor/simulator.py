"""AI2-THOR behind its own client, as the skill layer wants it."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from reibench.errors import InvalidRoom, WorldBroken
from reibench.household import scene_from_metadata
from reibench.scene import Scene, Vector
from reibench.worlds import Frame
from reibench.worlds.ai2thor.builds import STAND_IN
from reibench.worlds.ai2thor.conversation import Conversation
from reibench.worlds.ai2thor.settings import UnitySettings
from reibench.worlds.simulator import Outcome

if TYPE_CHECKING:
    from reibench.worlds.ai2thor.client import Client

T = TypeVar("T")


class UnitySimulator:
    """One Unity process, started when a room is first loaded and again when it has broken."""

    def __init__(self, variant: str, settings: UnitySettings, *, frames: bool) -> None:
        """Prepare for a resolved variant; with `frames`, every action is rendered."""
        self._variant = variant
        self._settings = settings
        self._renders = frames
        self._conversation: Conversation | None = None
        self._scene: Scene | None = None
        self._reachable: tuple[Vector, ...] = ()

    def load(self, room: str) -> None:
        """Set the room as it is at load time, in a fresh process if there is none.

        Raises:
            UnknownName: when Unity has no such scene.
            WorldBroken: when Unity does not start.
        """
        self._scene, self._reachable = None, ()
        seconds = self._settings.start_seconds
        if self._conversation is None or self._conversation.over:
            from reibench.worlds.ai2thor.client import Client

            self._client = Client(self._variant, self._settings)
            self._conversation = Conversation(self._client)
            self._conversation.start(room, seconds)
            self._check_who_answers()
        else:
            self._ask("Reset", lambda client: client.reset(room), seconds)
        if self._renders:
            self._look_from_above()

    def act(self, action: str, **arguments: object) -> Outcome:
        """Carry out one AI2-THOR action; raises WorldBroken when Unity does not answer."""
        self._scene = None
        arguments["renderImage"] = self._renders
        return self._ask(action, lambda client: client.act(action, **arguments))

    def scene(self) -> Scene:
        """Report the room as it is now."""
        if self._scene is None:
            self._scene = scene_from_metadata(self._metadata)
        return self._scene

    def metadata(self) -> Mapping[str, Any]:
        """Report the room as AI2-THOR's metadata."""
        return self._metadata

    def sees(self, object_id: str) -> bool:
        """Whether the object is visible now."""
        things = self._metadata["objects"]
        return any(thing["visible"] for thing in things if thing["objectId"] == object_id)

    def reachable(self) -> Sequence[Vector]:
        """Return the free places of the floor grid when the room was first asked for them."""
        if not self._reachable:
            outcome = self.act("GetReachablePositions")
            places = self._metadata["actionReturn"]
            if not outcome.success or not places:
                raise InvalidRoom(f"Unity reports no place to stand: {outcome.message}.")
            self._reachable = tuple(Vector(each["x"], each["y"], each["z"]) for each in places)
        return self._reachable

    def frames(self) -> tuple[Frame, ...]:
        """Return what the cameras saw at the last action; nothing unless asked for at the start."""
        return self._client.frames() if self._renders else ()

    def close(self) -> None:
        """End the process, if one runs."""
        if self._conversation is not None:
            self._conversation.end()
            self._conversation = None

    @property
    def _metadata(self) -> dict[str, Any]:
        return self._client.metadata

    def _ask(self, doing: str, call: "Callable[[Client], T]", seconds: float | None = None) -> T:
        if self._conversation is None:
            raise RuntimeError("no room is loaded yet; call load first")
        limit = self._settings.step_seconds if seconds is None else seconds
        return self._conversation.ask(doing, lambda: call(self._client), limit)

    def _check_who_answers(self) -> None:
        """Refuse to take the stand-in for Unity, or the other way round."""
        answers, named = "standIn" in self._metadata, self._variant == STAND_IN
        if answers != named:
            self.close()
            who = "the wire stand-in" if answers else "no stand-in"
            raise WorldBroken(
                f"What answers is {who}, but the world is called 'ai2thor:{self._variant}';"
                " records would say the wrong thing."
            )

    def _look_from_above(self) -> None:
        """Hang a camera over the room; without one there are only frames of the robot's eye."""
        if not self.act("GetMapViewCameraProperties").success:
            return
        properties = self._metadata["actionReturn"]
        if isinstance(properties, dict):
            self.act("AddThirdPartyCamera", **properties)
