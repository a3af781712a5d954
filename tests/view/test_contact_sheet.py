"""The contact sheet: every room, in one file that stands alone."""

import re

import pytest

from reibench.__main__ import main
from reibench.household import Controller, load_room
from reibench.view.contact_sheet import Exhibit, contact_sheet
from reibench.view.plan import floor_plan
from reibench.view.plan_geometry import PHONE, WIDE, Canvas, bands
from reibench.view.plan_layout import lay_out
from reibench.view.room_list import room_list


@pytest.fixture
def sheet(rooms):
    kinds = {name: load_room(name).kind for name in rooms}
    return contact_sheet([Exhibit(kinds[name], scene) for name, scene in rooms.items()])


def test_it_shows_each_room_with_its_name_size_and_number_of_objects(sheet, rooms, tags):
    plans = [each for each in tags(sheet, "svg") if "plan" in (each.get("class") or "")]
    assert len(plans) == len(rooms)
    for scene in rooms.values():
        size = scene.bounds.size
        assert f"{size.x:.1f} × {size.z:.1f} m · {len(scene.objects)} objects" in sheet
    assert "Living room 1" in sheet


def test_it_is_grouped_by_kind(sheet, rooms):
    headings = re.findall(r"<h2>(\d+) ([a-z ]+?)s?</h2>", sheet)
    assert [kind for _, kind in headings] == ["kitchen", "living room", "bedroom", "bathroom"]
    assert sum(int(count) for count, _ in headings) == len(rooms)


def test_it_loads_nothing_and_every_link_leads_somewhere(sheet, tags):
    outside = re.findall(r"""(?:src|href)=["'](?!#)[^"']*|url\((?!data:|#)[^)]*""", sheet)
    assert not outside
    assert "<script" not in sheet
    ids = {each.get("id") for each in tags(sheet)}
    links = {each["href"][1:] for each in tags(sheet, "a", "use")}
    assert links <= ids


def test_it_is_dark_where_the_reader_prefers_dark(sheet):
    assert "@media (prefers-color-scheme:dark){:root{" in sheet
    style = sheet.split("<style>")[1].split("</style>")[0]
    assert style.count("{") == style.count("}")


def test_the_command_writes_the_rooms_asked_for(tmp_path, capsys):
    out = tmp_path / "rooms.html"
    assert main(["view", "rooms", "--out", str(out), "--rooms", "bed*-[12],kitchen-2"]) == 0
    assert "3 rooms" in capsys.readouterr().out
    assert out.read_text().count('class="card"') == 3
    assert main(["view", "rooms", "--out", str(out), "--rooms", "kichen-2"]) == 2
    assert "Did you mean 'kitchen-2'" in capsys.readouterr().err


def test_every_real_room_is_drawn_and_listed(real_rooms, tags):
    for name in real_rooms:
        scene = Controller(name).snapshot()
        layout = lay_out(scene, PHONE)
        assert tags(floor_plan(scene, layout))
        assert tags(room_list(scene))
        for spot in layout.spots.values():
            assert layout.canvas.floor.grown(1).contains(spot.x, spot.y), name


def test_the_fullest_real_kitchen_can_be_read(real_rooms):
    scene = Controller("FloorPlan30").snapshot()
    assert len(scene.objects) == 90
    spots = list(lay_out(scene, WIDE).spots.values())
    for number, one in enumerate(spots):
        for other in spots[number + 1 :]:
            if not (one.carrier or other.carrier):
                apart = ((one.x - other.x) ** 2 + (one.y - other.y) ** 2) ** 0.5
                assert apart > 0.8 * (one.radius + other.radius)


def test_an_open_fridge_shows_what_it_holds_and_the_list_tells_it(real_rooms):
    controller = Controller("FloorPlan30")
    fridge = controller.snapshot().of_type("Fridge")[0]
    assert fridge.contents
    controller.step("OpenObject", objectId=fridge.id, forceAction=True)
    scene = controller.snapshot()
    drawing, listed = floor_plan(scene), room_list(scene)
    assert "in the fridge" in drawing
    for name in fridge.contents:
        kind = scene.by_id[name].type
        assert f'data-type="{kind}"' in drawing
        assert kind.lower() in listed.lower()


def test_a_counter_around_a_corner_leaves_the_floor_in_the_corner_free(real_rooms):
    scene = Controller("FloorPlan8").snapshot()
    canvas = Canvas.fit(scene, WIDE)
    counter = max(scene.of_type("CounterTop"), key=lambda each: each.box.size.x * each.box.size.z)
    parts = bands(counter, scene, canvas)
    x, y = canvas.point(*counter.box.center[::2])
    assert len(parts) > 1
    assert not any(part.contains(x, y) for part in parts)
