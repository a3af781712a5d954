"""The floor plan shows every room, and moves only what a step moved."""

import json
import math
from dataclasses import replace
from xml.etree import ElementTree

import pytest

from reibench.household import room_names, scene_from_metadata
from reibench.scene import CONTAINERS
from reibench.view.plan import floor_plan, legend
from reibench.view.plan_geometry import ASIDE, PHONE, WIDE
from reibench.view.plan_layout import arrange, lay_out

SVG = "{http://www.w3.org/2000/svg}"


def drawn_names(svg):
    root = ElementTree.fromstring(svg)
    return [g.attrib["data-name"] for g in root.iter("g") if "data-name" in g.attrib]


def overlaps(layout):
    spots = [spot for spot in layout.spots.values() if not spot.carrier]
    return [
        (one, other)
        for index, one in enumerate(spots)
        for other in spots[index + 1 :]
        if gap(one, other) < 0
    ]


def gap(one, other):
    """Return the pixels between two things; negative where they overlap."""
    return math.dist((one.x, one.y), (other.x, other.y)) - one.radius - other.radius


@pytest.mark.parametrize("size", [WIDE, PHONE, ASIDE], ids=lambda size: size.name)
@pytest.mark.parametrize("room", room_names())
def test_every_shipped_room_is_drawn_within_its_walls_and_no_thing_hides_another(rooms, room, size):
    layout = lay_out(rooms[room], size)
    assert not overlaps(layout)
    # A rounding error wide is within.
    assert layout.canvas.width <= size.width + 1e-6
    assert layout.canvas.height <= size.height + 1e-6
    for spot in layout.spots.values():
        assert layout.canvas.floor.grown(1).contains(spot.x, spot.y)
    ElementTree.fromstring(floor_plan(rooms[room], layout))


def test_real_rooms_of_every_kind_are_drawn_without_things_hiding_each_other(shared_data):
    for number in (1, 8, 30, 204, 230, 310, 329, 409, 424, 430):
        path = shared_data / "ithor" / f"FloorPlan{number}_physics.json"
        if not path.exists():
            continue
        objects = list(json.loads(path.read_text()).values())
        scene = scene_from_metadata(
            {
                "sceneName": f"FloorPlan{number}",
                "objects": objects,
                "agent": {
                    "position": {"x": 0.0, "y": 0.9, "z": 0.0},
                    "rotation": {"x": 0.0, "y": 0.0, "z": 0.0},
                    "cameraHorizon": 0.0,
                    "isStanding": True,
                },
                "inventoryObjects": [],
            }
        )
        layout = lay_out(scene, WIDE)
        assert not overlaps(layout), number
        ElementTree.fromstring(floor_plan(scene, layout))


def test_what_is_inside_something_closed_is_nowhere_on_the_plan(kitchen):
    hidden = [t for t in kitchen.objects if kitchen.closed_around(t) and t.type != "Floor"]
    assert hidden
    svg = floor_plan(kitchen)
    kinds = {thing.type for thing in kitchen.objects if not kitchen.closed_around(thing)}
    for thing in hidden:
        if thing.type not in kinds:
            assert f'data-type="{thing.type}"' not in svg


def test_an_open_container_shows_what_it_holds_in_a_tray(kitchen):
    full = next(t for t in kitchen.objects if t.type in CONTAINERS and t.contents)
    things = tuple(replace(t, open=True) if t is full else t for t in kitchen.objects)
    svg = floor_plan(replace(kitchen, objects=things))
    assert 'class="tray"' in svg
    for key in full.contents:
        kind = kitchen.by_id[key].type
        assert f'class="thing kept {kind.lower()}"' in svg


def test_the_layout_depends_on_nothing_but_the_scene(kitchen):
    again = replace(kitchen)
    lay_out.cache_clear()
    first = lay_out(kitchen, WIDE)
    lay_out.cache_clear()
    assert lay_out(again, WIDE) == first


def test_a_step_moves_only_what_it_moved(episode, click, solution):
    rollout = click(episode, *solution)
    scenes = [rollout.first_event.scene, *(step.event.scene for step in rollout.steps)]
    before = arrange(scenes[:1], WIDE)
    for count in range(2, len(scenes) + 1):
        after = arrange(scenes[:count], WIDE)
        for key, spot in after.spots.items():
            old, new = scenes[count - 2].by_id[key], scenes[count - 1].by_id[key]
            stayed = (old.parents, old.position) == (new.parents, new.position)
            if stayed and key in before.spots:
                assert (spot.x, spot.y) == (before.spots[key].x, before.spots[key].y)
        before = after


def test_the_robot_shows_what_it_holds(episode, click, solution):
    picked = solution.index("pick up the potato") + 1
    scene = click(episode, *solution[:picked]).last_event.scene
    svg = floor_plan(scene)
    assert 'aria-label="robot, holding potato"' in svg
    assert scene.held.id not in lay_out(scene, WIDE).spots


def test_the_page_never_carries_the_simulator_s_object_ids(kitchen):
    svg = floor_plan(kitchen)
    assert "|" not in svg
    assert not any(thing.id in svg for thing in kitchen.objects)


def test_the_legend_lists_only_the_states_that_are_there(kitchen):
    plain = tuple(
        replace(t, dirty=False, on=False, open=False, temperature="RoomTemp", sliced=False)
        for t in kitchen.objects
    )
    quiet = replace(kitchen, objects=plain)
    layout = lay_out(quiet, WIDE)
    for state in ("dirty", "open", "sliced", "hot"):
        assert f">{state}<" not in legend(quiet, layout)
    soiled = replace(quiet, objects=tuple(replace(t, dirty=t.type == "Mug") for t in quiet.objects))
    assert ">dirty<" in legend(soiled, layout)


def test_slices_of_one_thing_are_drawn_as_one_with_their_number(kitchen):
    apple = next(t for t in kitchen.objects if t.type == "Apple")
    open_place = next(t.id for t in kitchen.objects if t.type == "CounterTop")
    slices = tuple(
        replace(
            apple,
            id=f"{apple.id}|AppleSliced_{number}",
            type="AppleSliced",
            parents=(open_place,),
        )
        for number in range(4)
    )
    rest = tuple(t for t in kitchen.objects if t is not apple)
    scene = replace(kitchen, objects=rest + slices)
    assert drawn_names(floor_plan(scene)).count("sliced apple, 4 pieces") == 1


def test_a_thing_in_another_is_fanned_out_and_stays_visible(kitchen):
    mug = next(t for t in kitchen.objects if t.type == "Mug")
    counter = next(t.id for t in kitchen.objects if t.type == "CounterTop")
    spoon = next(t for t in kitchen.objects if t.type in ("Spoon", "Fork"))
    things = tuple(
        replace(t, parents=(counter,))
        if t is mug
        else replace(t, parents=(mug.id, counter))
        if t is spoon
        else t
        for t in kitchen.objects
    )
    layout = lay_out(replace(kitchen, objects=things), WIDE)
    inner, outer = layout.spots[spoon.id], layout.spots[mug.id]
    assert inner.carrier == mug.id
    assert math.dist((inner.x, inner.y), (outer.x, outer.y)) > outer.radius / 2
