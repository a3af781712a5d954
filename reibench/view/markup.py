"""Writing HTML and SVG: one function for an element, one for text."""

from html import escape
from typing import TypeAlias

Value: TypeAlias = str | float | int | bool | None
_VOID = frozenset(
    ("br", "circle", "ellipse", "img", "input", "link", "meta", "path", "rect", "use")
)
_SVG_VOID = frozenset(("circle", "ellipse", "path", "rect", "use"))


def text(content: object) -> str:
    """Return `content` as text that is safe between tags and in attributes."""
    return escape(str(content), quote=True)


def number(value: float) -> str:
    """Return `value` to a tenth, without a needless `.0`."""
    return f"{value:.1f}".removesuffix(".0")


def element(name: str, /, *children: str, **attributes: Value) -> str:
    """Return one element; `children` are markup, attribute values are escaped here.

    `class_` and `for_` lose their underscore, other underscores become hyphens. False and None
    leave an attribute out, True writes it bare.
    """
    written = "".join(_attribute(key, value) for key, value in attributes.items())
    if name in _VOID:
        return f"<{name}{written}/>" if name in _SVG_VOID else f"<{name}{written}>"
    return f"<{name}{written}>{''.join(children)}</{name}>"


def _attribute(key: str, value: Value) -> str:
    if value is None or value is False:
        return ""
    name = key.rstrip("_").replace("_", "-")
    if name == "viewbox":
        name = "viewBox"
    if value is True:
        return f" {name}"
    return f' {name}="{number(value) if isinstance(value, float) else text(value)}"'


def classes(*names: str, **conditional: bool) -> str:
    """Return a class list: `names`, and those of `conditional` that are true."""
    return " ".join([*filter(None, names), *(name for name, on in conditional.items() if on)])
