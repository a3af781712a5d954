"""Markup is safe whatever it is made of."""

import json

from reibench.view.icons import ASSETS, appearance, icon_of_type, sprite
from reibench.view.markup import element, number, text


def test_text_and_attributes_are_escaped():
    assert text("<b>") == "&lt;b&gt;"
    assert element("p", title='a "b" <c>') == '<p title="a &quot;b&quot; &lt;c&gt;"></p>'


def test_absent_attributes_are_left_out_and_bare_ones_written_bare():
    assert element("input", checked=True, disabled=False, value=None) == "<input checked>"
    assert element("label", for_="x", class_="y") == '<label for="x" class="y"></label>'


def test_numbers_are_short():
    assert (number(12.04), number(3.14159)) == ("12", "3.1")


def test_every_object_type_has_an_appearance_and_every_icon_a_symbol(rooms):
    symbols = sprite()
    for scene in rooms.values():
        for thing in scene.objects:
            shown = appearance(thing)
            if shown.drawn_as == "icon":
                assert f'id="{shown.icon}"' in symbols, thing.type


def test_only_symbols_that_are_used_are_shipped():
    table = (ASSETS / "icons" / "objects.csv").read_text()
    code = "".join(path.read_text() for path in (ASSETS.parent / "reibench" / "view").glob("*.py"))
    for name in json.loads((ASSETS / "icons" / "fluent.json").read_text()):
        assert f",{name}" in table or name in code, name
    assert icon_of_type("Tomato") == "tomato"
    assert (ASSETS / "icons" / "LICENSE-fluent-emoji.txt").exists()
