"""Frames as files beside the database: `<database>-frames/<record>/<step>-<camera>.png`."""

import shutil
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import get_args

from reibench.worlds import Camera, Frame

CAMERAS: tuple[Camera, ...] = get_args(Camera)


@dataclass(frozen=True)
class FrameFolder:
    """All frames of one database; step 0 is the start."""

    database: Path

    def keep(self, record: str, step: int, frames: Iterable[Frame]) -> None:
        """Write what the cameras saw after a step; raises OSError."""
        for frame in frames:
            path = self._path(record, step, frame.camera)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(frame.png)

    def forget(self, record: str) -> None:
        """Remove a record's frames."""
        shutil.rmtree(self._folder(record), ignore_errors=True)

    def find(self, record: str, step: int, camera: Camera) -> Path | None:
        """Return the file of one frame, if there is one; `record` must be one of the store's."""
        path = self._path(record, step, camera)
        return path if path.is_file() else None

    def cameras(self, record: str, step: int) -> tuple[Camera, ...]:
        """Return the cameras whose frames after a step are kept."""
        return tuple(camera for camera in CAMERAS if self.find(record, step, camera))

    def _folder(self, record: str) -> Path:
        return self.database.with_name(f"{self.database.name}-frames") / record

    def _path(self, record: str, step: int, camera: Camera) -> Path:
        return self._folder(record) / f"{step}-{camera}.png"
