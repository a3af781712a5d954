"""What stands in the head of every page: theme, styles and scripts, all served from here."""

STYLES = ("tokens", "page", "plan", "side_by_side", "made", "phone")
THEME = """<script>
(() => {
  let kept = "";
  try { kept = JSON.parse(localStorage.getItem("reibench-settings") || "{}").theme } catch {}
  const dark = matchMedia("(prefers-color-scheme:dark)").matches;
  document.documentElement.dataset.theme = kept || (dark ? "dark" : "light");
})();
</script>"""
"""Set before the first paint, so that nothing flashes."""


def head(script: str = "main", *styles: str) -> str:
    """Return the head of a page with this script, and these styles after those of all pages."""
    return "\n".join(
        [
            THEME,
            *(f'<link rel="stylesheet" href="/web/css/{name}.css">' for name in (*STYLES, *styles)),
            f'<script type="module" src="/web/js/{script}.js"></script>',
        ]
    )


HEAD = head()
