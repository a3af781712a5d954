"""The room as the page shows it: plan for wide and narrow screens, list, legend."""

from collections.abc import Sequence

from reibench.scene import Scene
from reibench.view.icons import icon, inline
from reibench.view.markup import element, text
from reibench.view.plan import floor_plan, legend
from reibench.view.plan_geometry import PHONE, WIDE
from reibench.view.plan_layout import arrange
from reibench.view.room_list import room_list
from reibench.view.topbar import room_name
from reibench.view.words import a, states


def room_panel(
    scenes: Sequence[Scene], *, live: bool = True, cameras: str = "", called: str = ""
) -> str:
    """Return the room after the last of `scenes`; the earlier ones decide what stays where.

    Args:
        scenes: the room at the start and after each step.
        live: whether things can be acted on.
        cameras: what cameras see, as markup; nothing where none are.
        called: what to call the room instead of by its name.
    """
    scene = scenes[-1]
    layout = arrange(scenes, WIDE)
    label = f"{called or room_name(scene.room)}, seen from above"
    wide = element("div", floor_plan(scene, layout, label=label), class_="wide-plan")
    small = floor_plan(scene, arrange(scenes, PHONE), label=label)
    narrow = element("div", small, class_="phone-plan")
    box = element("div", wide, narrow, class_="planbox")
    listed = element("div", room_list(scene), class_="roomlist")
    return element(
        "section",
        _header(scene, pictured=bool(cameras)),
        element("div", box, listed, class_="roomwrap"),
        cameras,
        element("div", class_="surface", aria_label="Things beside each other"),
        legend(scene, layout),
        class_="room live" if live else "room",
        aria_label="Room",
    )


def _header(scene: Scene, *, pictured: bool) -> str:
    ways = ("Plan", "List", "Camera") if pictured else ("Plan", "List")
    plan_or_list = element(
        "div",
        *(_tab(way) for way in ways),
        class_="seg sm",
        role="tablist",
        aria_label="How the room is shown",
    )
    return element(
        "header",
        element("h2", "Room"),
        held_chip(scene),
        element("span", class_="grow"),
        plan_or_list,
        element(
            "button",
            "Names <kbd>N</kbd>",
            type="button",
            class_="btn sm hide-m",
            data_do="names",
            aria_pressed="false",
        ),
        _zoom("+", "zoom-in", "Zoom in"),
        _zoom("−", "zoom-out", "Zoom out"),
    )


def _tab(way: str) -> str:
    # On narrow screens the pictures are under the plan anyway.
    hidden = "hide-m" if way == "Camera" else None
    return element("button", way, type="button", role="tab", data_room=way.lower(), class_=hidden)


def _zoom(sign: str, what: str, words: str) -> str:
    return element(
        "button", sign, type="button", class_="btn sm icon zoom", data_do=what, aria_label=words
    )


def held_chip(scene: Scene) -> str:
    """Return what the robot holds, as a chip; nothing if its hand is empty."""
    held = scene.held
    if held is None:
        return ""
    state = "".join(f", {each}" for each in states(held))
    words = element("span", text(f"holding {a(held.type)}{state}"))
    return element("span", inline(icon(held)), words, class_="chip holding")


def room_loading() -> str:
    """Return the outline of a room that is being set up."""
    bars = "".join(element("i", class_=f"bone b{number}") for number in (1, 2, 3))
    outline = element("div", bars, class_="planbox bones", aria_hidden="true")
    waiting = element("p", "Setting up the room …", class_="muted small")
    return element(
        "section",
        element("header", element("h2", "Room")),
        element("div", outline, waiting, class_="roomwrap"),
        class_="room",
        aria_label="Room",
        aria_busy="true",
    )
