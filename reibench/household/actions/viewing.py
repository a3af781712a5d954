"""What concerns the build and its cameras: scenes, resolution, third-party cameras."""

import re
from dataclasses import replace
from typing import Any

from reibench.household.actions import Refused, action, vector
from reibench.household.cameras import FIELD_OF_VIEW, Camera
from reibench.household.scenes import scene_names
from reibench.household.state import State
from reibench.scene import Vector

COLOR = re.compile(r"#([0-9a-fA-F]{3,4}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})")
COLOR_NAMES = frozenset(
    "red cyan blue darkblue lightblue purple yellow lime fuchsia white silver grey black orange"
    " brown maroon green olive navy teal aqua magenta".split()
)
"""HTML colours that Unity knows by name."""


@action("GetScenesInBuild", changes=False)
def get_scenes_in_build(state: State) -> list[str]:
    """Return the names of all rooms."""
    return list(scene_names())


@action("ChangeResolution", changes=False)
def change_resolution(state: State, x: int, y: int) -> None:
    """Make frames that wide and high, in pixels."""
    if x <= 0 or y <= 0:
        raise Refused("width and height must be positive")
    state.settings = replace(state.settings, screen=(x, y))
    state.forget_moment()


@action("ChangeQuality", changes=False)
def change_quality(state: State, quality: str) -> None:
    """Take any: there is one."""


@action("GetMapViewCameraProperties", changes=False)
def get_map_view_camera_properties(state: State) -> dict[str, Any]:
    """Return the arguments of a third-party camera that looks down on the whole room."""
    (x, y, z), (width, height, depth) = state.room.bounds
    return {
        "position": {"x": x, "y": y + height / 2, "z": z},
        "rotation": {"x": 90.0, "y": 0.0, "z": 0.0},
        "orthographicSize": max(width, depth) / 2,
        "orthographic": True,
    }


@action("AddThirdPartyCamera", changes=False)
def add_third_party_camera(  # noqa: PLR0913 - the arguments are AI2-THOR's
    state: State,
    position: dict[str, float],
    rotation: dict[str, float],
    fieldOfView: float = FIELD_OF_VIEW,
    skyboxColor: str | None = None,
    orthographic: bool = False,
    orthographicSize: float | None = None,
    nearClippingPlane: float | None = None,
    farClippingPlane: float | None = None,
    antiAliasing: str = "none",
) -> None:
    """Hang up a camera."""
    bare = Camera(Vector(*vector(position)), Vector(*vector(rotation)))
    planes = nearClippingPlane, farClippingPlane
    camera = _changed(bare, fieldOfView, skyboxColor, orthographic, orthographicSize, planes)
    state.cameras = (*state.cameras, camera)
    state.forget_moment()


@action("UpdateThirdPartyCamera", changes=False)
def update_third_party_camera(  # noqa: PLR0913
    state: State,
    thirdPartyCameraId: int = 0,
    position: dict[str, float] | None = None,
    rotation: dict[str, float] | None = None,
    fieldOfView: float | None = None,
    skyboxColor: str | None = None,
    orthographic: bool | None = None,
    orthographicSize: float | None = None,
    nearClippingPlane: float | None = None,
    farClippingPlane: float | None = None,
) -> None:
    """Change a camera; what is left out stays as it is."""
    count = len(state.cameras)
    if not 0 <= thirdPartyCameraId < count:
        raise Refused(
            f"ArgumentOutOfRangeException: thirdPartyCameraId: {thirdPartyCameraId} (int:"
            f" default=0) must in 0 <= thirdPartyCameraId < len(thirdPartyCameras)={count}."
        )
    old = state.cameras[thirdPartyCameraId]
    hung = replace(
        old,
        position=Vector(**(old.position._asdict() | _floats(position))),
        rotation=Vector(**(old.rotation._asdict() | _floats(rotation))),
    )
    planes = nearClippingPlane, farClippingPlane
    fov = old.field_of_view if fieldOfView is None else fieldOfView
    camera = _changed(hung, fov, skyboxColor, orthographic, orthographicSize, planes)
    before, after = state.cameras[:thirdPartyCameraId], state.cameras[thirdPartyCameraId + 1 :]
    state.cameras = (*before, camera, *after)
    state.forget_moment()


def _changed(
    camera: Camera,
    field_of_view: float,
    skybox: str | None,
    orthographic: bool | None,
    size: float | None,
    planes: tuple[float | None, float | None],
) -> Camera:
    if not 0 < field_of_view < 180:
        raise Refused(
            f"ArgumentOutOfRangeException: fieldOfView: {field_of_view} must be in 0 < fieldOfView"
            " < 180."
        )
    if size is not None and not orthographic:
        raise Refused(
            f"InvalidOperationException: orthographicSize(: {size}) can only be set when"
            " orthographic=True.\nOtherwise, we use assume perspective camera setting."
            "Hint: call .step(..., orthographic=True)."
        )
    if skybox not in (None, "default") and not _is_color(skybox or ""):
        raise Refused(
            f"ArgumentException: Invalid skyboxColor: {skybox}! Cannot be parsed as an HTML color."
        )
    near, far = planes
    return replace(
        camera,
        field_of_view=float(field_of_view),
        skybox=camera.skybox if skybox is None else skybox,
        orthographic=camera.orthographic if orthographic is None else orthographic,
        orthographic_size=camera.orthographic_size if size is None else float(size),
        near=Camera.near if near is None else float(near),
        far=Camera.far if far is None else float(far),
    )


def _is_color(text: str) -> bool:
    return text.lower() in COLOR_NAMES or COLOR.fullmatch(text) is not None


def _floats(given: dict[str, float] | None) -> dict[str, float]:
    """Return what is given of a vector."""
    found = given or {}
    return {axis: float(found[axis]) for axis in ("x", "y", "z") if axis in found}
