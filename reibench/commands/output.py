"""What commands print: results to stdout, progress to stderr."""

import json
import sys
from collections.abc import Mapping, Sequence
from math import isfinite


def say(text: str = "") -> None:
    """Write a line of results to stdout."""
    sys.stdout.write(text + "\n")


def tell(text: str, *, end: str = "\n") -> None:
    """Write progress to stderr."""
    sys.stderr.write(text + end)
    sys.stderr.flush()


def say_json(value: object) -> None:
    """Write one JSON object to stdout; a number that is none, e.g. of no interval, is null."""
    say(json.dumps(_countable(value), ensure_ascii=False, indent=2, allow_nan=False))


def _countable(value: object) -> object:
    """Return a value for JSON, which has no NaN and nothing infinite."""
    if isinstance(value, float) and not isfinite(value):
        return None
    if isinstance(value, Mapping):
        return {key: _countable(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [_countable(each) for each in value]
    return value


def table(rows: Sequence[Sequence[object]], headers: Sequence[str]) -> str:
    """Return rows as an aligned text table."""
    texts = [[str(cell) for cell in row] for row in [headers, *rows]]
    widths = [max(map(len, column)) for column in zip(*texts, strict=True)]
    lines = ["  ".join(t.ljust(w) for t, w in zip(r, widths, strict=True)).rstrip() for r in texts]
    return "\n".join([lines[0], "  ".join("─" * width for width in widths), *lines[1:]])
