"""What commands print: results to stdout, progress to stderr."""

import json
import sys
from collections.abc import Sequence


def say(text: str = "") -> None:
    """Write a line of results to stdout."""
    sys.stdout.write(text + "\n")


def tell(text: str, *, end: str = "\n") -> None:
    """Write progress to stderr."""
    sys.stderr.write(text + end)
    sys.stderr.flush()


def say_json(value: object) -> None:
    """Write one JSON object to stdout."""
    say(json.dumps(value, ensure_ascii=False, indent=2))


def table(rows: Sequence[Sequence[object]], headers: Sequence[str]) -> str:
    """Return rows as an aligned text table."""
    texts = [[str(cell) for cell in row] for row in [headers, *rows]]
    widths = [max(map(len, column)) for column in zip(*texts, strict=True)]
    lines = ["  ".join(t.ljust(w) for t, w in zip(r, widths, strict=True)).rstrip() for r in texts]
    return "\n".join([lines[0], "  ".join("─" * width for width in widths), *lines[1:]])
