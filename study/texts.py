"""Texts that participants read, in Markdown files."""

import hashlib
from pathlib import Path

from reibench.errors import ReibenchError

FOLDER = Path(__file__).parents[1] / "assets" / "study"
"""Texts that come with the project."""


def read_text(name: str, beside: Path) -> str:
    """Return the text called `name`: a file beside the study's, else one of the shipped.

    Raises:
        ReibenchError: when there is no such file, or it is elsewhere.
    """
    for folder in (beside, FOLDER):
        path = (folder / name).resolve()
        if path.is_relative_to(folder.resolve()) and path.is_file():
            return path.read_text(encoding="utf-8").strip()
    raise ReibenchError(
        f"There is no text {name!r} beside the study or in {FOLDER}; name a Markdown file there."
    )


def fingerprint(text: str) -> str:
    """Return what tells a text from any other, 12 hex digits."""
    return hashlib.sha256(text.encode()).hexdigest()[:12]
