"""The contact sheet: every room as a floor plan, grouped by kind, in one file that stands alone."""

from base64 import b64encode
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from reibench.scene import Scene
from reibench.view.icons import ASSETS, sprite
from reibench.view.markup import element, text
from reibench.view.plan import floor_plan
from reibench.view.plan_geometry import PHONE
from reibench.view.topbar import room_name, room_size

KINDS = ("kitchen", "living room", "bedroom", "bathroom")
_FONT = "../fonts/inter-latin-wght-normal.woff2"


@dataclass(frozen=True)
class Exhibit:
    """A room on the sheet."""

    kind: str
    scene: Scene


def contact_sheet(exhibits: Sequence[Exhibit]) -> str:
    """Return a whole HTML page, light or dark as the reader's system is, that loads nothing."""
    groups = {kind: [each.scene for each in exhibits if each.kind == kind] for kind in KINDS}
    others = [each.scene for each in exhibits if each.kind not in KINDS]
    shown = {kind: scenes for kind, scenes in (groups | {"room": others}).items() if scenes}
    objects = sum(len(each.scene.objects) for each in exhibits)
    title = _count(len(exhibits), "room")
    head = element(
        "head",
        element("meta", charset="utf-8"),
        element("meta", name="viewport", content="width=device-width,initial-scale=1"),
        element("title", title),
        element("style", _style()),
    )
    top = element(
        "header",
        element("h1", title),
        element("p", f"{objects:,} objects"),
        element("nav", *(_link(kind, len(scenes)) for kind, scenes in shown.items())),
        class_="sheethead",
    )
    sections = [_section(kind, scenes) for kind, scenes in shown.items()]
    body = element("body", sprite(), top, element("main", *sections), class_="sheet", id="top")
    return "<!doctype html>" + element("html", head, body, lang="en")


def _section(kind: str, scenes: Iterable[Scene]) -> str:
    cards = [_card(scene) for scene in scenes]
    heading = element("h2", _count(len(cards), kind))
    return element("section", heading, element("div", *cards, class_="cards"), id=_anchor(kind))


def _card(scene: Scene) -> str:
    """Return one room; following its link fills the window with it."""
    name = room_name(scene.room)
    caption = element(
        "figcaption", element("strong", text(name)), element("span", room_size(scene))
    )
    plan = floor_plan(scene, size=PHONE, label=f"{name}, seen from above")
    larger = element("a", "", href=f"#{scene.room}", class_="larger", aria_label=f"enlarge {name}")
    smaller = element("a", "×", href=f"#at-{scene.room}", class_="smaller", aria_label="close")
    anchor = element("span", id=f"at-{scene.room}")
    return element(
        "div",
        anchor,
        element("figure", plan, caption, larger, smaller, id=scene.room),
        class_="card",
    )


def _link(kind: str, count: int) -> str:
    return element("a", _count(count, kind), href=f"#{_anchor(kind)}")


def _anchor(kind: str) -> str:
    return f"{kind.replace(' ', '-')}s"


def _count(count: int, what: str) -> str:
    return f"{count} {what}{'' if count == 1 else 's'}"


def _style() -> str:
    """Return the styles in one piece: font inside, dark by the reader's preference."""
    css, fonts = ASSETS / "web" / "css", ASSETS / "web" / "fonts"
    tokens, plan, sheet = (
        (css / f"{name}.css").read_text(encoding="utf-8") for name in ("tokens", "plan", "sheet")
    )
    font = b64encode((fonts / _FONT.rpartition("/")[2]).read_bytes()).decode()
    light, dark = tokens.replace(_FONT, f"data:font/woff2;base64,{font}").split("[data-theme=dark]")
    return f"{light}@media (prefers-color-scheme:dark){{:root{dark}}}{plan}{sheet}"
