"""The room in words says the same as the plan, for those who cannot see it."""

from dataclasses import replace

from reibench.household import room_names
from reibench.scene import CONTAINERS
from reibench.view.room_list import room_list


def test_every_room_reads_as_nested_lists(rooms, tags):
    for name in room_names():
        buttons = tags(room_list(rooms[name]), "button")
        assert all(button["aria-label"] for button in buttons)


def test_what_is_in_something_closed_is_not_told(kitchen):
    full = next(t for t in kitchen.objects if t.type in CONTAINERS and t.contents)
    inside = kitchen.by_id[full.contents[0]]
    alone = len(kitchen.of_type(inside.type)) == 1
    assert alone
    assert f'data-type="{inside.type}"' not in room_list(kitchen)
    things = tuple(replace(t, open=True) if t is full else t for t in kitchen.objects)
    assert f'data-type="{inside.type}"' in room_list(replace(kitchen, objects=things))


def test_what_the_robot_holds_is_in_its_hand(episode, click, solution):
    picked = solution.index("pick up the potato") + 1
    scene = click(episode, *solution[:picked]).last_event.scene
    markup = room_list(scene)
    assert "in the robot&#x27;s hand" in markup or "in the robot's hand" in markup


def test_a_row_of_closed_drawers_is_told_once(kitchen):
    markup = room_list(kitchen)
    assert markup.count('data-type="Drawer"') < len(kitchen.of_type("Drawer"))
