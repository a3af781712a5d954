"""The pictures beside the floor plan: their addresses, their words, and whose they are."""

from dataclasses import replace

import pytest

from reibench.view.cameras import camera_strip
from reibench.view.room_panel import room_panel
from reibench.watching import Sitting


@pytest.fixture
def sitting(click, episode):
    rollout = click(episode, "find a potato", "pick up the potato")
    return Sitting(
        id="abc",
        visitor="ann",
        episode=episode,
        actor="person",
        start=rollout.first_event,
        steps=tuple(rollout.steps),
        max_steps=30,
        status=None,
        world="ai2thor:stand-in",
        cameras=("robot", "above"),
    )


def test_each_picture_has_its_address_and_words_for_those_who_do_not_see_it(sitting):
    strip = camera_strip(sitting)
    assert 'src="/frames/abc/2-robot.png"' in strip
    assert 'src="/frames/abc/2-above.png"' in strip
    assert 'alt="What the robot sees after step 2: ' in strip
    assert 'src="/frames/abc/0-robot.png"' in camera_strip(sitting, step=0)
    assert "at the start: " in camera_strip(sitting, step=0)


def test_only_pictures_of_the_stand_in_are_called_protocol_verified(sitting):
    assert "protocol-verified stand-in" in camera_strip(sitting)
    assert "protocol-verified" not in camera_strip(replace(sitting, world="ai2thor:/opt/thor"))


def test_without_pictures_the_room_is_as_it_was(sitting):
    scene = sitting.event.scene
    assert camera_strip(replace(sitting, cameras=())) == ""
    assert "Camera" not in room_panel([scene])
    assert "Camera" in room_panel([scene], cameras=camera_strip(sitting))
