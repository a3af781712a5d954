"""Tags and the note of an episode, to be read or changed."""

from collections.abc import Sequence

from reibench.cases.keeping import LONGEST_NOTE
from reibench.view.markup import element, text


def kept_view(runs: str, tags: Sequence[str], note: str, *, back: str, may_change: bool) -> str:
    """Return an episode's tags and note; nothing where there are none and nobody may add some.

    Args:
        runs: ids of the case's runs, as the address has them.
        tags: the episode's tags.
        note: what is noted about it; empty for whoever may not read it.
        back: the address to return to.
        may_change: whether whoever reads this may change them.
    """
    shown = [element("span", text(tag), class_="chip tag") for tag in tags]
    said = element("span", text(note), class_="said") if note else ""
    if not may_change:
        return element("div", *shown, said, class_="kept") if shown or said else ""
    fields = [
        element("input", type="hidden", name="runs", value=runs),
        element("input", type="hidden", name="back", value=back),
        element(
            "label", "Tags, with commas",
            element("input", type="text", name="tags", value=", ".join(tags), maxlength=400),
            element("small", "Seen by everybody.", class_="muted"),
        ),
        element(
            "label", "Note",
            element("textarea", text(note), name="note", rows=2, maxlength=LONGEST_NOTE),
            element("small", "Seen by researchers only, and in no export.", class_="muted"),
        ),
        element("button", "Keep", class_="btn sm primary"),
    ]  # fmt: skip
    form = element("form", *fields, method="post", action="/cases/keep", class_="keepform")
    words = "Tags and note" if shown or said else "Add a tag or a note"
    return element(
        "details",
        element("summary", text(words), " ", *shown, said),
        form,
        class_="kept",
    )
