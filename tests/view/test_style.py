"""Text can be read on every surface it stands on, light and dark."""

import re

import pytest

from reibench.view.icons import ASSETS

CSS = (ASSETS / "web" / "css" / "tokens.css").read_text()
PAIRS = [
    *((ink, surface) for ink in ("ink", "ink-2", "ink-3") for surface in ("bg", "panel", "sunk")),
    ("accent-ink", "accent"),
    ("accent-text", "accent-soft"),
    ("accent-text", "panel"),
    ("ink", "accent-soft"),
    ("ink-2", "accent-soft"),
    ("ink", "mark"),
    ("warn", "mark"),
    *((tone, f"{tone}-soft") for tone in ("good", "bad", "warn")),
    *((tone, "panel") for tone in ("good", "bad", "warn")),
    ("bad", "accent-soft"),
    ("plan-label", "plan-app"),
    ("plan-label", "plan-counter"),
    ("plan-label", "plan-inset"),
]


def tokens(theme):
    light = dict(re.findall(r"--([\w-]+):(#[0-9a-f]{6})", CSS.split("[data-theme=dark]")[0]))
    dark = dict(re.findall(r"--([\w-]+):(#[0-9a-f]{6})", CSS.split("[data-theme=dark]")[1]))
    return light if theme == "light" else {**light, **dark}


def luminance(colour):
    channels = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one, other):
    lighter, darker = sorted((luminance(one), luminance(other)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_text_has_enough_contrast_on_every_surface(theme):
    colour = tokens(theme)
    weak = {
        (ink, surface): round(contrast(colour[ink], colour[surface]), 2)
        for ink, surface in PAIRS
        if contrast(colour[ink], colour[surface]) < 4.5
    }
    assert weak == {}


def test_motion_stops_for_those_who_asked_for_less():
    page = (ASSETS / "web" / "css" / "page.css").read_text()
    assert "prefers-reduced-motion:reduce" in page


def test_style_and_scripts_ask_nobody_else_for_anything():
    for path in (ASSETS / "web").rglob("*"):
        if path.suffix in (".css", ".js"):
            addresses = re.findall(r"https?://[^\s'\")]+", path.read_text())
            assert set(addresses) <= {"http://www.w3.org/2000/svg"}, path.name
