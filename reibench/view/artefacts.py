"""What methods and planners made on their way, folded so that a long one is no burden."""

from collections.abc import Iterable

from reibench.artefact import Artefact
from reibench.view.markup import element, text


def artefacts_html(artefacts: Iterable[Artefact]) -> str:
    """Return `artefacts` in order: notes in plain sight, everything else folded."""
    return "".join(map(_artefact, artefacts))


def folded(title: str, content: str, *, class_: str = "") -> str:
    """Return `content` as it was written, behind its title."""
    return element(
        "details",
        element("summary", text(title)),
        element("pre", text(content)),
        class_=f"artefact {class_}".strip(),
    )


def _artefact(artefact: Artefact) -> str:
    if artefact.kind != "note":
        return folded(artefact.title, artefact.text, class_=artefact.kind)
    title = element("b", text(artefact.title))
    return element("p", title, " ", text(artefact.text), class_="artefact note small")
