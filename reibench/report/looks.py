"""How figures look: colours, hatches and markers.

Colours are those of the pages (`assets/web/css/tokens.css`); hatches and lightness tell bars apart
without them.
"""

from typing import Any

from reibench.published import MODEL

INK, LABEL, LINE, PLAIN, ACCENT = "#1d2126", "#4c535c", "#dedbd4", "#868d97", "#2f5bd7"
LOOK: Any = {
    "font.family": ["DejaVu Sans"],
    "font.size": 9,
    "axes.edgecolor": LINE,
    "axes.labelcolor": LABEL,
    "axes.titlesize": 10,
    "axes.titleweight": "bold",
    "axes.titlecolor": INK,
    "axes.titlelocation": "left",
    "xtick.color": LABEL,
    "xtick.labelsize": 7.5,
    "ytick.color": LABEL,
    "text.color": INK,
    "hatch.linewidth": 0.7,
    "hatch.color": INK,
    # the same scores give the same file
    "svg.hashsalt": "reibench",
}
METHOD_LOOKS = {
    "none": (PLAIN, ""),
    "ap": ("#f6e6bd", ""),
    "gated-ap": ("#f6e6bd", "////"),
    "cot": ("#d9a441", "...."),
    "short-cot": ("#d9a441", "////"),
    "segmented-cot": ("#d9a441", "xxxx"),
    "icl": ("#dfe3e8", "||||"),
    "tocc": (ACCENT, ""),
    "tocc-span": ("#a9bdf5", "\\\\\\\\"),
    "tocc-taught": ("#a9bdf5", "...."),
    "no-context": ("#f0eeea", "----"),
    "people": (INK, ""),
}
"""Fill and hatch of each method, and of people."""
OTHER_LOOK = ("#f0eeea", "oo")
MARKERS = {MODEL: "D", "GPT-4o-mini": "o", "Deepseek-8B": "s"}
"""The paper's models, hollow."""
