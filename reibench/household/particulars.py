"""Particulars: what AI2-THOR reports of single objects and no rule of this simulator reads."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from reibench.household.objects import ObjectType
from reibench.scene import SceneObject, Vector


@dataclass(frozen=True)
class Particulars:
    """What a real object has of its own, beside its `SceneObject`.

    The tilt, the oriented box and the order of parents hold while the object is where the room
    has it; the rest holds always.
    """

    asset: str = ""
    """AI2-THOR's `assetId`: which model it is."""
    mass: float = 0.0
    """Kilograms."""
    materials: tuple[str, ...] | None = None
    tilt: tuple[float, float] = (0.0, 0.0)
    """Degrees about x and z."""
    corners: tuple[Vector, ...] = ()
    """The eight corners of the oriented box; none where AI2-THOR reports none."""
    parents: tuple[str, ...] = ()
    """The parents in AI2-THOR's order; empty where it is that of the object."""


def usual(kind: ObjectType, thing: SceneObject) -> Particulars:
    """Return the particulars of an object that has none of its own: those of its type."""
    loose = thing.pickupable or thing.moveable
    return Particulars(mass=kind.mass, materials=kind.materials if loose else None)


def read(entry: Mapping[str, Any]) -> Particulars | None:
    """Read the particulars out of an object's entry in a room file; None if it has none."""
    if "mass" not in entry:
        return None
    materials = entry.get("materials")
    flat = iter(map(float, entry.get("corners", ())))
    return Particulars(
        asset=str(entry.get("asset", "")),
        mass=float(entry["mass"]),
        materials=None if materials is None else tuple(map(str, materials)),
        tilt=_pair(entry.get("tilt", (0.0, 0.0))),
        corners=tuple(Vector(*each) for each in zip(flat, flat, flat, strict=True)),
        parents=tuple(entry.get("order", ())),
    )


def describe(own: Particulars) -> dict[str, Any]:
    """Return the part of a room file's entry that `read` reads."""
    entry: dict[str, Any] = {"mass": own.mass}
    if own.asset:
        entry["asset"] = own.asset
    if own.materials is not None:
        entry["materials"] = list(own.materials)
    if any(own.tilt):
        entry["tilt"] = list(own.tilt)
    if own.corners:
        entry["corners"] = [number for corner in own.corners for number in corner]
    if own.parents:
        entry["order"] = list(own.parents)
    return entry


def _pair(numbers: Iterable[Any]) -> tuple[float, float]:
    x, z = map(float, numbers)
    return x, z
