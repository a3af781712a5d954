"""The list of studies."""

from collections.abc import Mapping, Sequence
from typing import Any

from reibench.view.markup import element, text
from study.researchers.frame import ago, link, page, pill, section, table


def studies(found: Sequence[Mapping[str, Any]]) -> str:
    """Return the list of studies, each with its state and people."""
    if not found:
        how = element("code", "python -m study create assets/study/study.toml")
        none = element("p", "There is no study yet. Make one with ", how, class_="note")
        return page("Studies", [], none)
    rows = [
        [
            link(f"/admin/{one['name']}", one["name"]),
            pill(one["state"]),
            str(one["active"]),
            str(one["finished"]),
            str(one["simulated"]),
            element("code", text(one["version"])),
            ago(one["created"]),
        ]
        for one in found
    ]
    heads = (
        "study", "state", "taking part #", "finished #", "simulated #", "version", "created",
    )  # fmt: skip
    return page("Studies", [], section("Studies", table(heads, rows, "Studies")))
