"""What the cameras of a world that renders see, beside the floor plan."""

from reibench.scene import Scene
from reibench.view.markup import element, text
from reibench.view.words import name
from reibench.watching import Sitting
from reibench.worlds import Camera
from reibench.worlds.naming import verified

TITLES: dict[Camera, str] = {"robot": "Robot's eye", "above": "From above"}
NAMED = 8
"""Things named for those who do not see the picture."""
STAND_IN = (
    "AI2-THOR's own client over its wire protocol; the embedded simulator stands in for Unity."
)


def camera_strip(sitting: Sitting, step: int | None = None) -> str:
    """Return the pictures after a step, the last one by default; nothing if none are kept."""
    if not sitting.cameras:
        return ""
    at = len(sitting.steps) if step is None else step
    scene = (sitting.steps[at - 1].event if at else sitting.start).scene
    note = verified(sitting.world)
    label = element("p", f"{note} stand-in", class_="chip xs", title=STAND_IN) if note else ""
    pictures = [_picture(sitting.id, at, camera, scene) for camera in sitting.cameras]
    return element("div", *pictures, label, class_="cameras")


def _picture(record: str, step: int, camera: Camera, scene: Scene) -> str:
    image = element(
        "img",
        src=f"/frames/{record}/{step}-{camera}.png",
        alt=_in_words(step, camera, scene),
        decoding="async",
    )
    caption = element("figcaption", text(TITLES[camera]))
    return element("figure", image, caption)


def _in_words(step: int, camera: Camera, scene: Scene) -> str:
    when = f"after step {step}" if step else "at the start"
    if camera == "above":
        return f"The room from above {when}; the floor plan shows the same."
    seen = [thing for thing in scene.objects if thing.id in scene.visible and not thing.held]
    seen.sort(key=lambda thing: not thing.pickupable)  # floors and worktops say little
    names = list(dict.fromkeys(name(thing.type) for thing in seen))
    more = f" and {len(names) - NAMED} more" if len(names) > NAMED else ""
    things = f"{', '.join(names[:NAMED])}{more}" if names else "nothing in reach"
    return f"What the robot sees {when}: {things}."
