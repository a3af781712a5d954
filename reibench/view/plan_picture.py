"""A floor plan as a picture of its own: styles resolved and symbols inside."""

import re
from collections.abc import Collection
from functools import lru_cache

from reibench.scene import Scene
from reibench.view.icons import ASSETS, sprite
from reibench.view.plan import floor_plan
from reibench.view.plan_layout import Layout

FONT = '"Inter Variable",Inter,"DejaVu Sans",sans-serif'
_VARIABLE = re.compile(r"var\((--[\w-]+)\)")
_SYMBOL = re.compile(r'<symbol [^>]*?id="([^"]+)".*?</symbol>', re.DOTALL)
_USED = re.compile(r'href="#([^"]+)"')
_BLOCK = re.compile(r"@media[^{]*\{(?:[^{}]*\{[^{}]*\})*[^{}]*\}", re.DOTALL)
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)


def plan_picture(scene: Scene, layout: Layout, *, focus: Collection[str] = ()) -> str:
    """Return the room as an SVG document, in the light colours."""
    drawn = floor_plan(scene, layout, focus=focus)
    used = set(_USED.findall(drawn))
    symbols = "".join(body for name, body in _symbols().items() if name in used)
    opening, rest = drawn.split(">", 1)
    opening = opening.replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ', 1)
    return f"{opening}><style>{_style()}</style><defs>{symbols}</defs>{rest}"


@lru_cache(maxsize=1)
def _symbols() -> dict[str, str]:
    return {found[1]: found[0] for found in _SYMBOL.finditer(sprite())}


@lru_cache(maxsize=1)
def _style() -> str:
    """Return the plan's styles without what only a browser knows: nesting, variables, hovering."""
    css = ASSETS / "web" / "css"
    tokens = (css / "tokens.css").read_text(encoding="utf-8").split("[data-theme=dark]")[0]
    values = dict(re.findall(r"(--[\w-]+):([^;}]+)", tokens)) | {"--sans": FONT}
    plan = _BLOCK.sub("", _COMMENT.sub("", (css / "plan.css").read_text(encoding="utf-8")))
    inner = plan.split(":root{", 1)[1].rpartition("}")[0]
    rules = re.findall(r"([^{}]+)\{([^{}]*)\}", inner)
    kept = [
        f"{selector.strip()}{{{_VARIABLE.sub(lambda found: values[found[1]], body)}}}"
        for selector, body in rules
        if "&" not in selector and ":" not in selector.replace(":not(.spot)", "")
    ]
    return "".join([*kept, ".names{display:none}"])
