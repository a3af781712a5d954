"""AI2-THOR's own client, unmodified, with handles to end it whatever it is doing."""

import io
import os
import queue
import shutil
import signal
import subprocess
import sys
import warnings
from contextlib import suppress
from pathlib import Path
from typing import Any

from ai2thor.controller import Controller
from ai2thor.fifo_server import FifoServer
from ai2thor.platform import CloudRendering
from ai2thor.wsgi_server import WsgiServer
from PIL import Image

from reibench.errors import unknown
from reibench.household.controller import MISUSE
from reibench.worlds import Frame
from reibench.worlds.ai2thor.builds import command_of, is_build_id, platform_for
from reibench.worlds.ai2thor.settings import UnitySettings
from reibench.worlds.simulator import Outcome

LAUNCHER = Path(__file__).with_name("launcher.py")
LIBRARY = Path(__file__).parents[3]
NEVER = 1e6
"""Seconds the client itself waits at a start; the watchdog is done long before."""
END_OF_MESSAGE = b"\xff\0\0\0\0"
SERVERS = {"fifo": FifoServer, "wsgi": WsgiServer}


class Ended:
    """Stands where the server of a client was that is over: the client ends it again at exit."""

    def stop(self) -> None:
        """Do nothing."""


class Client(Controller):  # type: ignore[misc]
    """A `Controller` that is made first and started later, so that its start can be watched."""

    def __init__(self, variant: str, settings: UnitySettings) -> None:
        """Prepare for a resolved variant; `super().__init__`, which starts it, is for `open`."""
        self._variant = variant
        self._settings = settings
        self._wire: Any = None
        self._begun = self._over = False
        # It says so, but `start` does not let it.
        warnings.filterwarnings("ignore", message="Restarting unity due to crash")

    # talking

    def open(self, room: str) -> None:
        """Start Unity and load a room; raises UnknownName for one that Unity lacks."""
        super().__init__(**self._source(), scene=room, **self._options())

    def download(self) -> None:
        """Fetch the published build, if it is not here yet."""
        super().__init__(**self._source(), download_only=True, **self._options())

    def reset(self, scene: str | None = None, **parameters: object) -> Any:
        """Load a room; raises UnknownName."""
        if isinstance(scene, str):
            known = self.scenes_in_build
            if known and self.normalize_scene(scene) not in known:
                raise unknown(
                    "scene in AI2-THOR's build",
                    scene,
                    sorted(name.removesuffix("_physics") for name in known),
                )
        return super().reset(scene, **parameters)

    def act(self, action: str, **arguments: object) -> Outcome:
        """Carry out an action; what Unity refuses, also as misuse, is an outcome."""
        try:
            self.step(action, **arguments)
        except ValueError:
            # The client raises where Unity says an action or an argument is not as it should be.
            if self.metadata.get("lastActionSuccess") or self.metadata["errorCode"] not in MISUSE:
                raise
        found = self.metadata
        if found["lastActionSuccess"]:
            return Outcome(success=True)
        return Outcome(False, found.get("errorMessage") or "", found.get("errorCode") or "")

    @property
    def metadata(self) -> dict[str, Any]:
        """Unity's last report."""
        event: Any = self.last_event
        found: dict[str, Any] = event.metadata
        return found

    def frames(self) -> tuple[Frame, ...]:
        """Return the images that came with the last report."""
        event: Any = self.last_event
        eye = () if event.frame is None else (Frame("robot", _png(event.frame)),)
        return (*eye, *(Frame("above", _png(image)) for image in event.third_party_camera_frames))

    # ending

    @property
    def process(self) -> "subprocess.Popen[bytes] | None":
        """Unity's process, once it runs."""
        return self._wire.unity_proc if self._wire is not None else None

    def kill(self) -> None:
        """End Unity's process and all it has started, at once."""
        self._over = True
        process = self.process
        if process is None:
            return
        with suppress(OSError):
            os.killpg(process.pid, signal.SIGKILL)
        process.kill()
        with suppress(subprocess.TimeoutExpired):
            process.wait(timeout=5)

    def unblock(self) -> None:
        """Free the client's thread if it waits at a pipe that nobody will open any more."""
        for path, way in (
            (getattr(self._wire, "server_pipe_path", ""), os.O_WRONLY),
            (getattr(self._wire, "client_pipe_path", ""), os.O_RDONLY),
        ):
            with suppress(OSError):
                pipe = os.open(path, way | os.O_NONBLOCK)
                if way == os.O_WRONLY:
                    # At a pipe's mere end the client would spin; at this it gives up.
                    with suppress(OSError):
                        os.write(pipe, END_OF_MESSAGE * 100)
                os.close(pipe)

    def forget_pipes(self) -> None:
        """Remove the folder of the pipes, which both sides have open now."""
        if hasattr(self._wire, "tmp_dir"):
            self._wire.tmp_dir.cleanup()

    def release(self) -> None:
        """Remove what the client leaves: pipes, their folder, its web server, its locks."""
        wire, self._wire = self._wire, None
        self.server = Ended()
        self.last_event = None
        if wire is None:
            return
        for pipe in filter(None, (getattr(wire, p, None) for p in ("client_pipe", "server_pipe"))):
            with suppress(OSError):
                pipe.close()
        if isinstance(wire, WsgiServer):
            _close_web_server(wire)
        else:
            wire.tmp_dir.cleanup()
        if wire.unity_proc is not None:
            self._build.unlock()

    # what the client asks itself

    def start(self, *arguments: object, **options: object) -> Any:
        """Start Unity, once: the client would start a crashed one again behind our back."""
        if self._begun:
            raise RuntimeError("a crashed Unity is not started again by the client")
        self._begun = True
        return super().start(*arguments, **options)

    def _build_server(self, *arguments: object, **options: object) -> None:
        super()._build_server(*arguments, **options)
        self._wire = self.server

    def unity_command(self, width: int, height: int, headless: bool) -> list[str]:
        """Return the command line that starts Unity, through our launcher."""
        if self._over:
            raise RuntimeError("the start was called off")
        tools = shutil.which("vulkaninfo") and shutil.which("nvidia-smi")
        if self._build.platform is not CloudRendering or not tools:
            # CUDA_VISIBLE_DEVICES is about models here; the client would fail without these tools.
            self.gpu_device = None
        command: list[str] = super().unity_command(width, height, headless)
        isolated = [sys.executable, "-I", "-S"]
        return [*isolated, str(LAUNCHER), str(os.getpid()), str(LIBRARY), *command]

    def _source(self) -> dict[str, object]:
        if is_build_id(self._variant):
            return {"commit_id": self._variant, "platform": platform_for(self._settings)}
        return {"local_executable_path": command_of(self._variant, self._settings)}

    def _options(self) -> dict[str, object]:
        settings = self._settings
        display = settings.display or os.environ.get("DISPLAY", "")
        if not display and not is_build_id(self._variant):
            display = ":0"  # The client fails without any, needed or not.
        return {
            "server_class": SERVERS[settings.server],
            "width": settings.width,
            "height": settings.height,
            "x_display": display or None,
            # Without a limit of its own the client sees at once that a pipe has ended.
            "server_timeout": None,
            "server_start_timeout": NEVER,
            "gridSize": 0.25,
            "visibilityDistance": 1.5,
        }


def _png(image: Any) -> bytes:
    written = io.BytesIO()
    Image.fromarray(image).save(written, "PNG", compress_level=3)
    return written.getvalue()


def _close_web_server(server: Any) -> None:
    """End the client's web server; its own `stop` leaves a thread and a port behind."""
    with suppress(queue.Full):
        server.response_queue.put_nowait({})
    if server.started:
        server.wsgi_server.shutdown()
        server.server_thread.join(timeout=5)
    server.wsgi_server.server_close()
