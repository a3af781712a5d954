"""Packing: metadata as bytes, what an object looks like on the wire kept while it is the same.

All but three of an object's forty-odd values stay as they are while the robot walks about.
"""

import json
from collections.abc import Callable, Mapping, Sequence
from struct import Struct
from typing import Any, Protocol

from reibench.household.controller import Event
from reibench.household.metadata import distance_between, object_metadata
from reibench.household.state import Moment
from reibench.scene import SceneObject

MOVING = ("visible", "isInteractable", "distance")
"""What changes as the robot moves; these keys stand side by side in an object's metadata."""
STAND_IN = "reibench.household.unity"
"""What the metadata say under `standIn`, a key which Unity's lack."""


class Format(Protocol):
    """How metadata are written."""

    def pairs(self, mapping: Mapping[str, Any]) -> bytes:
        """Write the inside of a mapping."""
        ...

    def mapping(self, size: int, *insides: bytes) -> bytes:
        """Write a mapping of `size` pairs, given written parts of its inside."""
        ...

    def sequence(self, items: Sequence[bytes]) -> bytes:
        """Write a list, given its written items."""
        ...

    def entry(self, key: str, value: bytes) -> bytes:
        """Write a pair, given its written value."""
        ...

    def moving(self, *, seen: bool, distance: float) -> bytes:
        """Write the pairs of `MOVING`."""
        ...


class JsonFormat:
    """The WSGI protocol's."""

    def pairs(self, mapping: Mapping[str, Any]) -> bytes:
        """Write the inside of a mapping."""
        return json.dumps(mapping, separators=(",", ":"))[1:-1].encode()

    def mapping(self, size: int, *insides: bytes) -> bytes:
        """Write a mapping."""
        return b"{" + b",".join(insides) + b"}"

    def sequence(self, items: Sequence[bytes]) -> bytes:
        """Write a list."""
        return b"[" + b",".join(items) + b"]"

    def entry(self, key: str, value: bytes) -> bytes:
        """Write a pair."""
        return f'"{key}":'.encode() + value

    def moving(self, *, seen: bool, distance: float) -> bytes:
        """Write the pairs of `MOVING`."""
        word = "true" if seen else "false"
        text = f'"visible":{word},"isInteractable":{word},"distance":{distance!r}'
        return text.encode()


class MessagePackFormat:
    """The FIFO protocol's."""

    def __init__(self) -> None:
        import msgpack

        self._pack: Callable[[Any], bytes] = msgpack.Packer().pack
        *keys, last = (self._pack(key) for key in MOVING)
        self._seen: bytes = b"".join(key + self._pack(True) for key in keys) + last
        self._unseen: bytes = b"".join(key + self._pack(False) for key in keys) + last
        self._number = Struct("!Bd").pack

    def pairs(self, mapping: Mapping[str, Any]) -> bytes:
        """Write the inside of a mapping."""
        pack = self._pack
        return b"".join([pack(part) for pair in mapping.items() for part in pair])

    def mapping(self, size: int, *insides: bytes) -> bytes:
        """Write a mapping."""
        return Struct("!BH").pack(0xDE, size) + b"".join(insides)

    def sequence(self, items: Sequence[bytes]) -> bytes:
        """Write a list."""
        return Struct("!BI").pack(0xDD, len(items)) + b"".join(items)

    def entry(self, key: str, value: bytes) -> bytes:
        """Write a pair."""
        return bytes(self._pack(key)) + value

    def moving(self, *, seen: bool, distance: float) -> bytes:
        """Write the pairs of `MOVING`."""
        return (self._seen if seen else self._unseen) + self._number(0xCB, distance)


class Packer:
    """Writes events in one format."""

    def __init__(self, form: Format) -> None:
        self._form = form
        self._known: dict[str, tuple[SceneObject, float | None, int, bytes, bytes]] = {}

    def pack(self, event: Event, number: int) -> bytes:
        """Return the metadata of `event`, the answer to the request of that number."""
        form = self._form
        agent = event.bare_metadata() | {"standIn": STAND_IN}
        objects = form.entry("objects", form.sequence(self._objects(event.moment)))
        described = form.mapping(len(agent) + 1, objects, form.pairs(agent))
        around = {
            "sequenceId": number,
            "activeAgentId": 0,
            "thirdPartyCameras": agent["thirdPartyCameras"],
        }
        agents = form.entry("agents", form.sequence([described]))
        return form.mapping(len(around) + 1, agents, form.pairs(around))

    def _objects(self, moment: Moment) -> list[bytes]:
        form, known, openness = self._form, self._known, moment.openness
        visible, here = moment.scene.visible, moment.agent.position
        packed = []
        for name, thing in moment.objects.items():
            kept = known.get(name)
            # An object is replaced, never changed, so the same one reads the same.
            if kept is None or kept[0] is not thing or kept[1] != openness.get(name):
                kept = known[name] = self._describe(moment, thing)
            _, _, size, head, tail = kept
            seen, distance = name in visible, distance_between(thing.position, here)
            packed.append(form.mapping(size, head, form.moving(seen=seen, distance=distance), tail))
        return packed

    def _describe(
        self, moment: Moment, thing: SceneObject
    ) -> tuple[SceneObject, float | None, int, bytes, bytes]:
        described = list(object_metadata(moment, thing).items())
        place = [key for key, _ in described].index(MOVING[0])
        head, tail = dict(described[:place]), dict(described[place + len(MOVING) :])
        openness = moment.openness.get(thing.id)
        form = self._form
        return thing, openness, len(described), form.pairs(head), form.pairs(tail)
