"""How tables are written in LaTeX, in the shape the paper's have."""

from collections.abc import Iterable

import pandas as pd

NEEDS = "% needs \\usepackage{booktabs,graphicx,makecell,multirow}"
NO_EPISODES = "--"
SCALED = "\\scalebox{0.85}"
SPECIAL = {character: f"\\{character}" for character in "&%$#_{}"} | {
    "\\": "\\textbackslash{}",
    "~": "\\textasciitilde{}",
    "^": "\\textasciicircum{}",
}
TO_THE_WIDTH = "\\resizebox{\\textwidth}{!}"


def escaped(text: str) -> str:
    """Return text with what LaTeX would read as its own."""
    return "".join(SPECIAL.get(character, character) for character in text)


def row(*cells: str) -> str:
    """Return a row of a table."""
    return " & ".join(cells) + " \\\\"


def table(caption: str, label: str, columns: str, body: Iterable[str], fit: str = "") -> str:
    """Return a table that spans the page.

    Args:
        caption: in LaTeX.
        label: after `tab:`.
        columns: their alignment.
        body: rows and rules.
        fit: how it is scaled; to the width of the page, or as the paper does unless said.
    """
    return "\n".join(
        (
            "\\begin{table*}[htbp]",
            f"\\caption{{{caption}}}",
            "\\begin{center}",
            f"{fit or SCALED}{{%",
            f"\\begin{{tabular}}{{{columns}}}",
            *body,
            "\\end{tabular}",
            "}",
            "\\end{center}",
            f"\\label{{tab:{label}}}",
            "\\end{table*}",
        )
    )


def counted(records: pd.DataFrame) -> str:
    """Say in a caption what the rates are of, and what they do not show."""
    finished = records[records["status"].notna()]
    sizes = finished.groupby(["run", "level"]).size()
    each = f"{sizes.min()}" if sizes.min() == sizes.max() else f"{sizes.min()}--{sizes.max()}"
    noun = "episode" if each == "1" else "episodes"
    said = [f"{each} {noun} in each cell." if len(sizes) else "No episode is finished."]
    solved = finished[finished["status"] == "success"]
    if unsaid := int((solved["said_done"] == 0).sum()):
        said.append(f"Of {len(solved)} episodes that count as solved, {unsaid} were not said done.")
    if broken := int((finished["status"] == "error").sum()):
        said.append(f"{broken} episodes broke down and are in the overall rate only.")
    return " ".join(said)
