"""Reading a study's TOML file and the texts it names."""

import tomllib
from pathlib import Path

from reibench.errors import ReibenchError, unknown
from study.checking import check
from study.config import Study, from_entries
from study.texts import read_text


def read_study(path: Path) -> Study:
    """Read a study's file and the texts it names.

    Raises:
        ReibenchError: saying what is wrong and what would be right.
    """
    try:
        entries = tomllib.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise ReibenchError(f"There is no study file {path}.") from None
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as problem:
        raise ReibenchError(f"The study {path} cannot be read as TOML: {problem}.") from None
    names = {"consent": "consent.md", "tutorial": "tutorial.md", "debrief": "debrief.md"}
    names |= entries.get("texts", {})
    if odd := set(names) - {"consent", "tutorial", "debrief"}:
        raise unknown("text of a study", min(odd), ("consent", "tutorial", "debrief"))
    entries["texts"] = {what: read_text(name, path.parent) for what, name in names.items()}
    study = from_entries(entries)
    check(study)
    return study
