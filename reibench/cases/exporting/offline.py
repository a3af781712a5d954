"""A case as one HTML file that opens from disk: styles, scripts and every step inside."""

import re
from base64 import b64encode

from reibench.cases.case import Case
from reibench.cases.views.case_page import case_view
from reibench.cases.views.case_step import step_panel
from reibench.view.icons import ASSETS, sprite
from reibench.view.markup import element, text

_CSS, _JS = ASSETS / "web" / "css", ASSETS / "web" / "js"
_STYLES = ("tokens", "page", "plan", "made", "side_by_side", "cases")
_SCRIPTS = ("page", "plain_page", "cases")
_FONT = "inter-latin-wght-normal.woff2"
_MODULE = re.compile(r"^(?:import .*?;|export \{.*?\};)\n", re.MULTILINE)
_STEPS = """
window.reiSteps = (row, lane) =>
  document.getElementById(`step-${row}-${lane}`)?.innerHTML ?? null;
"""


def offline_page(case: Case, *, row: int, lane: int) -> str:
    """Return the page of a case; its steps work without a server or a network."""
    steps = [
        element("template", step_panel(case, at, of), id=f"step-{at}-{of}")
        for at in range(-1, len(case.rows))
        for of in range(len(case.runs))
    ]
    head = element(
        "head",
        element("meta", charset="utf-8"),
        element("meta", name="viewport", content="width=device-width,initial-scale=1"),
        element("title", text(f"{case.title} · REI-Bench")),
        element("style", _styles()),
    )
    shown = case_view(case, row=row, lane=lane)
    body = element(
        "body",
        sprite(),
        element("div", id="live", class_="sr", aria_live="polite", role="status"),
        element("main", shown, class_="cases one", id="content"),
        *steps,
        # what stands in a script must not end it
        element("script", f"{_STEPS}{_scripts()}".replace("</script", "<\\/script"), type="module"),
    )
    return "<!doctype html>" + element("html", head, body, lang="en", data_page="cases")


def _styles() -> str:
    sheets = ((_CSS / f"{name}.css").read_text(encoding="utf-8") for name in _STYLES)
    font = b64encode((ASSETS / "web" / "fonts" / _FONT).read_bytes()).decode()
    return "".join(sheets).replace(f"../fonts/{_FONT}", f"data:font/woff2;base64,{font}")


def _scripts() -> str:
    """Return the page's scripts as one, without what makes them modules of each other."""
    parts = ((_JS / f"{name}.js").read_text(encoding="utf-8") for name in _SCRIPTS)
    joined = "".join(_MODULE.sub("", part) for part in parts)
    return joined.replace("export ", "")
