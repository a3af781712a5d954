"""Which Unity is behind the `ai2thor` world, and whether it can be had here."""

import ctypes.util
import os
import platform
import re
import shlex
import shutil
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from urllib.error import URLError
from urllib.request import Request, urlopen

from reibench.errors import WorldUnavailable
from reibench.worlds.ai2thor.settings import UnitySettings

STAND_IN = "stand-in"
PUBLISHED = "f0825767cd50d69f666c7f282e54abfe58f1e917"
"""The build that ai2thor 5.0.0 was published with."""
URL = "http://s3-us-west-2.amazonaws.com/ai2-thor-public/builds/{name}.zip"
RELEASES = "~/.ai2thor/releases"
"""Where the client keeps downloaded builds."""
OTHERWISE = (
    "Download it elsewhere and name the executable with REIBENCH_UNITY=PATH, or use the wire"
    " stand-in (--world ai2thor:stand-in), or the embedded world (--world embedded)."
)


def resolve(variant: str, environment: Mapping[str, str] = os.environ) -> str:
    """Return what is meant: `stand-in`, an absolute path, or the id of a published build."""
    chosen = variant or environment.get("REIBENCH_UNITY", "") or PUBLISHED
    if chosen == STAND_IN or is_build_id(chosen):
        return chosen
    return str(Path(chosen).expanduser().absolute())


def is_build_id(variant: str) -> bool:
    """Whether this is the id of a published build: a commit of AI2-THOR's repository."""
    return re.fullmatch(r"[0-9a-f]{40}", variant) is not None


def command_of(variant: str, settings: UnitySettings) -> str:
    """Return the command line of a resolved variant that is no published build."""
    if variant == STAND_IN:
        words = [sys.executable, "-m", "reibench.household.unity"]
    else:
        words = [str(executable_in(Path(variant)))]
    return " ".join([*map(shlex.quote, words), settings.arguments]).strip()


def executable_in(path: Path) -> Path:
    """Return the program, which may be named by the folder of its build."""
    inside = (path / path.name, path / f"{path.name}.app" / "Contents" / "MacOS" / path.name)
    return next((each for each in inside if path.is_dir() and each.is_file()), path)


def platform_for(settings: UnitySettings) -> str:
    """Return the platform of the published build to use here."""
    if settings.platform:
        return settings.platform
    if platform.system() == "Darwin":
        return "OSXIntel64"
    return "Linux64" if settings.display or os.environ.get("DISPLAY") else "CloudRendering"


@dataclass(frozen=True)
class Download:
    """What the first start of a published build has to fetch."""

    url: str
    size: int
    """Bytes; 0 if the server does not say."""
    folder: Path

    def __str__(self) -> str:
        size = f", {self.size / 1e6:,.0f} MB" if self.size else ""
        return f"Downloading AI2-THOR's build ({self.url}{size}) to {self.folder} …"


def check(variant: str, settings: UnitySettings) -> Download | None:
    """Return what has still to be downloaded before a resolved variant can start.

    Raises:
        WorldUnavailable: when it cannot start here, saying what to install and how.
    """
    if platform.system() not in ("Linux", "Darwin"):
        raise WorldUnavailable(
            f"AI2-THOR runs on Linux and macOS, and this is {platform.system()}: use the embedded"
            " world (--world embedded)."
        )
    if find_spec("ai2thor") is None:
        raise WorldUnavailable(
            "The package ai2thor is not installed: `pip install ai2thor==5.0.0`, or use the"
            " embedded world (--world embedded)."
        )
    if is_build_id(variant):
        return _check_published(variant, platform_for(settings))
    if variant != STAND_IN:
        _check_executable(executable_in(Path(variant)))
    return None


def _check_executable(path: Path) -> None:
    if not path.is_file():
        raise WorldUnavailable(
            f"There is no Unity executable {path}; --world ai2thor:PATH or REIBENCH_UNITY names one"
            " (a program, or the folder of an unpacked build), or is `stand-in`."
        )
    if shutil.which(path) is None:
        raise WorldUnavailable(f"{path} may not be executed: `chmod +x` it.")


def _check_published(build: str, platform_name: str) -> Download | None:
    if platform_name == "CloudRendering" and ctypes.util.find_library("vulkan") is None:
        raise WorldUnavailable(
            "AI2-THOR without a display (CloudRendering) needs the Vulkan library and a GPU:"
            " `apt-get install libvulkan1`, or start an X server and set DISPLAY, or use the wire"
            " stand-in (--world ai2thor:stand-in) or the embedded world (--world embedded)."
        )
    name = f"thor-{platform_name}-{build}"
    folder = Path(RELEASES).expanduser()
    if (folder / name).is_dir():
        return None
    url = URL.format(name=name)
    try:
        with urlopen(Request(url, method="HEAD"), timeout=10) as answer:
            return Download(url, int(answer.headers.get("Content-Length") or 0), folder)
    except (URLError, OSError, ValueError) as problem:
        why = getattr(problem, "reason", problem)
        raise WorldUnavailable(
            f"AI2-THOR's build cannot be downloaded ({url}: {why}). {OTHERWISE}"
        ) from None
