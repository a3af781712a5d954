"""Icons: which symbol shows an object, and the symbols themselves, sent once a page."""

import csv
import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Literal

from reibench.scene import SceneObject
from reibench.view.markup import element

ASSETS = Path(__file__).parents[2] / "assets"
DrawnAs = Literal["icon", "silhouette", "front", "wall", "hidden"]
_OPEN_ICONS = {"Book": "open-book"}
_LIT_ICONS = {"DeskLamp": "g-desklamp-on"}
_STROKES = {
    "open": "M3.5 8.5l5-5M5 3.500h3.500V7",
    "on": "M6 2.800v3.400M3.900 4.300a3 3 0 1 0 4.200 0",
    "hot": "M4 9.500c-1.500-2 1-2.500 0-5M7.500 9.500c-1.500-2 1-2.500 0-5",
    "cold": "M6 2.500v7M3 4.250l6 3.500M9 4.250l-6 3.500",
    "dirty": "M3.500 5h.01M6.500 4h.01M8.300 6.500h.01M5 8h.01M7.500 8.800h.01",
    "sliced": "M3.600 8.800V3.200M6 8.800V3.200M8.400 8.800V3.200",
    "cooked": "M3 6.200l2.200 2.300L9.200 3.800",
    "filled": "M6 2.700c1.800 2.300 2.500 3.300 2.500 4.300a2.500 2.500 0 0 1-5 0c0-1 .7-2 2.5-4.3",
    "broken": "M6.800 2.400L4.600 5.400l2.600 1.500-2 2.700",
    "no": "M3.500 3.500l5 5M8.500 3.500l-5 5",
}


@dataclass(frozen=True)
class Appearance:
    """How objects of one type are drawn on a floor plan."""

    drawn_as: DrawnAs
    icon: str = ""
    """Id of a symbol of the sprite; empty unless drawn as an icon."""


@lru_cache(maxsize=1)
def _table() -> dict[str, Appearance]:
    with (ASSETS / "icons" / "objects.csv").open(encoding="utf-8", newline="") as file:
        return {
            row["object_type"]: Appearance(row["drawn_as"], row["icon"])  # type: ignore[arg-type]
            for row in csv.DictReader(file)
        }


def appearance(thing: SceneObject) -> Appearance:
    """Return how `thing` is drawn; one of an unlisted type is an icon with its initials."""
    known = _table().get(thing.type)
    if known is None:
        return Appearance("icon" if thing.pickupable else "silhouette")
    return known


def icon(thing: SceneObject) -> str:
    """Return the id of the symbol that shows `thing` in its state; empty if there is none."""
    if thing.open and thing.type in _OPEN_ICONS:
        return _OPEN_ICONS[thing.type]
    if thing.on and thing.type in _LIT_ICONS:
        return _LIT_ICONS[thing.type]
    return appearance(thing).icon


def icon_of_type(object_type: str) -> str:
    """Return the id of the symbol for a type; empty if there is none."""
    known = _table().get(object_type)
    return known.icon if known else ""


def inline(symbol: str, size: int = 15) -> str:
    """Return a small picture of `symbol` for a line of text."""
    if not symbol:
        return ""
    use = element("use", href=f"#{symbol}")
    return element("svg", use, width=size, height=size, viewbox="0 0 32 32", aria_hidden="true")


def mark(symbol: str) -> str:
    """Return the mark of a state or outcome, e.g. `cooked`, as a picture of 12 by 12."""
    use = element("use", href=f"#b-{symbol}")
    return element("svg", use, viewbox="0 0 12 12", aria_hidden="true")


@lru_cache(maxsize=1)
def sprite() -> str:
    """Return a hidden picture with every symbol a page can use."""
    icons = ASSETS / "icons"
    fluent = json.loads((icons / "fluent.json").read_text(encoding="utf-8"))
    drawn = json.loads((icons / "glyphs.json").read_text(encoding="utf-8"))
    bodies = {**fluent, **{f"g-{name}": body for name, body in drawn.items()}}
    symbols = [
        element("symbol", body, id=name, viewbox="0 0 32 32") for name, body in bodies.items()
    ]
    symbols += [
        element("symbol", _stroke(path), id=f"b-{name}", viewbox="0 0 12 12")
        for name, path in _STROKES.items()
    ]
    return element("svg", *symbols, width=0, height=0, class_="sprite", aria_hidden="true")


def _stroke(path: str) -> str:
    return element(
        "g",
        element("path", d=path),
        fill="none",
        stroke="currentColor",
        stroke_width="1.5",
        stroke_linecap="round",
        stroke_linejoin="round",
    )
